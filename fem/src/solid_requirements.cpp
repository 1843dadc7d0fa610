#include "solid_requirements.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/mesh_sides.hpp"

namespace settle::fem {
namespace {

using Sides = std::vector<std::vector<unsigned>>;
using Position = std::array<double, 3>;

/// Between a layer and others.
Sides shared_sides(const exchange::Mesh& mesh, int layer, const std::set<int>& others) {
  Sides shared;
  for (const auto& [key, side] : exchange::all_sides(mesh)) {
    if (side.cells.size() != 2) continue;
    const int one = mesh.cells[side.cells[0]].layer, other = mesh.cells[side.cells[1]].layer;
    if ((one == layer && others.contains(other)) || (other == layer && others.contains(one)))
      shared.push_back(side.nodes);
  }
  return shared;
}

Position middle_of(const exchange::Mesh& mesh, const std::vector<unsigned>& side) {
  Position middle{};
  for (const unsigned node : side)
    for (std::size_t axis = 0; axis < 3; ++axis)
      middle[axis] += mesh.nodes[node][axis] / static_cast<double>(side.size());
  return middle;
}

[[noreturn]] void refuse(const exchange::Case& study, int layer, const char* why, const Position& at) {
  throw exchange::InputError(exchange::Complaint{
      .where = study.where("geometry.mesh"),
      .what = fmt::format("layer {} {}", layer, why),
      .given = fmt::format("at ({:.6g}), with fem.kinematics = \"finite\"", fmt::join(at, ", ")),
      .allowed = "layers that lie as a whole on what was placed before, or touch nothing of it",
      .remedy = "divide the layer, use fem.kinematics = \"small\", or solve the case with settle-mpm alone"});
}

void require_layer_above(const exchange::Case& study, int layer, const std::set<int>& others) {
  const exchange::Mesh& mesh = *study.geometry.mesh;
  const Sides shared = shared_sides(mesh, layer, others);
  if (shared.empty()) return;
  for (const std::vector<unsigned>& side : shared)
    if (const Position middle = middle_of(mesh, side); !height_of_side(mesh, side, middle[0], middle[1]))
      refuse(study, layer, "leans on what was placed before", middle);
  const double slack = exchange::mesh_slack(mesh);
  std::set<unsigned> nodes;
  for (const exchange::MeshCell& cell : mesh.cells)
    if (cell.layer == layer) nodes.insert(cell.nodes.begin(), cell.nodes.end());
  for (const unsigned node : nodes) {
    const Position& at = mesh.nodes[node];
    const bool is_above = std::any_of(shared.begin(), shared.end(), [&](const std::vector<unsigned>& side) {
      const std::optional<double> height = exchange::height_of_side(mesh, side, at[0], at[1]);
      return height && *height <= at[2] + slack;
    });
    if (!is_above) refuse(study, layer, "lies in part on what was placed before, and in part beside it", at);
  }
}

} // namespace

void require_layers_above(const exchange::Case& study) {
  for (std::size_t stage = 0; stage < study.stages.size(); ++stage) {
    const exchange::StageEntry& entry = study.stages[stage];
    if (entry.action == exchange::Action::place || entry.action == exchange::Action::ground)
      require_layer_above(study, entry.layer, study.layers_present(static_cast<int>(stage)));
  }
}

} // namespace settle::fem
