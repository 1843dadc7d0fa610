/// \file
/// Equilibrium of the layers placed so far, stage by stage.
#pragma once

#include <memory>
#include <vector>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include "elasticity.hpp"
#include "formulation.hpp"
#include "history.hpp"
#include "placement.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

/// How near to equilibrium a solve came.
struct Equilibrium {
  std::vector<double> residuals; ///< |unbalanced force| / |external force| at free degrees of freedom, at the start and
                                 ///< after each solve; infinite where a point would be turned inside out [-]
  unsigned linear_solves = 0;
  double base_reaction = 0; ///< positive upward [N/m or N]

  [[nodiscard]] double out_of_balance() const { return residuals.back(); }
  [[nodiscard]] bool reached() const;
};

/// Layers not placed yet have no degrees of freedom. Nodal values are increments of displacement since the last
/// `accept`; everything before is the history of each cell.
template <int dim>
class StagedProblem {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit StagedProblem(const exchange::Case& study);

  /// Places a layer on those below: stress-free, its displacement counted from here.
  void activate(int layer);
  /// Finds the displacement increment that balances the weight of all layers below and `gravity_factor` times that of
  /// the layer activated last, by Newton's method with a line search. Changes no history.
  Equilibrium solve(double gravity_factor);
  /// Adds the increment just found to the history: the only place where that changes once a cell is placed.
  void accept();

  [[nodiscard]] const dealii::DoFHandler<dim>& dofs() const { return dofs_; }
  /// The element of placed cells.
  [[nodiscard]] const dealii::FiniteElement<dim>& element() const { return elements_[0]; }
  [[nodiscard]] const dealii::Quadrature<dim>& quadrature() const { return quadrature_; }
  /// From unit coordinates to the position as placed.
  [[nodiscard]] const dealii::Mapping<dim>& mapping() const { return geometry_.mapping(); }
  [[nodiscard]] const Formulation<dim>& formulation() const { return *formulation_; }
  [[nodiscard]] const History<dim>& history() const { return history_; }
  [[nodiscard]] const Elasticity& constants() const { return constants_; }
  [[nodiscard]] double density() const { return density_; }
  [[nodiscard]] double gravity() const { return gravity_; }
  /// Cells placed so far.
  [[nodiscard]] std::vector<Cell> placed_cells() const;
  /// Of a layer that is placed [kg/m or kg].
  [[nodiscard]] double mass(int layer) const;

private:
  [[nodiscard]] dealii::FEValues<dim> cell_values() const;
  [[nodiscard]] Trial<dim> trial_of(const Cell& cell, const dealii::FEValues<dim>& values) const;

  void distribute_dofs();
  void fix_supports();

  void factorize_tangent();
  void assemble_forces(double gravity_factor);
  bool correct_increment(double gravity_factor, Equilibrium& equilibrium);
  [[nodiscard]] double out_of_balance() const;
  [[nodiscard]] double base_reaction() const;

  Elasticity constants_;
  std::unique_ptr<Formulation<dim>> formulation_;
  double density_; ///< [kg/m3]
  double gravity_; ///< [m/s2]
  int layer_ = 0;  ///< the layer activated last

  dealii::Triangulation<dim> mesh_;
  dealii::hp::FECollection<dim> elements_; ///< 0: placed; 1: not placed
  dealii::QGauss<dim> quadrature_;
  dealii::DoFHandler<dim> dofs_;
  History<dim> history_;
  PlacedGeometry<dim> geometry_;

  dealii::AffineConstraints<double> supports_;
  std::vector<dealii::types::global_dof_index> base_dofs_; ///< vertical, at the base
  dealii::SparsityPattern sparsity_;
  dealii::SparseMatrix<double> tangent_;
  dealii::SparseDirectUMFPACK inverse_;
  dealii::Vector<double> increment_;  ///< nodal displacement since the last `accept` [m]
  dealii::Vector<double> external_;   ///< forces at all degrees of freedom [N]
  dealii::Vector<double> unbalanced_; ///< external minus internal forces at all degrees of freedom [N]
  bool inside_out_ = false;           ///< the increment has no stress
  bool factorized_ = false;           ///< since a layer was placed
};

} // namespace settle::fem
