#include "mesh_construction.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "settle/exchange/mesh_geometry.hpp"

namespace settle::mpm {
namespace {

/// As of polygons: lengths have a few digits.
constexpr double relative_slack = 1e-6;
constexpr double deepest = 3.0; ///< of an element, beyond a side

Vector<3> node_of(const exchange::Mesh& mesh, unsigned node) {
  const auto& [x, y, z] = mesh.nodes[node];
  return {x, y, z};
}

/// Does a held side lie in this end of the extent?
bool held_at(const exchange::Mesh& mesh, double end, std::size_t axis, double slack) {
  const auto in_end = [&](const std::vector<unsigned>& side) {
    return std::all_of(side.begin(), side.end(),
                       [&](unsigned node) { return std::abs(mesh.nodes[node][axis] - end) <= slack; });
  };
  return std::any_of(mesh.boundaries.begin(), mesh.boundaries.end(), [&](const exchange::MeshBoundary& boundary) {
    return std::any_of(boundary.sides.begin(), boundary.sides.end(), in_end);
  });
}

} // namespace

GridBox<3> grid_around_mesh(const exchange::Mesh& mesh, double size) {
  const exchange::SolidBox box = exchange::bounding_box(mesh);
  GridBox<3> grid{.counts = {}, .size = size};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto d = static_cast<int>(axis);
    const double extent = box.highest[axis] - box.lowest[axis], slack = relative_slack * extent;
    grid.origin[d] = box.lowest[axis];
    grid.counts[axis] = static_cast<int>(std::ceil(extent / size * (1.0 - relative_slack)));
    if (!held_at(mesh, box.highest[axis], axis, slack)) ++grid.counts[axis];
    if (axis == 2 || held_at(mesh, box.lowest[axis], axis, slack)) continue;
    ++grid.counts[axis];
    grid.origin[d] -= size;
  }
  return grid;
}

MeshHolds::MeshHolds(const exchange::Mesh& mesh, double size) : size_(size) {
  for (std::size_t b = 0; b < mesh.boundaries.size(); ++b)
    for (const std::vector<unsigned>& nodes : mesh.boundaries[b].sides) {
      Side side{.boundary = static_cast<int>(b), .axis = -1, .middle = Vector<3>::Zero(), .outward = {}, .corners = {}};
      Vector<3> low = node_of(mesh, nodes[0]), high = low;
      for (const unsigned node : nodes) {
        const Vector<3> corner = node_of(mesh, node);
        side.corners.push_back(corner);
        side.middle += corner / static_cast<double>(nodes.size());
        low = low.cwiseMin(corner), high = high.cwiseMax(corner);
      }
      side.outward = (side.corners[2] - side.corners[0]).cross(side.corners[3] - side.corners[1]).normalized();
      if (!mesh.boundaries[b].fixed) side.outward.cwiseAbs().maxCoeff(&side.axis);
      const Square first = square_of(low - Vector<3>::Constant(deepest * size));
      const Square last = square_of(high + Vector<3>::Constant(deepest * size));
      for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
          for (int i = first[0]; i <= last[0]; ++i)
            near_[{i, j, k}].push_back(sides_.size());
      sides_.push_back(std::move(side));
    }
}

int MeshHolds::boundary_at(const Vector<3>& node, int axis) const {
  const auto near = near_.find(square_of(node));
  if (near == near_.end()) return -1;
  for (const std::size_t s : near->second)
    if ((sides_[s].axis < 0 || sides_[s].axis == axis) && stands_for(sides_[s], node)) return sides_[s].boundary;
  return -1;
}

auto MeshHolds::square_of(const Vector<3>& x) const -> Square {
  const auto index = [&](int d) { return static_cast<int>(std::floor(x[d] / size_)); };
  return {index(0), index(1), index(2)};
}

bool MeshHolds::stands_for(const Side& side, const Vector<3>& node) const {
  const double beyond = side.outward.dot(node - side.middle);
  if (beyond < -relative_slack * size_ || beyond > deepest * size_) return false;
  for (std::size_t c = 0; c < side.corners.size(); ++c) {
    const Vector<3> edge = side.corners[(c + 1) % side.corners.size()] - side.corners[c];
    if (edge.cross(side.outward).normalized().dot(node - side.corners[c]) > std::sqrt(2.0) * size_) return false;
  }
  return true;
}

SolidLift lift_in_mesh(const exchange::Case& study, int layer, const PresentLayers<3>& below, double spacing) {
  if (lies_as_drawn(study.construction.convention)) return {};
  const exchange::LayerOfMesh own(*study.geometry.mesh, layer);
  const exchange::SolidBox box = own.box();
  const Levels levels{box.lowest[2], box.highest[2]};
  return {{.levels = levels,
           .x = {box.lowest[0], box.highest[0]},
           .y = {box.lowest[1], box.highest[1]},
           .spacing = spacing},
          study.construction.convention == exchange::Convention::level_up,
          [&](double x, double y, bool) -> SolidLift::Foot {
            const auto height = own.lower_side(x, y);
            if (!height) return {levels.low, Vector<3>::Zero()};
            const Place foot(x, y, *height);
            return {*height, below.surface(foot) - foot};
          }};
}

} // namespace settle::mpm
