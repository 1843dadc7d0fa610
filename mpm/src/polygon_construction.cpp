#include "polygon_construction.hpp"

#include <algorithm>
#include <cmath>

#include "settle/exchange/plane_geometry.hpp"
#include "settle/mpm/polygon_fill.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {
namespace {

/// Lengths in case files have a few digits: an extent that is a multiple of the element up to this counts as one.
constexpr double relative_slack = 1e-6;

exchange::PlanePoint plane_point(const Vector<2>& x) {
  return {x[0], x[1]};
}

/// Is anything held along the upper end of the extent in this direction?
bool held_at_end(const exchange::Case& study, const exchange::PlaneBox& box, std::size_t axis) {
  const double end = box.highest[axis], slack = relative_slack * (end - box.lowest[axis]);
  return std::any_of(study.supports.begin(), study.supports.end(), [&](const exchange::Support& support) {
    return std::abs(support.from[axis] - end) <= slack && std::abs(support.to[axis] - end) <= slack;
  });
}

/// Is the node on the support or beyond it?
bool stands_for(const exchange::Support& support, const Vector<2>& node, double size) {
  const double length = std::hypot(support.to[0] - support.from[0], support.to[1] - support.from[1]);
  const double past_ends = std::sqrt(2.0) * size / length;
  const double share = exchange::share_along(support, plane_point(node));
  return exchange::height_above(support, plane_point(node)) <= relative_slack * size && share >= -past_ends &&
         share <= 1.0 + past_ends;
}

/// Calls `action` with each node, direction and support that holds it.
template <class Space, class Action>
void for_each_held(const exchange::Case& study, const Space& space, Action&& action) {
  for (int node = 0; node < space.n_nodes(); ++node)
    for (const exchange::Support& support : study.supports) {
      if (!stands_for(support, space.node_position(node), space.size())) continue;
      if (support.held != exchange::Held::y) action(node, 0, support);
      if (support.held != exchange::Held::x) action(node, 1, support);
    }
}

} // namespace

GridBox<2> grid_around(const exchange::Case& study) {
  const exchange::PlaneBox box = exchange::bounding_box(study.geometry);
  const double size = study.mpm.element_size;
  const auto squares = [&](std::size_t axis) {
    const double needed = (box.highest[axis] - box.lowest[axis]) / size;
    return static_cast<int>(std::ceil(needed * (1.0 - relative_slack))) + (held_at_end(study, box, axis) ? 0 : 1);
  };
  return {.counts = {squares(0), squares(1)}, .size = size, .origin = {box.lowest[0], box.lowest[1]}};
}

template <class Space>
std::vector<PerAxis<bool, 2>> polygon_supports(const exchange::Case& study, const Space& space) {
  std::vector<PerAxis<bool, 2>> fixed(static_cast<std::size_t>(space.n_nodes()), {false, false});
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
void place_polygons(const exchange::Case& study, int layer, Body<Space>& body) {
  const Lattice lattice{body.space.origin(), body.space.size(), body.layout.row_points};
  for (const exchange::Polygon& polygon : study.geometry.polygons) {
    if (polygon.layer != layer) continue;
    for (const Piece& piece : cut_polygon(polygon, lattice))
      body.points.add({.layer = layer,
                       .position = piece.centroid,
                       .volume = piece.area,
                       .density = body.density_of(layer),
                       .preconsolidation_pressure = body.preconsolidation_of(layer),
                       .half_lengths = Vector<2>::Constant(0.5 * std::sqrt(piece.area))});
  }
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template std::vector<PerAxis<bool, 2>> polygon_supports(const exchange::Case&, const Space&);                        \
  template std::vector<FollowingNode> following_nodes(const exchange::Case&, const Space&);                            \
  template void place_polygons(const exchange::Case&, int, Body<Space>&);
SETTLE_FOR_EVERY_PLANE_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
