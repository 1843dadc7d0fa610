/// \file
/// How points lie in a square or cube when they are placed.
#pragma once

#include <vector>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Initial points of one square and the rows it is refilled by. Lengths are shares of the square's side.
template <int dim>
struct PointLayout {
  std::vector<std::vector<Vector<dim>>> cells; ///< by cell of the square: positions of its points, equal in volume
  double row_height = 0;                       ///< of a full refilled row
  int row_points = 0; ///< side by side in a refilled row, evenly spaced, along each horizontal axis

  [[nodiscard]] std::size_t points_per_square() const;
};

/// Two triangles, each with the three Gauss points of degree 2: (1/6, 1/6), (2/3, 1/6), (1/6, 2/3) from its right
/// angle. Refilled rows are a sixth of the side high, the smallest distance of two rows of points.
PointLayout<2> triangle_layout();

/// Six tetrahedra, cut as in TetrahedronSpace, each with the four Gauss points of degree 2, nearer to one node than to
/// the others: (5 + 3 sqrt 5)/20 of it, (5 - sqrt 5)/20 of the others. Refilled rows are as high as that, the smallest
/// distance of two rows of points.
PointLayout<3> tetrahedron_layout();

/// One square or cube with `per_side` points along each axis on a regular lattice, (i + 1/2) / per_side. Refilled rows
/// are as high as the lattice is wide.
template <int dim>
PointLayout<dim> lattice_layout(int per_side);

} // namespace settle::mpm
