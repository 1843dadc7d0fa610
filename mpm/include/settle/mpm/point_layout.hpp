/// \file
/// How points lie in a square when they are placed.
#pragma once

#include <vector>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Initial points of one square and the rows it is refilled by. Lengths are shares of the square's side.
struct PointLayout {
  std::vector<std::vector<Vector<2>>> cells; ///< by cell of the square: positions of its points, equal in volume
  double row_height = 0;                     ///< of a full refilled row
  int row_points = 0;                        ///< side by side in a refilled row, evenly spaced

  [[nodiscard]] std::size_t points_per_square() const;
};

/// Two triangles, each with the three Gauss points of degree 2: (1/6, 1/6), (2/3, 1/6), (1/6, 2/3) from its right
/// angle. Refilled rows are a sixth of the side high, the smallest distance of two rows of points.
PointLayout triangle_layout();

/// One square with `per_side` x `per_side` points on a regular lattice, (i + 1/2) / per_side. Refilled rows are as high
/// as the lattice is wide.
PointLayout lattice_layout(int per_side);

} // namespace settle::mpm
