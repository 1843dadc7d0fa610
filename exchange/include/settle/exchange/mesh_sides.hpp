/// \file
/// Sides of the cells of a mesh: edges of quadrilaterals, faces of hexahedra.
#pragma once

#include <map>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// By the numbers of its nodes, in ascending order: the same for both cells that share it.
using SideKey = std::vector<unsigned>;
SideKey key_of(std::vector<unsigned> nodes);

/// Each with the numbers of its nodes all the way round, the cell on the left of an edge.
std::vector<std::vector<unsigned>> sides_of(const Mesh& mesh, const MeshCell& cell);

/// A side of one cell or more.
struct MeshSide {
  std::vector<unsigned> nodes{};    ///< as the first of its cells has it
  std::vector<std::size_t> cells{}; ///< places in Mesh::cells
};
std::map<SideKey, MeshSide> all_sides(const Mesh& mesh);

/// Distance that is round-off [m].
double mesh_slack(const Mesh& mesh);

} // namespace settle::exchange
