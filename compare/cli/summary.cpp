#include "summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "settle/compare/convergence_text.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/refinement_levels.hpp"
#include "settle/compare/report.hpp"
#include "settle/compare/statistics.hpp"

namespace settle::compare::cli {
namespace {

/// Largest settlement over points and probes after the last stage [m].
double largest_settlement(const exchange::Result& result) {
  double largest = 0.0;
  const auto look = [&](const FieldSamples& samples) {
    for (const double value : samples.value)
      largest = std::isnan(value) ? value : std::max(largest, value);
  };
  look(point_samples(result.stages.back(), result.used.dimension, exchange::Quantity::settlement));
  look(probe_samples(result.stages.back(), result.used.dimension, exchange::Quantity::settlement));
  return largest;
}

std::string key_figures(const RunOutcome& run, const SolverRun& solver) {
  if (!solver.result || solver.result->stages.empty())
    return fmt::format("{} {}", solver.solver, name_of(solver.status));
  const exchange::Stage& last = solver.result->stages.back();
  return fmt::format("{} {:.4f} m, {:.2f} kPa{}", solver.solver, largest_settlement(*solver.result),
                     last.base_reaction / plan_area(run.study) / 1e3,
                     last.in_equilibrium || runs_in_time(run.study) ? "" : " (out of equilibrium)");
}

std::string run_line(const RunOutcome& run, std::size_t name_width) {
  std::array<int, 4> counts{};
  for (const Verdict& verdict : reported_verdicts(run))
    ++counts.at(static_cast<std::size_t>(verdict.status));
  std::string line = fmt::format("{:<{}}  {:>6} {:>6} {:>7} {:>5}  ", run.name, name_width, counts[0], counts[1],
                                 counts[2], counts[3]);
  for (std::size_t i = 0; i < run.solvers.size(); ++i)
    line += (i > 0 ? "; " : "") + key_figures(run, run.solvers[i]);
  return line + "\n";
}

std::string study_text(const ConvergenceStudy& study, exchange::RefinedSize size) {
  std::string text =
      fmt::format("  {}\n  {:>26} {:>14} {:>12} {:>7}\n", study.title(), size_title(size),
                  fmt::format("norm [{}]", study.unit), study.errors.empty() ? "change" : "error", "order");
  for (const ConvergenceRow& row : rows_of(study))
    text += fmt::format("  {:>26} {:>14} {:>12} {:>7}\n", row.size, row.value, row.error, row.order);
  const std::string extrapolation = extrapolation_of(study);
  text += fmt::format("  {}\n", conclusion_of(study));
  if (!extrapolation.empty()) text += fmt::format("  {}\n", extrapolation);
  return text + "\n";
}

} // namespace

std::string convergence_text(const std::vector<Family>& families) {
  std::string text;
  for (const Family& family : families) {
    text += family.name + "\n";
    for (const ConvergenceStudy& study : family.studies)
      text += study_text(study, family.size);
  }
  return text;
}

std::string failures_text(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const Verdict& verdict : verdicts) {
    if (verdict.status == Status::passed) continue;
    text += fmt::format("{}: {}: {}\n", name_of(verdict.status), verdict.run, verdict.what);
    std::string message = verdict.message;
    for (std::size_t at = message.find('\n'); at != std::string::npos; at = message.find('\n', at + 1)) {
      message.insert(at + 1, "    ");
    }
    if (!message.empty()) text += "    " + message + "\n";
  }
  return text;
}

std::string drifts_text(const CampaignOutcome& outcome) {
  std::string text;
  for (const RunOutcome& run : outcome.runs) {
    for (const Verdict& verdict : run.verdicts) {
      const bool drifts = verdict.kind == "baseline" && verdict.status == Status::passed && !verdict.message.empty();
      if (drifts) text += fmt::format("note: {}: {}: {}\n", run.name, verdict.what, verdict.message);
    }
  }
  return text;
}

std::string summary_text(const CampaignOutcome& outcome) {
  std::size_t width = 3;
  for (const RunOutcome& run : outcome.runs)
    width = std::max(width, run.name.size());
  std::string text = fmt::format("{:<{}}  {:>6} {:>6} {:>7} {:>5}  {}\n", "run", width, "passed", "failed", "missing",
                                 "error", "largest settlement, base reaction over area");
  std::string failures;
  for (const RunOutcome& run : outcome.runs) {
    text += run_line(run, width);
    failures += failures_text(reported_verdicts(run));
  }
  for (const Family& family : outcome.families)
    failures += failures_text(family.verdicts);
  if (!outcome.families.empty()) text += fmt::format("\n{}", convergence_text(outcome.families));
  failures += drifts_text(outcome);
  return failures.empty() ? text : text + "\n" + failures;
}

} // namespace settle::compare::cli
