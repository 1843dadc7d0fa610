#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "settle/compare/judge.hpp"

namespace settle::compare {
namespace {

using exchange::RunOut;

/// A figure of a run-out that should be zero.
struct RunOutAudit {
  const char* what;
  double value = 0, limit = 0;
  const char* scale;
  const char* why;
};

double lost(double before, double after) {
  return std::abs(after - before) / before;
}

RunOutAudit reaction_at_rest(const exchange::Case& study, const exchange::Failure& failure) {
  const exchange::Stage& state = failure.run_out->state;
  const double carried = state.weight + surface_load(study, failure.stage);
  return {"base reaction = weight after the run-out", std::abs(state.base_reaction - carried) / std::abs(carried), 2e-3,
          "weight", "a damped explicit scheme stops at a force error of 1e-3, not at zero"};
}

std::vector<RunOutAudit> audits_of(const RunOut& run_out) {
  constexpr double round_off = 1e-12;
  const auto points_before = static_cast<double>(run_out.points_before);
  const auto points = static_cast<double>(run_out.state.points.size());
  return {
      {"the run-out loses nothing",
       std::max(lost(run_out.mass_before, run_out.state.mass), lost(points_before, points)), round_off,
       "mass and number of points before", "points move, none is made or lost: round-off of the sum"},
      {"the run-out ends at rest", run_out.at_rest ? 0.0 : 1.0, 0.0, "run-outs that do not", "the case asks for it"},
      {"work of gravity = stress work + damping + kinetic energy in the run-out",
       std::abs(run_out.unaccounted()) / std::abs(run_out.external_work), 0.01, "work of gravity and loads",
       "works are of second order in the time step; points that cross cells: 0.06 % on a coarse grid"}};
}

} // namespace

std::vector<Verdict> judge_run_out(const RunOutcome& run) {
  std::vector<Verdict> verdicts;
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result || !solver.result->failure || !solver.result->failure->run_out) continue;
    const exchange::Failure& failure = *solver.result->failure;
    std::vector<RunOutAudit> all = audits_of(*failure.run_out);
    if (reaction_unaudited(run.study, solver.solver).empty()) all.push_back(reaction_at_rest(run.study, failure));
    for (const RunOutAudit& audit : all) {
      Verdict& verdict = verdicts.emplace_back(Verdict{.run = run.name,
                                                       .what = fmt::format("{}: {}", solver.solver, audit.what),
                                                       .kind = "audit",
                                                       .value = audit.value,
                                                       .limit = audit.limit,
                                                       .scale = audit.scale,
                                                       .why = audit.why,
                                                       .quantity = "run-out",
                                                       .leg = solver.solver});
      hold_to_limits(verdict);
    }
  }
  return verdicts;
}

} // namespace settle::compare
