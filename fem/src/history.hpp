/// \file
/// What a placed cell remembers: displacement since it was placed, and stress.
#pragma once

#include <vector>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

namespace settle::fem {

/// Both members are empty until the cell is placed.
template <int dim>
struct CellHistory {
  std::vector<double> displacement;                    ///< (dofs per cell) since placement [m]
  std::vector<dealii::SymmetricTensor<2, dim>> stress; ///< (quadrature points) Cauchy [Pa]

  [[nodiscard]] bool placed() const { return !displacement.empty(); }
};

/// The history of all cells of a mesh that is never refined, by the cell's index in the mesh. Kept by cell and not by
/// node, because cells of two layers that share a node have moved by different amounts since they were placed.
template <int dim>
class History {
public:
  explicit History(unsigned n_cells) : cells_(n_cells) {}

  /// Stress-free and undisplaced from here on.
  template <class Cell>
  void place(const Cell& cell, unsigned n_dofs, unsigned n_quadrature_points) {
    of(cell) = {std::vector<double>(n_dofs), std::vector<dealii::SymmetricTensor<2, dim>>(n_quadrature_points)};
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

} // namespace settle::fem
