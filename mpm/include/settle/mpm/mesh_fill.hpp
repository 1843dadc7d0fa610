/// \file
/// Filling layers of a mesh of hexahedra with material points: a lattice cut by the mesh, so that volume and first
/// moment are right.
#pragma once

#include <vector>

#include "settle/mpm/polygon_fill.hpp"

namespace settle::mpm {

/// The pieces into which a lattice cuts a layer, cell by cell, row by row from below. The volume is kept, and the first
/// moment but for cells of which less than a third of a lattice cube is filled, as of a polygon (polygon_fill.hpp). A
/// cell that the surface cuts gets at least six pieces. Sides of hexahedra that are not plane are taken as four
/// triangles around their middle (exchange/mesh_geometry.hpp).
std::vector<Piece<3>> cut_mesh(const exchange::Mesh& mesh, int layer, const Lattice<3>& lattice);

} // namespace settle::mpm
