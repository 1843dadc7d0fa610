/// \file
/// The mesh of the design geometry. Material id: the layer 1 ... N.
#pragma once

#include <deal.II/grid/tria.h>

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// A column: equal boxes over the whole of it; boundary id 2 c and 2 c + 1: the lower and the upper side along axis c,
/// so the top is 2 dim - 1. Polygons: the cells of polygon_mesh.hpp, in their order; in space slice after slice along
/// y, or the hexahedra of the case's mesh; of a dam across a valley those of valley_mesh.hpp, slice after slice along
/// x.
template <int dim>
void make_mesh(const exchange::Case& study, dealii::Triangulation<dim>& mesh);

/// The layer of a cell, 1 ... N.
template <class Cell>
int layer_of(const Cell& cell) {
  return static_cast<int>(cell->material_id());
}

} // namespace settle::fem
