#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/loading.hpp"
#include "settle/mpm/nodal_forces.hpp"
#include "settle/mpm/spaces.hpp"
#include "settle/mpm/viscous_damping.hpp"

namespace settle::mpm {

namespace {

/// The two figures that say how far a stage is from equilibrium.
struct Errors {
  double force = 0;  ///< sum|F_unbalanced| / sum|F_external|
  double energy = 0; ///< kinetic energy / work of external forces in this stage

  [[nodiscard]] bool met(const exchange::ExplicitDynamic& settings) const {
    return force <= settings.force_error && energy <= settings.energy_error;
  }
};

/// A stage in progress: time steps until somebody decides that it is over.
template <class Space>
class Run {
public:
  Run(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings, int threads)
      : body_(body), load_(load), settings_(settings), step_(body, threads), viscous_(settings.damping) {}

  /// One step, not beyond `dt_max`. Returns its length [s].
  double advance(double dt_max, const Gravity& gravity) {
    step_.scatter(gravity);
    return finish_step(dt_max);
  }
  /// The same, after what is due has been refilled.
  double refill_and_advance(double dt_max, const Gravity& gravity) {
    step_.scatter(gravity);
    if (refill_may_be_due(body_, load_.refill, step_.column_heights())) {
      step_.gather();
      refill_where_due(body_, load_.refill);
      step_.scatter(gravity);
    }
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

  [[nodiscard]] Errors errors() const {
    const double energy = kinetic_ == 0.0 ? 0.0 : kinetic_ / std::abs(external_work_);
    return {.force = sums_.unbalanced / sums_.external, .energy = energy};
  }
  [[nodiscard]] StageReport report() {
    return {.steps = steps_,
            .linear_solves = 0,
            .out_of_balance = errors().force,
            .base_reaction = sums_.base_reaction,
            .in_equilibrium = errors().met(settings_),
            .reactions = reactions()};
  }

  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] bool relaxes() const { return settings_.relaxation == exchange::Relaxation::viscous; }

private:
  Body<Space>& body_;
  const StageLoad& load_;
  const exchange::ExplicitDynamic& settings_;
  ExplicitStep<Space> step_;
  ViscousDamping<Space::dim> viscous_;
  ForceSums sums_;
  double external_work_ = 0, kinetic_ = 0;
  std::int64_t steps_ = 0;

  /// In the state the body is in now.
  [[nodiscard]] Eigen::VectorXd reactions() {
    step_.scatter(load_.at(1.0));
    Eigen::VectorXd internal(Space::dim * body_.space.n_nodes()), external = internal;
    for (int n = 0; n < body_.space.n_nodes(); ++n) {
      const NodeState<Space::dim> node = step_.node(n);
      internal.segment<Space::dim>(Space::dim * n) = node.internal;
      external.segment<Space::dim>(Space::dim * n) = node.external;
    }
    return support_forces(body_, internal, external);
  }
  StepEnergy step(double dt) {
    sums_ = step_.accelerate(settings_.damping);
    const StepEnergy energy = step_.displace(dt, dt);
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

[[noreturn]] void give_up(const StageLoad& load, const exchange::ExplicitDynamic& settings, const Errors& errors) {
  throw exchange::NotConverged(
      {.where = fmt::format("stage {}", load.number),
       .what = fmt::format("no equilibrium within max_hold_time = {:g} s", settings.max_hold_time),
       .given = fmt::format("force error {:.3g}, energy error {:.3g}", errors.force, errors.energy),
       .allowed = fmt::format("force error {:g}, energy error {:g}", settings.force_error, settings.energy_error),
       .remedy = "raise mpm.explicit.max_hold_time or ramp_time, or use mpm.integration = \"mixed\""});
}

/// Steps for a given time, refilled after each of them; `gravity(time)`: as it acts.
template <class Space, class GravityAt>
void advance_for(Run<Space>& run, double duration, GravityAt&& gravity) {
  double time = 0;
  if (time < duration) time += run.advance(duration, gravity(0.0));
  while (time < duration)
    time += run.refill_and_advance(duration - time, gravity(time));
  run.refill();
}

template <class Space>
void hold_until_equilibrium(Run<Space>& run, const StageLoad& load, const exchange::ExplicitDynamic& settings) {
  const Gravity full = load.at(1.0);
  for (double time = 0; time < settings.max_hold_time;) {
    const bool refills = run.relaxes() && time > 0;
    time += refills ? run.refill_and_advance(settings.max_hold_time, full) : run.advance(settings.max_hold_time, full);
    if (!run.errors().met(settings)) continue;
    if (run.relaxes()) run.refill();
    if (run.close() == 0) return;
    time = 0;
  }
  give_up(load, settings, run.errors());
}

} // namespace

template <class Space>
StageReport load_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          int threads) {
  Run<Space> run(body, load, settings, threads);
  if (const auto ramp = settings.ramp_time; ramp && load.grows())
    advance_for(run, *ramp, [&](double time) { return load.at(std::min(1.0, time / *ramp)); });
  if (settings.hold)
    advance_for(run, *settings.hold, [&](double) { return load.at(1.0); });
  else
    hold_until_equilibrium(run, load, settings);
  run.end();
  return run.report();
}

template <class Space>
StageReport fade_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          int threads) {
  Run<Space> run(body, load, settings, threads);
  if (const auto ramp = settings.ramp_time)
    advance_for(run, *ramp, [&](double time) { return load.fading(1.0 - std::min(1.0, time / *ramp)); });
  run.end();
  return {.steps = run.steps()};
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template StageReport load_explicit(Body<Space>&, const StageLoad&, const exchange::ExplicitDynamic&, int);           \
  template StageReport fade_explicit(Body<Space>&, const StageLoad&, const exchange::ExplicitDynamic&, int);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
