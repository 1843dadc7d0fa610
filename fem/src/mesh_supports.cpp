#include "mesh_supports.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace settle::fem {
namespace {

/// Along which the nodes of a side reach least: that across it.
unsigned axis_across(const exchange::Mesh& mesh, const std::vector<unsigned>& side) {
  std::array<double, 3> reach{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const unsigned node : side) {
      lowest = std::min(lowest, mesh.nodes[node][axis]);
      highest = std::max(highest, mesh.nodes[node][axis]);
    }
    reach[axis] = highest - lowest;
  }
  return static_cast<unsigned>(std::min_element(reach.begin(), reach.end()) - reach.begin());
}

} // namespace

MeshSupports::MeshSupports(const exchange::Mesh& mesh) : at_node_(mesh.nodes.size()) {
  for (std::size_t b = 0; b < mesh.boundaries.size(); ++b)
    for (const std::vector<unsigned>& nodes : mesh.boundaries[b].sides) {
      for (const unsigned node : nodes)
        at_node_[node].push_back(sides_.size());
      Side& side = sides_.emplace_back(Side{.boundary = b, .axis = {}, .nodes = nodes});
      if (!mesh.boundaries[b].fixed) side.axis = axis_across(mesh, nodes);
    }
}

std::optional<std::size_t> MeshSupports::at(const std::vector<unsigned>& nodes, unsigned axis) const {
  for (const std::size_t s : at_node_[nodes.front()]) {
    const Side& side = sides_[s];
    if (side.axis && *side.axis != axis) continue;
    const bool holds_all = std::all_of(nodes.begin(), nodes.end(), [&](unsigned node) {
      return std::find(side.nodes.begin(), side.nodes.end(), node) != side.nodes.end();
    });
    if (holds_all) return side.boundary;
  }
  return {};
}

} // namespace settle::fem
