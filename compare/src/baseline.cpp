#include "settle/compare/baseline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "settle/compare/judge.hpp"
#include "settle/compare/statistics.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t drifting = 3; ///< so many acceptances in one direction are pointed out
constexpr std::array figures{Statistic::max_settlement, Statistic::max_vertical_stress, Statistic::mean_density,
                             Statistic::base_reaction_stress};

void add_figures(const RunOutcome& run, const SolverRun& solver, BaselineValues& values) {
  for (const Statistic statistic : figures) {
    const double value = measured(run, solver.solver, statistic);
    if (!std::isfinite(value) || value == 0.0) continue;
    values[fmt::format("{}: {} {}", run.name, solver.solver, exchange::name_of(statistic))] = {
        .value = value, .scale = std::abs(value)};
  }
}

/// Checks that no closed form decides.
void add_checks(const RunOutcome& run, BaselineValues& values) {
  for (const exchange::Check& check : run.study.checks) {
    const bool exact = std::find(check.between.begin(), check.between.end(), "exact") != check.between.end();
    if (exact || !(check.limit > 0.0)) continue;
    const Verdict verdict = judge_check(run, check);
    if (!std::isfinite(verdict.value)) continue;
    values[fmt::format("{}: {}", run.name, verdict.what)] = {.value = verdict.value, .scale = check.limit};
  }
}

BaselineValues values_of(const RunOutcome& run) {
  BaselineValues values;
  if (!run.family.empty()) return values;
  for (const SolverRun& solver : run.solvers) {
    if (solver.result) add_figures(run, solver, values);
  }
  add_checks(run, values);
  return values;
}

/// How a value came from acceptance to acceptance, and today's: "rose with each of the last 3 acceptances, ...".
/// Empty unless it moved in one direction all the time, by more than round-off.
std::string drift_of(const std::string& key, const BaselineValue& today, const Baseline& baseline) {
  if (baseline.size() < drifting) return {};
  std::vector<double> course;
  for (std::size_t i = baseline.size() - drifting; i < baseline.size(); ++i) {
    const auto known = baseline[i].values.find(key);
    if (known == baseline[i].values.end()) return {};
    course.push_back(known->second.value);
  }
  course.push_back(today.value);
  const double round_off = 1e-9 * today.scale;
  bool rises = true, falls = true;
  for (std::size_t i = 1; i < drifting; ++i) {
    rises = rises && course[i] > course[i - 1] + round_off;
    falls = falls && course[i] < course[i - 1] - round_off;
  }
  rises = rises && course.back() >= course[drifting - 1] - round_off;
  falls = falls && course.back() <= course[drifting - 1] + round_off;
  if (!rises && !falls) return {};
  return fmt::format("drifts: it {} with each of the last {} acceptances, by {:.3g} % in all since {}",
                     rises ? "rose" : "fell", drifting, 100.0 * std::abs(course.back() - course.front()) / today.scale,
                     baseline[baseline.size() - drifting].when);
}

/// The quantity of a key figure.
exchange::Quantity quantity_of(Statistic statistic) {
  switch (statistic) {
  case Statistic::max_settlement:
    return exchange::Quantity::settlement;
  case Statistic::max_vertical_stress:
    return exchange::Quantity::vertical_stress;
  case Statistic::mean_density:
    return exchange::Quantity::density;
  case Statistic::base_reaction_stress:
    return exchange::Quantity::base_reaction;
  case Statistic::refilled_points:
    return exchange::Quantity::mass;
  }
  return exchange::Quantity::mass;
}

/// Of what a value is and whose, from its name: "settlement, mpm - fem, l2 over probes, last stage" or "mpm
/// max-settlement".
void name_quantity_and_leg(const std::string& name, Verdict& verdict) {
  if (const auto comma = name.find(", "); comma != std::string::npos) {
    verdict.quantity = name.substr(0, comma);
    verdict.leg = name.substr(comma + 2, name.find(',', comma + 2) - comma - 2);
    return;
  }
  const auto blank = name.find(' ');
  verdict.leg = name.substr(0, blank);
  for (const Statistic statistic : figures) {
    if (name.substr(blank + 1) == exchange::name_of(statistic))
      verdict.quantity = exchange::name_of(quantity_of(statistic));
  }
}

Verdict begun(const std::string& run, const std::string& key, const Acceptance& accepted) {
  const std::string name = key.substr(run.size() + 2);
  Verdict verdict{.run = run,
                  .what = fmt::format("{}, as accepted", name),
                  .kind = "baseline",
                  .limit = accepted.tolerance,
                  .why = fmt::format("accepted on {} by {}: {}", accepted.when, accepted.who, accepted.reason)};
  name_quantity_and_leg(name, verdict);
  return verdict;
}

Verdict judge_value(const std::string& run, const std::string& key, const BaselineValue& today,
                    const Baseline& baseline) {
  Verdict verdict = begun(run, key, baseline.back());
  const auto known = baseline.back().values.find(key);
  if (known == baseline.back().values.end()) {
    verdict.message = "the value was never accepted: settle baseline accept takes it up";
    return verdict;
  }
  verdict.value = std::abs(today.value - known->second.value) / known->second.scale;
  verdict.scale =
      fmt::format("{:.6g}; accepted {:.6g}, today {:.6g}", known->second.scale, known->second.value, today.value);
  hold_to_limits(verdict);
  if (verdict.status == Status::passed) verdict.message = drift_of(key, today, baseline);
  return verdict;
}

void judge_run(const Baseline& baseline, RunOutcome& run) {
  const BaselineValues today = values_of(run);
  for (const auto& [key, value] : today)
    run.verdicts.push_back(judge_value(run.name, key, value, baseline));
  for (const auto& [key, value] : baseline.back().values) {
    if (!key.starts_with(run.name + ": ") || today.contains(key)) continue;
    run.verdicts.push_back(begun(run.name, key, baseline.back()));
    run.verdicts.back().message = fmt::format("there is no such value today; accepted was {:.6g}", value.value);
  }
}

} // namespace

BaselineValues baseline_values(const CampaignOutcome& outcome) {
  BaselineValues values;
  for (const RunOutcome& run : outcome.runs)
    values.merge(values_of(run));
  return values;
}

void judge_baseline(const fs::path& folder, CampaignOutcome& outcome) {
  const std::optional<Baseline> baseline = baseline_of(outcome.campaign, folder);
  if (!baseline) return;
  for (RunOutcome& run : outcome.runs)
    judge_run(*baseline, run);
}

} // namespace settle::compare
