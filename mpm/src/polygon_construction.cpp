#include "polygon_construction.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh_construction.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/mpm/polygon_fill.hpp"
#include "settle/mpm/spaces.hpp"
#include "solid_layer.hpp"
#include "valley_construction.hpp"

namespace settle::mpm {
namespace {

/// Lengths in case files have a few digits: an extent that is a multiple of the element up to this counts as one.
constexpr double relative_slack = 1e-6;

exchange::PlanePoint plane_point(const Vector<2>& x) {
  return {x[0], x[1]};
}

/// Is anything held all along this end of the extent in this direction?
bool held_at(const exchange::Case& study, double end, std::size_t axis, double slack) {
  return std::any_of(study.supports.begin(), study.supports.end(), [&](const exchange::Support& support) {
    return std::abs(support.from[axis] - end) <= slack && std::abs(support.to[axis] - end) <= slack;
  });
}

/// Around the polygons and the supports: material may move along a support beyond where it was placed.
exchange::PlaneBox extent_with_supports(const exchange::Case& study) {
  exchange::PlaneBox box = exchange::bounding_box(study.geometry);
  for (const exchange::Support& support : study.supports)
    for (const auto& end : {support.from, support.to})
      for (std::size_t axis = 0; axis < 2; ++axis) {
        box.lowest[axis] = std::min(box.lowest[axis], end[axis]);
        box.highest[axis] = std::max(box.highest[axis], end[axis]);
      }
  return box;
}

/// Is the node on the support or beyond it?
bool stands_for(const exchange::Support& support, const Vector<2>& node, double size) {
  const double length = std::hypot(support.to[0] - support.from[0], support.to[1] - support.from[1]);
  const double past_ends = std::sqrt(2.0) * size / length;
  const double share = exchange::share_along(support, plane_point(node));
  return exchange::height_above(support, plane_point(node)) <= relative_slack * size && share >= -past_ends &&
         share <= 1.0 + past_ends;
}

/// Calls `action` with each node, direction and support that holds it, of a mesh in space.
template <class Space, class Action>
void for_each_held_in_mesh(const exchange::Case& study, const Space& space, Action&& action) {
  const MeshHolds holds(*study.geometry.mesh, space.size());
  for (int node = 0; node < space.n_nodes(); ++node)
    for (int axis = 0; axis < 3; ++axis)
      if (const int boundary = holds.boundary_at(space.node_position(node), axis); boundary >= 0)
        action(node, axis, study.supports[static_cast<std::size_t>(boundary)]);
}

template <int dim>
bool is_held_by_valley(const exchange::Case& study, const Vector<dim>& node, double size) {
  if constexpr (dim == 3)
    if (study.geometry.valley) return is_beyond_flanks(*study.geometry.valley, node, size);
  return false;
}

/// Calls `action` with each node, direction and support that holds it. The flanks of a valley are part of its base.
template <class Space, class Action>
void for_each_held(const exchange::Case& study, const Space& space, Action&& action) {
  if constexpr (Space::dim == 3)
    if (study.geometry.solid_mesh()) return for_each_held_in_mesh(study, space, action);
  for (int node = 0; node < space.n_nodes(); ++node)
    for (const exchange::Support& support : study.supports) {
      const auto position = space.node_position(node);
      if (!is_held_by_valley<Space::dim>(study, position, space.size()) &&
          !stands_for(support, in_section<Space::dim>(position), space.size()))
        continue;
      if (support.held != exchange::Held::y) action(node, 0, support);
      if (Space::dim == 3 && support.held == exchange::Held::both) action(node, 1, support);
      if (support.held != exchange::Held::x) action(node, Space::dim - 1, support);
    }
}

/// As the case has them: those of a section, or all three.
std::vector<double> coordinates_of(const exchange::Case& study, const Place& place) {
  if (study.geometry.varies_along_y()) return {place[0], place[1], place[2]};
  return {place[0], place[2]};
}

/// `ratio`: of the volume as placed to that as drawn.
[[noreturn]] void refuse_inverted(const exchange::Case& study, int layer, const Place& place, double ratio) {
  throw exchange::InputError(
      {.where = study.where("construction.convention"),
       .what = fmt::format("layer {} has no room where ({:.4g}) is drawn: what lies below has folded, or stands "
                           "above the level of the layer",
                           layer, fmt::join(coordinates_of(study, place), ", ")),
       .given = fmt::format("convention = \"{}\", {:.3g} times the volume as drawn",
                            exchange::name_of(study.construction.convention), ratio),
       .allowed = "a settled surface below the layer's level, without folds",
       .remedy = "use construction.convention = \"float\", thicker layers, or a stiffer material"});
}

/// A point to be placed, without position and volume.
template <class Space>
NewPoint<Space::dim> point_of(const exchange::Case& study, int layer, const Body<Space>& body) {
  return {.layer = layer,
          .density = study.material_of(layer).density,
          .preconsolidation_pressure = body.preconsolidation_of(layer)};
}

/// Rows of points along y of a section, or the section itself.
template <class Space>
void place_section(const exchange::Case& study, int layer, const PresentLayers<Space::dim>& below, Design& design,
                   Body<Space>& body) {
  constexpr int dim = Space::dim;
  const Lattice<2> lattice{in_section<dim>(body.space.origin()), body.space.size(), body.layout.row_points};
  const LayerLift lift(study, layer, below, lattice.spacing());
  NewPoint<dim> point = point_of(study, layer, body);
  for (const exchange::Polygon& polygon : study.geometry.polygons) {
    if (polygon.layer != layer) continue;
    for (const Piece<2>& piece : cut_polygon(polygon, lattice)) {
      const LayerLift::Spot spot = lift.spot(piece.centroid);
      Place place(piece.centroid[0], 0.0, piece.centroid[1]);
      if (!(spot.area_ratio > 0.0)) refuse_inverted(study, layer, place, spot.area_ratio);
      const double area = piece.volume * spot.area_ratio;
      point.volume = dim == 2 ? area : area * lattice.spacing();
      point.half_lengths = Vector<dim>::Constant(0.5 * std::sqrt(area));
      point.position[0] = spot.position[0], point.position[dim - 1] = spot.position[1];
      if constexpr (dim == 3) point.half_lengths[1] = 0.5 * lattice.spacing();
      for (std::size_t row = 0; row < points_in_a_row<dim>(study); ++row) {
        if constexpr (dim == 3) {
          point.position[1] = body.space.origin()[1] + (static_cast<double>(row) + 0.5) * lattice.spacing();
          place[1] = point.position[1];
        }
        design.note(place);
        body.points.add(point);
      }
    }
  }
}

/// Pieces of a layer of a body in space.
template <class Space>
void place_solid(const exchange::Case& study, int layer, const std::vector<Piece<3>>& pieces, const SolidLift& lift,
                 Design& design, Body<Space>& body) {
  NewPoint<3> point = point_of(study, layer, body);
  for (const Piece<3>& piece : pieces) {
    const SolidLift::Spot spot = lift.spot(piece.centroid);
    if (!(spot.volume_ratio > 0.0)) refuse_inverted(study, layer, piece.centroid, spot.volume_ratio);
    point.position = spot.position;
    point.volume = piece.volume * spot.volume_ratio;
    point.half_lengths = Vector<3>::Constant(0.5 * std::cbrt(point.volume));
    design.note(piece.centroid);
    body.points.add(point);
  }
}

template <class Space>
void place_varying_along_y(const exchange::Case& study, int layer, const PresentLayers<3>& below, Design& design,
                           Body<Space>& body) {
  const Lattice<3> lattice{body.space.origin(), body.space.size(), body.layout.row_points};
  const SolidLift lift = study.geometry.valley ? lift_in_valley(study, layer, below, lattice.size)
                                               : lift_in_mesh(study, layer, below, lattice.size);
  place_solid(study, layer, cut_solid_layer(study.geometry, layer, lattice), lift, design, body);
}

} // namespace

template <int dim>
GridBox<dim> grid_around(const exchange::Case& study) {
  if constexpr (dim == 3)
    if (study.geometry.solid_mesh()) return grid_around_mesh(*study.geometry.mesh, study.mpm.element_size);
  const exchange::PlaneBox box = extent_with_supports(study);
  GridBox<dim> grid{.counts = {}, .size = study.mpm.element_size};
  if constexpr (dim == 3) {
    if (study.geometry.valley)
      span_valley(study.geometry, grid);
    else
      grid.counts[1] = static_cast<int>(std::lround(*study.geometry.depth / grid.size));
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    int& count = axis == 0 ? grid.counts[0] : grid.counts.back();
    grid.origin[axis == 0 ? 0 : dim - 1] = box.lowest[axis];
    const double extent = box.highest[axis] - box.lowest[axis], slack = relative_slack * extent;
    count = static_cast<int>(std::ceil(extent / grid.size * (1.0 - relative_slack)));
    if (!held_at(study, box.highest[axis], axis, slack)) ++count;
    if (axis != 0 || held_at(study, box.lowest[axis], axis, slack)) continue;
    ++count;
    grid.origin[0] -= grid.size;
  }
  return grid;
}

template <class Space>
std::vector<PerAxis<bool, Space::dim>> polygon_supports(const exchange::Case& study, const Space& space) {
  std::vector<PerAxis<bool, Space::dim>> fixed(static_cast<std::size_t>(space.n_nodes()));
  const auto& numbering = space.node_numbering();
  const bool has_end_walls = Space::dim == 3 && !study.geometry.varies_along_y();
  for (int node = 0; has_end_walls && node < space.n_nodes(); ++node) {
    const int slice = numbering.index(node)[1];
    fixed[static_cast<std::size_t>(node)][1] = slice == 0 || slice == numbering.counts[1] - 1;
  }
  for_each_held(study, space, [&](int node, int direction, const exchange::Support&) {
    fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(direction)] = true;
  });
  return fixed;
}

template <class Space>
std::vector<FollowingNode> following_nodes(const exchange::Case& study, const Space& space) {
  std::vector<FollowingNode> following;
  for_each_held(study, space, [&](int node, int direction, const exchange::Support& support) {
    if (support.motion != exchange::SupportMotion::exact) return;
    const Vector<2> position = space.node_position(node);
    following.push_back({.dof = 2 * node + direction,
                         .direction = direction,
                         .position = position,
                         .layer = exchange::nearest_layer(study.geometry, plane_point(position))});
  });
  return following;
}

template <class Space>
void place_polygons(const exchange::Case& study, int layer, const std::vector<int>& present, Design& design,
                    Body<Space>& body) {
  const PresentLayers<Space::dim> below(study, design, body.points, present);
  if constexpr (Space::dim == 3)
    if (study.geometry.varies_along_y()) return place_varying_along_y(study, layer, below, design, body);
  place_section(study, layer, below, design, body);
}

template <class Space>
std::vector<double> support_reactions(const exchange::Case& study, const Space& space,
                                      const Eigen::VectorXd& reactions) {
  constexpr std::size_t dim = Space::dim;
  std::vector<double> sums(dim * study.supports.size(), 0.0);
  std::vector<bool> counted(static_cast<std::size_t>(reactions.size()), false);
  for_each_held(study, space, [&](int node, int direction, const exchange::Support& support) {
    const auto dof = dim * static_cast<std::size_t>(node) + static_cast<std::size_t>(direction);
    if (counted[dof]) return;
    counted[dof] = true;
    const auto number = static_cast<std::size_t>(&support - study.supports.data());
    sums[dim * number + static_cast<std::size_t>(direction)] += reactions[static_cast<Eigen::Index>(dof)];
  });
  return sums;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template std::vector<PerAxis<bool, Space::dim>> polygon_supports(const exchange::Case&, const Space&);               \
  template void place_polygons(const exchange::Case&, int, const std::vector<int>&, Design&, Body<Space>&);            \
  template std::vector<double> support_reactions(const exchange::Case&, const Space&, const Eigen::VectorXd&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

#define SETTLE_INSTANTIATE_PLANE(Space)                                                                                \
  template std::vector<FollowingNode> following_nodes(const exchange::Case&, const Space&);
SETTLE_FOR_EVERY_PLANE_SPACE(SETTLE_INSTANTIATE_PLANE)
template GridBox<2> grid_around(const exchange::Case&);
template GridBox<3> grid_around(const exchange::Case&);

} // namespace settle::mpm
