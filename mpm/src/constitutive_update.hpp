/// \file
/// What an increment's deformation of a cell does to its stress: the response a Newton iteration needs, and the update
/// of the points once the increment is accepted.
#pragma once

#include "incremental_kinematics.hpp"
#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Average Cauchy stress of a cell at the end of an increment and its derivative.
template <class Grid>
struct CellResponse {
  static constexpr int dim = Grid::dim;
  Tensor<dim> stress;
  /// By degree of freedom of the cell, dim * node + direction: variation of `stress` with that nodal displacement
  /// [Pa/m].
  std::array<Tensor<dim>, static_cast<std::size_t>(dim* Grid::nodes_per_cell)> variations;
};

/// `start`: the cell's average stress at the start of the increment. The average keeps the points' volumes as weights:
/// all points of a cell of constant gradient change their volume by the same ratio.
template <class Grid>
CellResponse<Grid> respond(const Body<Grid>& body, int cell, const CellStress<Grid::dim>& start,
                           const IncrementalKinematics<Grid::dim>& kinematics);

/// How the law `rate` measures the strain of an increment.
enum class StrainMeasure {
  midpoint,   ///< sym(G (I + G/2)^-1): right to third order, enough for the small steps of the explicit scheme
  logarithmic ///< 1/2 ln(F F^T): exact where the principal axes do not turn, for quasi-static increments of any size
};

/// Volume, stress and, where tracked, deformation gradient of the cell's points at the end of the increment.
template <class Grid>
void deform_points(Body<Grid>& body, int cell, const IncrementalKinematics<Grid::dim>& kinematics,
                   StrainMeasure measure);

} // namespace settle::mpm
