/// \file
/// Placing material points: whole layers, and single cells and rows to refill them.
#pragma once

#include "settle/mpm/body.hpp"
#include "settle/mpm/design_column.hpp"

namespace settle::mpm {

/// Where a layer is placed.
struct LayerPlacement {
  int layer = 1;
  double base = 0;      ///< height of its lower side [m]
  double thickness = 0; ///< as placed [m]
};

/// Places a layer over the whole plan, each square of the grid with the points of the body's layout. A thickness that
/// is no multiple of the grid's size is divided into the nearest number of rows. The body has to be sorted afterwards.
template <class Space>
void place_layer(Body<Space>& body, const LayerPlacement& placement);

/// Takes the points of a layer away; the rest keeps its order. Returns their mass [kg/m in 2-D]. The body has to be
/// sorted afterwards.
template <int dim>
double remove_layer(Points<dim>& points, int layer);

/// Places the initial points of one cell, marked as refilled.
template <class Space>
void refill_cell(Body<Space>& body, int cell, int layer);

/// Height of a full refilled row [m]. A row lies across one column of squares.
template <class Space>
double refill_row_height(const Body<Space>& body);

/// A refilled row: level, or parallel to a designed surface where there is one.
struct RefillRow {
  int layer = 1;
  int column = 0;                         ///< of squares
  double top = 0;                         ///< height of its upper side, in the mean over the row [m]
  double height = 0;                      ///< [m]
  const DesignColumn* parallel = nullptr; ///< to what is designed over the column; below it there is no point
};
template <class Space>
void refill_row(Body<Space>& body, const RefillRow& row);

/// Surface of each column of squares of a body without gaps: the grid's base and its points' volume over its
/// width (in 3-D the column's area) [m].
template <class Space>
std::vector<double> column_heights(const Body<Space>& body);

} // namespace settle::mpm
