#include "settle/exchange/mesh_sides.hpp"

#include <algorithm>
#include <limits>

namespace settle::exchange {

SideKey key_of(std::vector<unsigned> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<std::vector<unsigned>> sides_of(const Mesh& mesh, const MeshCell& cell) {
  static const std::vector<std::vector<unsigned>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  static const std::vector<std::vector<unsigned>> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                        {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::vector<std::vector<unsigned>> sides = mesh.dimension == 2 ? edges : faces;
  for (std::vector<unsigned>& side : sides)
    for (unsigned& node : side)
      node = cell.nodes[node];
  return sides;
}

std::map<SideKey, MeshSide> all_sides(const Mesh& mesh) {
  std::map<SideKey, MeshSide> sides;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const std::vector<unsigned>& nodes : sides_of(mesh, mesh.cells[c])) {
      MeshSide& side = sides[key_of(nodes)];
      if (side.cells.empty()) side.nodes = nodes;
      side.cells.push_back(c);
    }
  return sides;
}

double mesh_slack(const Mesh& mesh) {
  constexpr double relative = 1e-9; // of the extents together
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lowest = infinity, highest = -infinity;
    for (const auto& node : mesh.nodes) {
      lowest = std::min(lowest, node[axis]);
      highest = std::max(highest, node[axis]);
    }
    sum += highest - lowest;
  }
  return relative * sum;
}

} // namespace settle::exchange
