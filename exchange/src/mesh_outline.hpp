/// \file
/// Outlines of the layers of a plane mesh, and what follows from them.
#pragma once

#include <array>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

using NodeNumbers = std::vector<unsigned>;
/// From one node to another.
using MeshEdge = std::array<unsigned, 2>;

/// Edges one after the other, as far as they lead; a closed line begins and ends at its lowest x. Where lines touch,
/// each goes on along the part of the plane on its left.
std::vector<NodeNumbers> lines_of(const Mesh& mesh, const std::vector<MeshEdge>& edges);

/// The nodes of a line between which it is straight, its ends among them.
NodeNumbers corners_of(const Mesh& mesh, const NodeNumbers& line);

/// Convex polygons, corners anticlockwise, that make up a layer. They share parts of edges.
std::vector<NodeNumbers> convex_parts(const Mesh& mesh, int layer);

} // namespace settle::exchange
