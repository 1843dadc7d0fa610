/// \file
/// Equilibrium of the layers placed so far, stage by stage.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include "formulation.hpp"
#include "history.hpp"
#include "level_ground.hpp"
#include "linear_solver.hpp"
#include "loading.hpp"
#include "placement.hpp"
#include "settle/exchange/case.hpp"
#include "supports.hpp"
#include "surface_loads.hpp"

namespace settle::fem {

/// How near to equilibrium a solve came.
struct Equilibrium {
  std::vector<double> residuals; ///< |unbalanced force| at free degrees of freedom / |load|, once supports are where
                                 ///< they are moved to, and after each further solve; infinite where a point would be
                                 ///< turned inside out [-]
  unsigned linear_solves = 0;
  bool linear_solver_gave_up = false;
  double base_reaction = 0;              ///< of all that is held vertically, positive upward [N/m or N]
  std::vector<double> support_reactions; ///< (supports of the case, dim) force on the body [N/m or N]

  [[nodiscard]] double out_of_balance() const { return residuals.back(); }
  [[nodiscard]] bool reached() const;
};

/// Layers that are not there have no degrees of freedom. Nodal values are increments of displacement since the last
/// `accept`; everything before is the history of each cell.
template <int dim>
class StagedProblem {
public:
  using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

  explicit StagedProblem(const exchange::Case& study);

  /// Begins a stage of the case, 1, 2, ... A layer that it places lies on those below, stress-free but for ground that
  /// has a k0, its displacement counted from here; one that it removes is gone, and the forces it exerted are still
  /// there, to be released in the course of the stage as a traction is raised.
  void begin(int stage);
  /// Finds the displacement increment that brings the body to a share of the stage, in balance with what loads it and
  /// with supports where the motion has them, by Newton's method with a line search. Changes no history.
  Equilibrium solve(double share);
  /// The same where Newton's method fails and materials yield: the body creeps from the start of the increment against
  /// a viscosity that vanishes. Takes up to 200 linear solves.
  Equilibrium relax(double share);
  /// Adds the increment just found to the history: the only place where stress and displacement change.
  void accept();
  /// Ends the stage: after one of existing ground, displacements count from here.
  void finish();

  [[nodiscard]] const dealii::DoFHandler<dim>& dofs() const { return dofs_; }
  /// The element of placed cells.
  [[nodiscard]] const dealii::FiniteElement<dim>& element() const { return elements_[0]; }
  [[nodiscard]] const dealii::Quadrature<dim>& quadrature() const { return quadrature_; }
  /// From unit coordinates to the position as placed.
  [[nodiscard]] const dealii::Mapping<dim>& mapping() const { return geometry_.mapping(); }
  [[nodiscard]] const Formulation<dim>& formulation() const { return *formulation_; }
  [[nodiscard]] const History<dim>& history() const { return history_; }
  /// As placed, of the material of a layer [kg/m3].
  [[nodiscard]] double density(int layer) const { return of_layer(densities_, layer); }
  [[nodiscard]] double gravity() const { return gravity_; }
  [[nodiscard]] const Loading& loading() const { return loading_; }
  /// Do positions change with displacement? Where they do not, all are those of the design.
  [[nodiscard]] bool geometry_moves() const { return geometry_moves_; }
  /// Whether any layer's law has plastic strain, and whether any has a preconsolidation pressure.
  [[nodiscard]] bool yields() const { return yields_; }
  [[nodiscard]] bool hardens() const { return hardens_; }
  /// Cells that are there.
  [[nodiscard]] const std::vector<Cell>& placed_cells() const { return placed_; }
  /// Of a layer, as far as it is there [kg/m or kg].
  [[nodiscard]] double mass(int layer) const;

private:
  [[nodiscard]] dealii::FEValues<dim> cell_values() const { return cell_values(quadrature_); }
  [[nodiscard]] dealii::FEValues<dim> cell_values(const dealii::Quadrature<dim>& quadrature) const;
  [[nodiscard]] Trial<dim> trial_of(const Cell& cell, const dealii::FEValues<dim>& values) const;

  [[nodiscard]] std::vector<Cell> cells_of(int layer) const;
  void place(int layer);
  void remove(int layer);
  void set_stress_of_ground();
  void distribute_dofs();
  void fix_supports();
  void hold_what_was_removed();
  void choose_linear_solver();

  template <class MatrixOf>
  void assemble(dealii::SparseMatrix<double>& matrix, const MatrixOf& matrix_of);
  void assemble_tangent();
  void assemble_elastic_stiffness(dealii::SparseMatrix<double>& matrix);
  void assemble_external();
  void assemble_unbalanced();
  [[nodiscard]] std::vector<dealii::Tensor<1, dim>> force_per_volume(const Cell& cell,
                                                                     const dealii::FEValues<dim>& values) const;
  [[nodiscard]] dealii::Vector<double> prescribed_increment() const;
  [[nodiscard]] dealii::Vector<double> tangent_times(const dealii::Vector<double>& increment) const;
  Equilibrium start(double share);
  void move_supports(Equilibrium& equilibrium);
  bool correct_increment(Equilibrium& equilibrium);
  [[nodiscard]] std::optional<dealii::Vector<double>> newton_step(dealii::Vector<double> forces);
  bool creep(const dealii::SparseMatrix<double>& elastic, double& viscosity, Equilibrium& equilibrium);
  [[nodiscard]] double misfit_of(const dealii::SparseMatrix<double>& elastic, double viscosity,
                                 const dealii::Vector<double>& step) const;
  [[nodiscard]] std::optional<dealii::Vector<double>> solve_linearised(dealii::Vector<double> forces);
  [[nodiscard]] bool balanced(const Equilibrium& equilibrium) const;
  void note_reactions(Equilibrium& equilibrium) const;
  [[nodiscard]] double linear_tolerance(const dealii::Vector<double>& forces) const;
  [[nodiscard]] double unbalanced_force() const;
  [[nodiscard]] double load() const;
  [[nodiscard]] double out_of_balance() const;
  [[nodiscard]] double base_reaction() const;
  [[nodiscard]] std::vector<double> support_reactions() const;

  exchange::FemLinearSolver choice_;
  std::unique_ptr<Formulation<dim>> formulation_;
  std::vector<double> densities_;           ///< (layers) as placed [kg/m3]
  std::vector<StateVariables> placed_with_; ///< (layers) what material remembers when it is placed
  double gravity_;                          ///< [m/s2]
  bool geometry_moves_;
  std::vector<exchange::StageEntry> stages_;
  LevelGround level_ground_;
  Loading loading_;
  SurfaceLoads<dim> surface_loads_;
  bool yields_, hardens_;
  Supports<dim> supports_;
  std::size_t n_supports_;
  Progress reached_, target_; ///< as accepted last, and of the increment that is being solved for
  double largest_load_ = 0.0; ///< of the increments accepted in this stage [N]

  static constexpr unsigned placed_element = 0, absent_element = 1; ///< of `elements_`
  dealii::Triangulation<dim> mesh_;
  dealii::hp::FECollection<dim> elements_;
  dealii::QGauss<dim> quadrature_;
  dealii::Quadrature<dim> load_quadrature_; ///< for external forces
  dealii::DoFHandler<dim> dofs_;
  std::vector<Cell> placed_;
  History<dim> history_;
  PlacedGeometry<dim> geometry_;

  std::vector<HeldDof> held_;
  dealii::AffineConstraints<double> standing_; ///< all that is held stays where it is
  dealii::SparsityPattern sparsity_;
  dealii::SparseMatrix<double> tangent_;
  std::unique_ptr<LinearSolver> linear_solver_; ///< for the layers placed so far
  dealii::Vector<double> increment_;            ///< nodal displacement since the last `accept` [m]
  dealii::Vector<double> external_;             ///< forces at all degrees of freedom [N]
  dealii::Vector<double> released_;             ///< forces at the start of a stage that are gone at its end [N]
  dealii::Vector<double> unbalanced_;           ///< external minus internal forces at all degrees of freedom [N]
  bool inside_out_ = false;                     ///< the increment has no stress
  bool prepared_ = false;                       ///< the linear solver, since the stage began
};

} // namespace settle::fem
