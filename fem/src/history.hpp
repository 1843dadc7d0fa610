/// \file
/// What a placed cell remembers: where it was placed, displacement since, stress, and what its soil remembers.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include "soil/soil_point.hpp"

namespace settle::fem {

/// All members are empty until the cell is placed.
template <int dim>
struct CellHistory {
  std::vector<dealii::Point<dim>> shape;             ///< (support points of the geometry) as placed [m]
  std::vector<double> displacement;                  ///< (dofs per cell) since placement [m]
  std::vector<dealii::SymmetricTensor<2, 3>> stress; ///< (quadrature points) Cauchy [Pa]
  std::vector<double> datum{};                       ///< (dofs per cell) displacement that counts as none [m]
  std::vector<StateVariables> variables{};           ///< (quadrature points)

  [[nodiscard]] bool placed() const { return !displacement.empty(); }
  /// (dofs per cell) displacement as it is reported: that of existing ground counts from its state of rest [m].
  [[nodiscard]] std::vector<double> counted_displacement() const {
    std::vector<double> counted = displacement;
    std::transform(counted.begin(), counted.end(), datum.begin(), counted.begin(), std::minus<>());
    return counted;
  }
};

/// The history of all cells of a mesh that is never refined, by the cell's index in the mesh. Kept by cell and not by
/// node, because cells of two layers that share a node have moved by different amounts since they were placed, from
/// different places.
template <int dim>
class History {
public:
  explicit History(unsigned n_cells) : cells_(n_cells) {}

  /// Stress-free and undisplaced from here on.
  template <class Cell>
  void place(const Cell& cell, std::vector<dealii::Point<dim>> shape, unsigned n_dofs, unsigned n_quadrature_points,
             const StateVariables& variables) {
    of(cell) = {std::move(shape), std::vector<double>(n_dofs),
                std::vector<dealii::SymmetricTensor<2, 3>>(n_quadrature_points), std::vector<double>(n_dofs),
                std::vector<StateVariables>(n_quadrature_points, variables)};
  }
  template <class Cell>
  void remove(const Cell& cell) {
    of(cell) = {};
  }
  /// What a placed cell has moved so far counts as nothing from here on.
  template <class Cell>
  void count_from_here(const Cell& cell) {
    of(cell).datum = of(cell).displacement;
  }

  template <class Cell>
  [[nodiscard]] CellHistory<dim>& of(const Cell& cell) {
    return cells_[cell->active_cell_index()];
  }
  template <class Cell>
  [[nodiscard]] const CellHistory<dim>& of(const Cell& cell) const {
    return cells_[cell->active_cell_index()];
  }

private:
  std::vector<CellHistory<dim>> cells_;
};

/// The vector field with these values at the degrees of freedom of a cell, at a point in unit coordinates.
template <int dim>
dealii::Tensor<1, dim> interpolate(const dealii::FiniteElement<dim>& element, const std::vector<double>& at_dofs,
                                   const dealii::Point<dim>& unit) {
  dealii::Tensor<1, dim> value;
  for (unsigned i = 0; i < at_dofs.size(); ++i)
    value[element.system_to_component_index(i).first] += at_dofs[i] * element.shape_value(i, unit);
  return value;
}

} // namespace settle::fem
