#include <algorithm>
#include <cmath>
#include <limits>

#include "cell_terms.hpp"
#include "mesh.hpp"
#include "staged_problem.hpp"

namespace settle::fem {
namespace {

/// A direct solve leaves about 1e-14; corrections go on down to this where round-off of a fine mesh leaves more.
constexpr double residual_aimed_at = 1e-12;
/// What round-off may leave on the finest meshes: grows with (height / cell size)^2.
constexpr double residual_accepted = 1e-9;
constexpr unsigned linear_solves_allowed = 25;
/// Of a Newton step: a thousandth of it, where nothing longer brings the residual down, leads nowhere.
constexpr unsigned step_halvings_allowed = 10;
/// A step has to bring the residual down by this fraction of its own length.
constexpr double sufficient_decrease = 1e-4;

} // namespace

bool Equilibrium::reached() const {
  return out_of_balance() <= residual_accepted;
}

template <int dim>
Equilibrium StagedProblem<dim>::solve(double share) {
  target_ = {.stage = reached_.stage, .share = share};
  increment_ = 0.0;
  assemble_external();
  assemble_unbalanced();
  Equilibrium equilibrium;
  move_supports(equilibrium);
  equilibrium.residuals = {out_of_balance()};
  bool goes_on = !inside_out_;
  while (goes_on && equilibrium.out_of_balance() > residual_aimed_at &&
         equilibrium.linear_solves < linear_solves_allowed)
    goes_on = correct_increment(equilibrium);
  equilibrium.base_reaction = base_reaction();
  return equilibrium;
}

/// Where supports follow a motion, the first Newton step of an increment: everything else goes with them. It is taken
/// whole, because there is no residual yet for supports that are not where they belong.
template <int dim>
void StagedProblem<dim>::move_supports(Equilibrium& equilibrium) {
  const dealii::Vector<double> prescribed = prescribed_increment();
  if (prescribed.linfty_norm() == 0.0) return;
  dealii::Vector<double> forces = unbalanced_;
  forces -= tangent_times(prescribed);
  increment_ = newton_step(std::move(forces));
  increment_ += prescribed;
  ++equilibrium.linear_solves;
  assemble_unbalanced();
}

/// One Newton step, halved until the residual falls. Returns false, the increment as it was, where it does not.
template <int dim>
bool StagedProblem<dim>::correct_increment(Equilibrium& equilibrium) {
  const dealii::Vector<double> step = newton_step(unbalanced_);
  ++equilibrium.linear_solves;
  const dealii::Vector<double> start = increment_;
  const double before = unbalanced_force();
  double length = 1.0;
  for (unsigned halvings = 0; halvings <= step_halvings_allowed; ++halvings, length /= 2.0) {
    increment_ = start;
    increment_.add(length, step);
    assemble_unbalanced();
    if (inside_out_ || unbalanced_force() > (1.0 - sufficient_decrease * length) * before) continue;
    equilibrium.residuals.push_back(out_of_balance());
    return true;
  }
  increment_ = start;
  assemble_unbalanced();
  return false;
}

/// The displacement that these forces cause by the tangent, where nothing that is held moves.
template <int dim>
dealii::Vector<double> StagedProblem<dim>::newton_step(dealii::Vector<double> forces) {
  if (!factorized_ || !formulation_->linear()) factorize_tangent();
  standing_.set_zero(forces);
  inverse_.solve(forces);
  standing_.distribute(forces);
  return forces;
}

/// At degrees of freedom that follow the motion; zero elsewhere.
template <int dim>
dealii::Vector<double> StagedProblem<dim>::prescribed_increment() const {
  dealii::Vector<double> prescribed(dofs_.n_dofs());
  for (const HeldDof& dof : held_) {
    if (!dof.follows_motion) continue;
    prescribed[dof.index] = loading_.displacement_in_stage(dof.point, target_)[dof.axis] -
                            loading_.displacement_in_stage(dof.point, reached_)[dof.axis];
  }
  return prescribed;
}

/// Forces at all degrees of freedom, by the tangent in the state of the increment as it is.
template <int dim>
dealii::Vector<double> StagedProblem<dim>::tangent_times(const dealii::Vector<double>& increment) const {
  dealii::Vector<double> forces(dofs_.n_dofs());
  dealii::FEValues<dim> values = cell_values();
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  dealii::Vector<double> at_cell(element().n_dofs_per_cell()), force(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    cell->get_dof_values(increment, at_cell);
    if (at_cell.linfty_norm() == 0.0) continue;
    values.reinit(cell);
    cell->get_dof_indices(indices);
    formulation_->tangent(trial_of(cell, values)).vmult(force, at_cell);
    forces.add(indices, force);
  }
  return forces;
}

template <int dim>
void StagedProblem<dim>::factorize_tangent() {
  tangent_ = 0.0;
  dealii::FEValues<dim> values = cell_values();
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    standing_.distribute_local_to_global(formulation_->tangent(trial_of(cell, values)), indices, tangent_);
  }
  inverse_.initialize(tangent_);
  factorized_ = true;
}

/// Of the material as placed: mass is what gravity and the motion act on, and it stays.
template <int dim>
auto StagedProblem<dim>::force_per_volume(const Cell& cell, const dealii::FEValues<dim>& values) const
    -> std::vector<dealii::Tensor<1, dim>> {
  dealii::Tensor<1, dim> weight;
  weight[dim - 1] = -density_ * gravity_ * loading_.gravity_factor(layer_of(cell), target_);
  std::vector<dealii::Tensor<1, dim>> forces(values.n_quadrature_points, weight);
  if (!loading_.drives()) return forces;
  for (const unsigned q : values.quadrature_point_indices()) {
    const dealii::Point<dim>& position = values.quadrature_point(q);
    const exchange::PlanePoint driving = loading_.driving_force({{position[0], position[1]}, layer_of(cell)}, target_);
    for (unsigned axis = 0; axis < 2; ++axis)
      forces[q][axis] += density_ * driving[axis];
  }
  return forces;
}

template <int dim>
void StagedProblem<dim>::assemble_external() {
  external_ = 0.0;
  dealii::FEValues<dim> values = cell_values(load_quadrature_);
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    external_.add(indices, body_force(values, force_per_volume(cell, values)));
  }
}

template <int dim>
void StagedProblem<dim>::assemble_unbalanced() {
  unbalanced_ = external_;
  inside_out_ = false;
  dealii::FEValues<dim> values = cell_values();
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    const Trial<dim> trial = trial_of(cell, values);
    const auto stress = formulation_->stress(trial);
    inside_out_ = inside_out_ || !stress;
    if (!stress) continue;
    dealii::Vector<double> force = formulation_->internal_force(trial, *stress);
    force *= -1.0;
    unbalanced_.add(indices, force);
  }
}

/// At free degrees of freedom [N].
template <int dim>
double StagedProblem<dim>::unbalanced_force() const {
  dealii::Vector<double> unbalanced = unbalanced_;
  standing_.set_zero(unbalanced);
  return unbalanced.l2_norm();
}

/// What a residual is small against [N]: the forces given at free degrees of freedom, with those by which supports that
/// follow a motion drive the body. Supports that stand answer to the load and are no part of it.
template <int dim>
double StagedProblem<dim>::load() const {
  dealii::Vector<double> load = external_;
  standing_.set_zero(load);
  for (const HeldDof& dof : held_)
    if (dof.follows_motion) load[dof.index] = unbalanced_[dof.index];
  return load.l2_norm();
}

/// Against the largest load of the stage so far, because round-off of a motion stays where its load goes back to zero.
template <int dim>
double StagedProblem<dim>::out_of_balance() const {
  if (inside_out_) return std::numeric_limits<double>::infinity();
  const double unbalanced = unbalanced_force();
  return unbalanced == 0.0 ? 0.0 : unbalanced / std::max(load(), largest_load_);
}

/// What supports exert is what is missing there: internal minus external forces.
template <int dim>
double StagedProblem<dim>::base_reaction() const {
  double reaction = 0.0;
  for (const HeldDof& dof : held_)
    if (dof.axis == dim - 1) reaction -= unbalanced_[dof.index];
  return reaction;
}

template Equilibrium StagedProblem<2>::solve(double);
template Equilibrium StagedProblem<3>::solve(double);
template double StagedProblem<2>::load() const;
template double StagedProblem<3>::load() const;

} // namespace settle::fem
