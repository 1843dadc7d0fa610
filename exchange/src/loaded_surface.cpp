#include "settle/exchange/loaded_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "settle/exchange/valley.hpp"
#include "solid_vectors.hpp"

namespace settle::exchange {
namespace {

SolidPoint point_of(const std::vector<double>& position) {
  return {position[0], position[1], position[2]};
}

SolidBox box_around(const Mesh& mesh, const std::vector<unsigned>& side) {
  SolidBox box = empty_box();
  for (const unsigned node : side)
    enlarge(box, mesh.nodes[node]);
  return box;
}

bool lies_within(const SolidBox& part, const SolidBox& whole, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (part.lowest[axis] < whole.lowest[axis] - slack || part.highest[axis] > whole.highest[axis] + slack)
      return false;
  return true;
}

/// Along every axis on which it has an extent.
bool reaches_into(const SolidBox& part, const SolidBox& whole, double slack) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double shared =
        std::min(part.highest[axis], whole.highest[axis]) - std::max(part.lowest[axis], whole.lowest[axis]);
    const bool flat = part.highest[axis] - part.lowest[axis] <= slack;
    if (shared < (flat ? -slack : slack)) return false;
  }
  return true;
}

double area_of(const Mesh& mesh, const std::vector<unsigned>& side) {
  const SolidPoint &a = mesh.nodes[side[0]], &b = mesh.nodes[side[1]], &c = mesh.nodes[side[2]],
                   &d = mesh.nodes[side[3]];
  const auto between = [](const SolidPoint& from, const SolidPoint& to, double share) {
    return SolidPoint{from[0] + share * to[0], from[1] + share * to[1], from[2] + share * to[2]};
  };
  const SolidPoint twist = (c - d) - (b - a);
  double area = 0.0;
  for (const double u : {0.5 - 0.5 / std::numbers::sqrt3, 0.5 + 0.5 / std::numbers::sqrt3})
    for (const double v : {0.5 - 0.5 / std::numbers::sqrt3, 0.5 + 0.5 / std::numbers::sqrt3})
      area += 0.25 * length(cross(between(b - a, twist, v), between(d - a, twist, u)));
  return area;
}

/// Of a load on a line of the section: what the line sweeps along y.
double depth_of(const Geometry& geometry, const StageEntry& load) {
  if (geometry.dimension == 2) return 1.0;
  if (!geometry.valley) return *geometry.depth;
  return 0.5 * (valley_at(*geometry.valley, load.from[1]).width() + valley_at(*geometry.valley, load.to[1]).width());
}

} // namespace

std::map<SideKey, FreeSide> free_sides_of(const Mesh& mesh, const std::set<int>& present) {
  std::map<SideKey, FreeSide> sides;
  for (const auto& [key, side] : all_sides(mesh)) {
    std::vector<int> layers;
    for (const std::size_t cell : side.cells)
      if (present.contains(mesh.cells[cell].layer)) layers.push_back(mesh.cells[cell].layer);
    if (layers.size() == 1) sides[key] = {side.nodes, layers.front()};
  }
  for (const MeshBoundary& boundary : mesh.boundaries)
    for (const std::vector<unsigned>& held : boundary.sides)
      sides.erase(key_of(held));
  return sides;
}

SidesInBox sides_in_box(const Mesh& mesh, const StageEntry& load, const std::set<int>& present) {
  SolidBox box = empty_box();
  enlarge(box, point_of(load.from)), enlarge(box, point_of(load.to));
  const double slack = mesh_slack(mesh);
  SidesInBox found;
  for (const auto& [key, side] : free_sides_of(mesh, present)) {
    const SolidBox around = box_around(mesh, side.nodes);
    if (lies_within(around, box, slack))
      found.whole.push_back(side);
    else if (reaches_into(around, box, slack))
      found.cut.push_back(side);
  }
  return found;
}

double loaded_area(const Case& study, int stage) {
  const StageEntry& load = study.stages.at(static_cast<std::size_t>(stage - 1));
  const Geometry& geometry = study.geometry;
  if (!geometry.solid_mesh())
    return std::hypot(load.to[0] - load.from[0], load.to[1] - load.from[1]) * depth_of(geometry, load);
  double area = 0.0;
  for (const FreeSide& side : sides_in_box(*geometry.mesh, load, study.layers_present(stage)).whole)
    area += area_of(*geometry.mesh, side.nodes);
  return area;
}

} // namespace settle::exchange
