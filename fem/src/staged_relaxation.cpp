// Pseudo-transient continuation (Kelley & Keyes 1998): the body creeps, K_e du/dt = what is out of balance, with its
// elastic stiffness K_e as viscosity, until nothing is. What balances is the same as in Newton's method; only the way
// there differs. A step of length 1/v, linearly implicit, solves (K + v K_e) step = unbalanced force: Newton's step for
// v = 0, one of initial stiffness where v is large. It need not bring the residual down: where stresses are thrown
// over in a band without dilation, the way to the next equilibrium leads through larger ones.
#include <algorithm>
#include <limits>

#include "staged_problem.hpp"

namespace settle::fem {
namespace {

constexpr unsigned linear_solves_to_relax = 200;

/// v: the first, the one below which a step is Newton's, and the one beyond which no step leads anywhere.
constexpr double first_viscosity = 0.1, least_viscosity = 1e-4, largest_viscosity = 1e3;
/// Of a step: what is out of balance after it less v K_e step, which linearity would leave, over what was before.
constexpr double misfit_aimed_at = 0.3, misfit_accepted = 1.0;
/// Of the viscosity from one step to the next.
constexpr double largest_change = 5.0;

double adapted(double viscosity, double misfit) {
  const double change = std::clamp(misfit / misfit_aimed_at, 1.0 / largest_change, largest_change);
  const double next = change * std::max(viscosity, least_viscosity);
  return next < least_viscosity ? 0.0 : next;
}

} // namespace

template <int dim>
Equilibrium StagedProblem<dim>::relax(double share) {
  Equilibrium equilibrium = start(share);
  dealii::SparseMatrix<double> elastic(sparsity_);
  assemble_elastic_stiffness(elastic);
  double viscosity = first_viscosity;
  bool goes_on = !inside_out_ && !equilibrium.linear_solver_gave_up;
  while (goes_on && !balanced(equilibrium) && equilibrium.linear_solves < linear_solves_to_relax)
    goes_on = creep(elastic, viscosity, equilibrium);
  note_reactions(equilibrium);
  return equilibrium;
}

/// One step, not taken where it is too long for what is linear. Returns false where none leads on: round-off, or
/// viscosity beyond bounds.
template <int dim>
bool StagedProblem<dim>::creep(const dealii::SparseMatrix<double>& elastic, double& viscosity,
                               Equilibrium& equilibrium) {
  ++equilibrium.linear_solves;
  const dealii::Vector<double> start = increment_, start_unbalanced = unbalanced_;
  const double before = out_of_balance(), force = unbalanced_force();
  assemble_tangent();
  tangent_.add(viscosity, elastic);
  linear_solver_->prepare(tangent_);
  double misfit = std::numeric_limits<double>::infinity();
  if (const std::optional<dealii::Vector<double>> step = solve_linearised(unbalanced_)) {
    increment_ += *step;
    assemble_unbalanced();
    if (!inside_out_) misfit = misfit_of(elastic, viscosity, *step) / force;
  }
  viscosity = adapted(viscosity, misfit);
  const bool round_off = equilibrium.reached() && !(out_of_balance() < before);
  if (misfit <= misfit_accepted && !round_off) {
    equilibrium.residuals.push_back(out_of_balance());
    return true;
  }
  increment_ = start;
  unbalanced_ = start_unbalanced;
  inside_out_ = false;
  return !round_off && viscosity <= largest_viscosity;
}

/// [N], at free degrees of freedom.
template <int dim>
double StagedProblem<dim>::misfit_of(const dealii::SparseMatrix<double>& elastic, double viscosity,
                                     const dealii::Vector<double>& step) const {
  dealii::Vector<double> misfit(step.size());
  elastic.vmult(misfit, step);
  misfit.sadd(-viscosity, 1.0, unbalanced_);
  standing_.set_zero(misfit);
  return misfit.l2_norm();
}

template Equilibrium StagedProblem<2>::relax(double);
template Equilibrium StagedProblem<3>::relax(double);

} // namespace settle::fem
