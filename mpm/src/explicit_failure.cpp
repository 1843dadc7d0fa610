#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "explicit_run.hpp"
#include "moves.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// In how many parts of `ramp_time` it is looked how far points have moved.
constexpr int looks_per_ramp = 200;

/// The state in equilibrium last.
template <class Space>
struct Onset {
  Body<Space> body;
  double share = 0.0; ///< of the stage
  StageReport report{};

  /// Leads the body back to it. Returns the report of the stage, which took so many steps and ends here.
  StageReport restore(Body<Space>& failed, std::int64_t steps) {
    failed = std::move(body);
    report.steps = steps;
    report.failed_at = share;
    return std::move(report);
  }
};

[[noreturn]] void give_up(const StageLoad& load, const exchange::ExplicitDynamic& settings,
                          const EquilibriumErrors& errors, double moved) {
  throw exchange::NotConverged(
      {.where = fmt::format("stage {}", load.number),
       .what = fmt::format("neither equilibrium nor failure within max_hold_time = {:g} s", settings.max_hold_time),
       .given = fmt::format("force error {:.3g}, energy error {:.3g}, no point moved by more than {:.3g} m",
                            errors.force, errors.energy, moved),
       .allowed = fmt::format("force error {:g}, energy error {:g}, or a point that moves by {:g} m",
                              settings.force_error, settings.energy_error, load.failure_distance),
       .remedy = "raise mpm.explicit.max_hold_time, or lower mpm.explicit.damping, which holds slides back"});
}

} // namespace

template <class Space>
StageReport load_until_failure(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings,
                               int threads) {
  ExplicitRun<Space> run(body, load, settings, threads);
  Onset<Space> onset{.body = body};
  const double ramp = load.grows() ? *settings.ramp_time : 0.0;
  const double between_looks = *settings.ramp_time / looks_per_ramp;
  double time = 0, moved = 0;
  for (double look_at = between_looks; time < ramp + settings.max_hold_time;) {
    const double share = ramp > 0.0 ? std::min(1.0, time / ramp) : 1.0;
    time += run.advance(between_looks, load.at(share));
    const bool in_equilibrium = run.errors().met(settings);
    if (time < look_at && !(in_equilibrium && share == 1.0)) continue;
    look_at = time + between_looks;
    run.end();
    if (in_equilibrium && share == 1.0) return run.report(load.at(1.0));
    if (in_equilibrium) onset = {.body = body, .share = share, .report = run.report(load.at(share))};
    moved = largest_move(onset.body.points, body.points);
    if (moved >= load.failure_distance) return onset.restore(body, run.steps());
  }
  give_up(load, settings, run.errors(), moved);
}

template <class Space>
RunOutReport run_out(Body<Space>& body, const StageLoad& load, const exchange::ExplicitDynamic& settings, int threads) {
  exchange::ExplicitDynamic sliding = settings;
  sliding.damping = settings.runout_damping;
  ExplicitRun<Space> run(body, load, sliding, threads);
  WorkOfMotion<Space::dim> work;
  run.audit(work);
  RunOutReport report;
  const Gravity full = load.at(1.0);
  while (report.duration < settings.max_hold_time && !report.at_rest) {
    report.duration += run.advance(settings.max_hold_time - report.duration, full);
    report.at_rest = run.errors().met(settings);
  }
  run.end();
  report.stage = run.report(full);
  report.external_work = work.external(), report.stress_work = work.stress();
  report.damping_loss = work.damping_loss();
  return report;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template StageReport load_until_failure(Body<Space>&, const StageLoad&, const exchange::ExplicitDynamic&, int);      \
  template RunOutReport run_out(Body<Space>&, const StageLoad&, const exchange::ExplicitDynamic&, int);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
