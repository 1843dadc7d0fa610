/// \file
/// The mesh of the design geometry.
#pragma once

#include <deal.II/grid/tria.h>

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// Equal boxes over the whole design column; material id: the layer 1 ... N; boundary id 2 c and 2 c + 1: the lower and
/// the upper side along axis c, so the top is 2 dim - 1.
template <int dim>
void make_column(const exchange::Case& study, dealii::Triangulation<dim>& mesh);

/// The layer of a cell, 1 ... N.
template <class Cell>
int layer_of(const Cell& cell) {
  return static_cast<int>(cell->material_id());
}

} // namespace settle::fem
