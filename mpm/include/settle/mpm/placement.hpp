/// \file
/// Placing material points: whole layers, and single cells and rows to refill them.
#pragma once

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Where a layer is placed.
struct LayerPlacement {
  int layer = 1;
  double base = 0;      ///< height of its lower side [m]
  double thickness = 0; ///< as placed [m]
};

/// Places a layer over the whole width: per square of the grid, three points in each of its two triangles at the Gauss
/// positions (1/6, 1/6), (2/3, 1/6), (1/6, 2/3). A thickness that is no multiple of the grid's size is divided into the
/// nearest number of rows. The body has to be sorted afterwards.
void place_layer(Body<TriangleGrid>& body, const LayerPlacement& placement);

/// Places the initial points of one cell, marked as refilled.
void refill_cell(Body<TriangleGrid>& body, int cell, int layer);

/// Height of a full refilled row: the smallest distance between two rows of initial points, a sixth of a square [m]. A
/// refilled row lies across one column of squares, two points side by side.
double refill_row_height(const TriangleGrid& grid);

/// A refilled row.
struct RefillRow {
  int layer = 1;
  int column = 0;    ///< of squares
  double top = 0;    ///< height of its upper side [m]
  double height = 0; ///< [m]
};
void refill_row(Body<TriangleGrid>& body, const RefillRow& row);

/// Surface of each column of squares of a body without gaps: its points' volume over its width [m].
std::vector<double> column_heights(const Body<TriangleGrid>& body);

} // namespace settle::mpm
