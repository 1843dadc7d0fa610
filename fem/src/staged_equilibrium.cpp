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
Equilibrium StagedProblem<dim>::solve(double gravity_factor) {
  increment_ = 0.0;
  assemble_forces(gravity_factor);
  Equilibrium equilibrium{.residuals = {out_of_balance()}};
  bool goes_on = !inside_out_;
  while (goes_on && equilibrium.out_of_balance() > residual_aimed_at &&
         equilibrium.linear_solves < linear_solves_allowed)
    goes_on = correct_increment(gravity_factor, equilibrium);
  equilibrium.base_reaction = base_reaction();
  return equilibrium;
}

/// One Newton step, halved until the residual falls. Returns false, the increment as it was, where it does not.
template <int dim>
bool StagedProblem<dim>::correct_increment(double gravity_factor, Equilibrium& equilibrium) {
  if (!factorized_ || !formulation_->linear()) factorize_tangent();
  dealii::Vector<double> step = unbalanced_;
  supports_.set_zero(step);
  inverse_.solve(step);
  supports_.distribute(step);
  ++equilibrium.linear_solves;
  const dealii::Vector<double> start = increment_;
  const double before = equilibrium.out_of_balance();
  double length = 1.0;
  for (unsigned halvings = 0; halvings <= step_halvings_allowed; ++halvings, length /= 2.0) {
    increment_ = start;
    increment_.add(length, step);
    assemble_forces(gravity_factor);
    if (out_of_balance() > (1.0 - sufficient_decrease * length) * before) continue;
    equilibrium.residuals.push_back(out_of_balance());
    return true;
  }
  increment_ = start;
  assemble_forces(gravity_factor);
  return false;
}

template <int dim>
void StagedProblem<dim>::factorize_tangent() {
  tangent_ = 0.0;
  dealii::FEValues<dim> values = cell_values();
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    supports_.distribute_local_to_global(formulation_->tangent(trial_of(cell, values)), indices, tangent_);
  }
  inverse_.initialize(tangent_);
  factorized_ = true;
}

template <int dim>
void StagedProblem<dim>::assemble_forces(double gravity_factor) {
  external_ = 0.0;
  unbalanced_ = 0.0;
  inside_out_ = false;
  dealii::Tensor<1, dim> unit_weight; // of the material as placed: mass is what gravity acts on, and it stays
  unit_weight[dim - 1] = -density_ * gravity_;
  dealii::FEValues<dim> values = cell_values();
  std::vector<dealii::types::global_dof_index> indices(element().n_dofs_per_cell());
  for (const Cell& cell : placed_cells()) {
    values.reinit(cell);
    cell->get_dof_indices(indices);
    const double factor = layer_of(cell) == layer_ ? gravity_factor : 1.0;
    dealii::Vector<double> force = body_force(values, factor * unit_weight);
    external_.add(indices, force);
    const Trial<dim> trial = trial_of(cell, values);
    const auto stress = formulation_->stress(trial);
    inside_out_ = inside_out_ || !stress;
    if (stress) force -= formulation_->internal_force(trial, *stress);
    unbalanced_.add(indices, force);
  }
}

template <int dim>
double StagedProblem<dim>::out_of_balance() const {
  if (inside_out_) return std::numeric_limits<double>::infinity();
  dealii::Vector<double> unbalanced = unbalanced_;
  dealii::Vector<double> external = external_;
  supports_.set_zero(unbalanced);
  supports_.set_zero(external);
  return unbalanced.l2_norm() / external.l2_norm();
}

/// What the base exerts is what is missing there: internal minus external forces.
template <int dim>
double StagedProblem<dim>::base_reaction() const {
  double reaction = 0.0;
  for (const auto dof : base_dofs_)
    reaction -= unbalanced_[dof];
  return reaction;
}

template Equilibrium StagedProblem<2>::solve(double);
template Equilibrium StagedProblem<3>::solve(double);

} // namespace settle::fem
