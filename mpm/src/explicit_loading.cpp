#include <algorithm>

#include <fmt/format.h>

#include "explicit_run.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

[[noreturn]] void give_up(const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          const EquilibriumErrors& errors) {
  throw exchange::NotConverged(
      {.where = fmt::format("stage {}", load.number),
       .what = fmt::format("no equilibrium within max_hold_time = {:g} s", settings.max_hold_time),
       .given = fmt::format("force error {:.3g}, energy error {:.3g}", errors.force, errors.energy),
       .allowed = fmt::format("force error {:g}, energy error {:g}", settings.force_error, settings.energy_error),
       .remedy = "raise mpm.explicit.max_hold_time or ramp_time, or use mpm.integration = \"mixed\""});
}

/// Steps for a given time, refilled after each of them; `gravity(time)`: as it acts.
template <class Space, class GravityAt>
void advance_for(ExplicitRun<Space>& run, double duration, GravityAt&& gravity) {
  double time = 0;
  if (time < duration) time += run.advance(duration, gravity(0.0));
  while (time < duration)
    time += run.refill_and_advance(duration - time, gravity(time));
  run.refill();
}

template <class Space>
void hold_until_equilibrium(ExplicitRun<Space>& run, const StageLoad& load, const exchange::ExplicitDynamic& settings) {
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
  ExplicitRun<Space> run(body, load, settings, threads);
  if (const auto ramp = settings.ramp_time; ramp && load.grows())
    advance_for(run, *ramp, [&](double time) { return load.at(std::min(1.0, time / *ramp)); });
  if (settings.hold)
    advance_for(run, *settings.hold, [&](double) { return load.at(1.0); });
  else
    hold_until_equilibrium(run, load, settings);
  run.end();
  return run.report(load.at(1.0));
}

template <class Space>
StageReport fade_explicit(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          int threads) {
  ExplicitRun<Space> run(body, load, settings, threads);
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
