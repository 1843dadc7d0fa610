#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/loading.hpp"
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
  Run(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings)
      : body_(body), load_(load), settings_(settings), nodes_(static_cast<std::size_t>(body.space.n_nodes())),
        viscous_(settings.damping) {}

  /// One step, not beyond `dt_max`, with the layer's gravity at `factor`. Returns its length [s].
  double advance(double dt_max, double factor) {
    const Gravity gravity = load_.at(factor);
    const double dt = std::min(dt_max, stable_time_step(body_, settings_.courant));
    const StepEnergy energy = relaxes() ? relax(gravity, dt) : step(gravity, dt);
    external_work_ += energy.external_work;
    kinetic_ = energy.kinetic;
    ++steps_;
    return dt;
  }

  [[nodiscard]] Errors errors() const {
    return {.force = sums_.unbalanced / sums_.external, .energy = kinetic_ / std::abs(external_work_)};
  }
  [[nodiscard]] StageReport report() const {
    return {.steps = steps_,
            .linear_solves = 0,
            .out_of_balance = errors().force,
            .base_reaction = sums_.base_reaction,
            .in_equilibrium = errors().met(settings_)};
  }

  [[nodiscard]] bool relaxes() const { return settings_.relaxation == exchange::Relaxation::viscous; }

private:
  StepEnergy step(const Gravity& gravity, double dt) {
    scatter_points(body_, gravity, nodes_);
    sums_ = update_nodes(body_, settings_.damping, nodes_);
    update_velocity_and_remap(body_, dt, nodes_);
    return update_stress_and_move(body_, gravity, dt, nodes_);
  }
  StepEnergy relax(const Gravity& gravity, double dt) {
    scatter_points(body_, gravity, nodes_);
    viscous_.know_forces(nodes_);
    sums_ = update_nodes(body_, 0.0, nodes_);
    update_velocity_and_remap(body_, viscous_.kick(dt), nodes_);
    const StepEnergy energy = update_stress_and_move(body_, gravity, dt, nodes_);
    viscous_.know_displacements(nodes_);
    viscous_.damp(body_.points, dt);
    return energy;
  }

  Body<Space>& body_;
  const StageLoad& load_;
  const exchange::ExplicitDynamic& settings_;
  Nodes<Space::dim> nodes_;
  ViscousDamping<Space::dim> viscous_;
  ForceSums sums_;
  double external_work_ = 0, kinetic_ = 0;
  std::int64_t steps_ = 0;
};

[[noreturn]] void give_up(const StageLoad& load, const exchange::ExplicitDynamic& settings, const Errors& errors) {
  throw exchange::NotConverged(
      {.where = fmt::format("stage {}", load.layer),
       .what = fmt::format("no equilibrium within max_hold_time = {:g} s", settings.max_hold_time),
       .given = fmt::format("force error {:.3g}, energy error {:.3g}", errors.force, errors.energy),
       .allowed = fmt::format("force error {:g}, energy error {:g}", settings.force_error, settings.energy_error),
       .remedy = "raise mpm.explicit.max_hold_time or ramp_time, or use mpm.integration = \"mixed\""});
}

template <class Space>
void ramp(Run<Space>& run, Body<Space>& body, const StageLoad& load, double ramp_time) {
  for (double time = 0; time < ramp_time;) {
    const double left = ramp_time - time;
    time += run.advance(left, std::min(1.0, time / ramp_time));
    refill_where_due(body, load.refill);
  }
}

template <class Space>
void hold_until_equilibrium(Run<Space>& run, Body<Space>& body, const StageLoad& load,
                            const exchange::ExplicitDynamic& settings) {
  for (double time = 0; time < settings.max_hold_time;) {
    time += run.advance(settings.max_hold_time, 1.0);
    if (run.relaxes()) refill_where_due(body, load.refill);
    if (!run.errors().met(settings)) continue;
    if (close_gap(body, load.refill) == 0) return;
    time = 0;
  }
  give_up(load, settings, run.errors());
}

} // namespace

template <class Space>
StageReport load_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings) {
  Run<Space> run(body, load, settings);
  if (settings.ramp_time) ramp(run, body, load, *settings.ramp_time);
  if (!settings.hold) {
    hold_until_equilibrium(run, body, load, settings);
    return run.report();
  }
  for (double time = 0; time < *settings.hold;) {
    time += run.advance(*settings.hold - time, 1.0);
    refill_where_due(body, load.refill);
  }
  return run.report();
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template StageReport load_explicit(Body<Space>&, const StageLoad&, const exchange::ExplicitDynamic&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
