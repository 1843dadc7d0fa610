/// \file
/// A stage of the explicit scheme in progress.
#pragma once

#include <algorithm>
#include <cmath>

#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/loading.hpp"
#include "settle/mpm/nodal_forces.hpp"
#include "settle/mpm/viscous_damping.hpp"
#include "work_of_motion.hpp"

namespace settle::mpm {

/// The two figures that say how far a stage is from equilibrium.
struct EquilibriumErrors {
  double force = 0;  ///< sum|F_unbalanced| / sum|F_external|
  double energy = 0; ///< kinetic energy / work of external forces in this stage

  [[nodiscard]] bool met(const exchange::ExplicitDynamic& settings) const {
    return force <= settings.force_error && energy <= settings.energy_error;
  }
};

/// Time steps until somebody decides that the stage is over.
template <class Space>
class ExplicitRun {
public:
  /// Everything it is given outlives it.
  ExplicitRun(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings, int threads)
      : body_(body), load_(load), settings_(settings), step_(body, threads, load.loads != nullptr),
        viscous_(settings.damping) {}

  /// One step, not beyond `dt_max`. Returns its length [s].
  double advance(double dt_max, const Gravity& gravity) {
    step_.scatter(gravity);
    return finish_step(dt_max);
  }
  /// The same, after what is due has been refilled.
  double refill_and_advance(double dt_max, const Gravity& gravity) {
    if (load_.refill.columns.empty()) { // level: the surface is known without the points
      step_.scatter(gravity);
      if (!refill_may_be_due(body_, load_.refill, step_.column_heights())) return finish_step(dt_max);
    }
    refill();
    step_.scatter(gravity);
    return finish_step(dt_max);
  }
  int refill() {
    step_.gather();
    return refill_where_due(body_, load_.refill);
  }
  int close() {
    step_.gather();
    return close_gap(body_, load_.refill);
  }
  /// Hands the body over to others.
  void end() { step_.gather(); }
  /// From now on the work of all forces is summed.
  void audit(WorkOfMotion<Space::dim>& work) { work_ = &work; }

  [[nodiscard]] EquilibriumErrors errors() const {
    const double energy = kinetic_ == 0.0 ? 0.0 : kinetic_ / std::abs(external_work_);
    return {.force = sums_.unbalanced / sums_.external, .energy = energy};
  }
  /// `gravity`: as it acts now, for the supports' reactions in the state the body is in now.
  [[nodiscard]] StageReport report(const Gravity& gravity) {
    return {.steps = steps_,
            .linear_solves = 0,
            .out_of_balance = errors().force,
            .base_reaction = sums_.base_reaction,
            .in_equilibrium = errors().met(settings_),
            .reactions = reactions(gravity)};
  }

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] bool relaxes() const { return settings_.relaxation == exchange::Relaxation::viscous; }

private:
  Body<Space>& body_;
  const StageLoad& load_;
  const exchange::ExplicitDynamic& settings_;
  ExplicitStep<Space> step_;
  ViscousDamping<Space::dim> viscous_;
  WorkOfMotion<Space::dim>* work_ = nullptr;
  ForceSums sums_;
  double external_work_ = 0, kinetic_ = 0;
  std::int64_t steps_ = 0;

  [[nodiscard]] Eigen::VectorXd reactions(const Gravity& gravity) {
    step_.scatter(gravity);
    Eigen::VectorXd internal(Space::dim * body_.space.n_nodes()), external = internal;
    for (int n = 0; n < body_.space.n_nodes(); ++n) {
      const NodeState<Space::dim> node = step_.node(n);
      internal.segment<Space::dim>(Space::dim * n) = node.internal;
      external.segment<Space::dim>(Space::dim * n) = node.external;
    }
    return support_forces(body_, internal, external);
  }
  StepEnergy step(double dt) {
    if (work_ != nullptr) work_->know_forces(step_.nodes());
    sums_ = step_.accelerate(settings_.damping);
    const StepEnergy energy = step_.displace(dt, dt);
    if (work_ != nullptr) work_->know_displacements(step_.nodes(), body_.fixed);
    step_.move();
    return energy;
  }
  StepEnergy relax(double dt) {
    viscous_.know_forces(step_.nodes());
    sums_ = step_.accelerate(0.0);
    const StepEnergy energy = step_.displace(viscous_.kick(dt), dt, viscous_.kept(dt));
    viscous_.know_displacements(step_.nodes());
    step_.move();
    return energy;
  }
  double finish_step(double dt_max) {
    const double dt = std::min(dt_max, step_.stable_time_step(settings_.courant));
    const StepEnergy energy = relaxes() ? relax(dt) : step(dt);
    external_work_ += energy.external_work;
    kinetic_ = energy.kinetic;
    ++steps_;
    return dt;
  }
};

} // namespace settle::mpm
