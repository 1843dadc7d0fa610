/// \file
/// What the named boundaries of a mesh of hexahedra hold.
#pragma once

#include <optional>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::fem {

class MeshSupports {
public:
  explicit MeshSupports(const exchange::Mesh& mesh);

  /// The first boundary that holds a displacement along an axis of what lies between nodes of the mesh: of a corner
  /// one, of an edge two, of a side four. Nothing where they are no part of a side that is held.
  [[nodiscard]] std::optional<std::size_t> at(const std::vector<unsigned>& nodes, unsigned axis) const;

private:
  struct Side {
    std::size_t boundary;         ///< its place in Mesh::boundaries
    std::optional<unsigned> axis; ///< along which it is held; none: all
    std::vector<unsigned> nodes;
  };

  std::vector<Side> sides_;                       ///< by their boundaries
  std::vector<std::vector<std::size_t>> at_node_; ///< sides, in their order, of each node of the mesh
};

} // namespace settle::fem
