#include <algorithm>
#include <cmath>
#include <limits>

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
/// An iterative solver leaves this share of the forces that a Newton step is to remove. The steps to come have to
/// correct the step anyway ...
constexpr double share_left_of_a_step = 1e-6;
/// ... except where the problem is linear.
constexpr double share_left_of_the_only_step = 1e-13;

} // namespace

bool Equilibrium::reached() const {
  return out_of_balance() <= residual_accepted;
}

template <int dim>
Equilibrium StagedProblem<dim>::solve(double share) {
  Equilibrium equilibrium = start(share);
  bool goes_on = !inside_out_ && !equilibrium.linear_solver_gave_up;
  while (goes_on && !balanced(equilibrium) && equilibrium.linear_solves < linear_solves_allowed)
    goes_on = correct_increment(equilibrium);
  note_reactions(equilibrium);
  return equilibrium;
}

/// Of an increment, supports where they belong.
template <int dim>
Equilibrium StagedProblem<dim>::start(double share) {
  target_ = {.stage = reached_.stage, .share = share};
  increment_ = 0.0;
  assemble_external();
  assemble_unbalanced();
  Equilibrium equilibrium;
  move_supports(equilibrium);
  equilibrium.residuals = {out_of_balance()};
  return equilibrium;
}

/// As well as is aimed at.
template <int dim>
bool StagedProblem<dim>::balanced(const Equilibrium& equilibrium) const {
  return equilibrium.out_of_balance() <= residual_aimed_at;
}

template <int dim>
void StagedProblem<dim>::note_reactions(Equilibrium& equilibrium) const {
  equilibrium.base_reaction = base_reaction();
  equilibrium.support_reactions = support_reactions();
}

/// Where supports follow a motion, the first Newton step of an increment: everything else goes with them. It is taken
/// whole, because there is no residual yet for supports that are not where they belong.
template <int dim>
void StagedProblem<dim>::move_supports(Equilibrium& equilibrium) {
  const dealii::Vector<double> prescribed = prescribed_increment();
  if (prescribed.linfty_norm() == 0.0) return;
  dealii::Vector<double> forces = unbalanced_;
  forces -= tangent_times(prescribed);
  ++equilibrium.linear_solves;
  const std::optional<dealii::Vector<double>> step = newton_step(std::move(forces));
  equilibrium.linear_solver_gave_up = !step;
  if (!step) return;
  increment_ = *step;
  increment_ += prescribed;
  assemble_unbalanced();
}

/// One Newton step, halved until the residual falls; what is in equilibrium already is tried once, because it is
/// round-off that does not fall. Returns false, the increment as it was, where there is no such step.
template <int dim>
bool StagedProblem<dim>::correct_increment(Equilibrium& equilibrium) {
  ++equilibrium.linear_solves;
  const std::optional<dealii::Vector<double>> step = newton_step(unbalanced_);
  equilibrium.linear_solver_gave_up = !step;
  if (!step) return false;
  const dealii::Vector<double> start = increment_, start_unbalanced = unbalanced_;
  const double before = unbalanced_force();
  const unsigned halvings_allowed = equilibrium.reached() ? 0 : step_halvings_allowed;
  double length = 1.0;
  for (unsigned halvings = 0; halvings <= halvings_allowed; ++halvings, length /= 2.0) {
    increment_ = start;
    increment_.add(length, *step);
    assemble_unbalanced();
    if (inside_out_ || unbalanced_force() > (1.0 - sufficient_decrease * length) * before) continue;
    equilibrium.residuals.push_back(out_of_balance());
    return true;
  }
  increment_ = start;
  unbalanced_ = start_unbalanced;
  inside_out_ = false;
  return false;
}

/// The displacement that these forces cause by the tangent, where nothing that is held moves; nothing where the linear
/// solver does not find it.
template <int dim>
std::optional<dealii::Vector<double>> StagedProblem<dim>::newton_step(dealii::Vector<double> forces) {
  if (!prepared_ || !formulation_->linear()) {
    assemble_tangent();
    linear_solver_->prepare(tangent_);
    prepared_ = true;
  }
  return solve_linearised(std::move(forces));
}

/// By the matrix that the linear solver is prepared for.
template <int dim>
std::optional<dealii::Vector<double>> StagedProblem<dim>::solve_linearised(dealii::Vector<double> forces) {
  standing_.set_zero(forces);
  std::optional<dealii::Vector<double>> step = linear_solver_->solve(forces, linear_tolerance(forces));
  if (step) standing_.distribute(*step);
  return step;
}

/// What an iterative solver may leave of these forces [N]: no digits that the increment does not need.
template <int dim>
double StagedProblem<dim>::linear_tolerance(const dealii::Vector<double>& forces) const {
  const double share = formulation_->linear() ? share_left_of_the_only_step : share_left_of_a_step;
  return std::max(share * forces.l2_norm(), residual_aimed_at / 2.0 * std::max(load(), largest_load_));
}

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

template <int dim>
std::vector<double> StagedProblem<dim>::support_reactions() const {
  std::vector<double> reactions(n_supports_ * dim);
  for (const HeldDof& dof : held_)
    if (dof.support) reactions[*dof.support * dim + dof.axis] -= unbalanced_[dof.index];
  return reactions;
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template Equilibrium StagedProblem<dim>::solve(double);                                                              \
  template Equilibrium StagedProblem<dim>::start(double);                                                              \
  template bool StagedProblem<dim>::balanced(const Equilibrium&) const;                                                \
  template void StagedProblem<dim>::note_reactions(Equilibrium&) const;                                                \
  template std::optional<dealii::Vector<double>> StagedProblem<dim>::solve_linearised(dealii::Vector<double>);         \
  template double StagedProblem<dim>::unbalanced_force() const;                                                        \
  template double StagedProblem<dim>::out_of_balance() const;                                                          \
  template double StagedProblem<dim>::load() const;
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)
#undef SETTLE_INSTANTIATE

} // namespace settle::fem
