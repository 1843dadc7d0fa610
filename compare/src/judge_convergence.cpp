#include "settle/compare/judge_convergence.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "convergence_study.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/judge.hpp"

namespace settle::compare {

using exchange::Convergence;
using exchange::ErrorAgainst;
using exchange::ExpectedConvergence;

namespace {

Verdict begun(const Family& family, const ConvergenceStudy& study, const std::string& what) {
  return {.run = family.name,
          .what = fmt::format("{}: {}", study.title(), what),
          .kind = "convergence",
          .at_least = std::nan(""),
          .limit = std::nan(""),
          .why = study.expected.why,
          .quantity = std::string(name_of(study.expected.quantity)),
          .leg = study.expected.solver + (study.expected.against == ErrorAgainst::exact ? " - exact" : "")};
}

std::string measured_text(const ConvergenceFinding& finding) {
  const std::string order = std::isfinite(finding.order) ? fmt::format(", fitted order {:.3g}", finding.order) : "";
  return fmt::format("{}{}: {}", exchange::name_of(finding.verdict), order, finding.reason);
}

std::string expectation_text(const ExpectedConvergence& expected) {
  return expected.order ? fmt::format("{} at order {:.3g}", name_of(expected.verdict), *expected.order)
                        : std::string(name_of(expected.verdict));
}

/// Is the behaviour the expected one, and of the expected order?
Verdict trend_verdict(const Family& family, const ConvergenceStudy& study) {
  const ExpectedConvergence& expected = study.expected;
  const ConvergenceFinding& finding = study.finding;
  Verdict verdict = begun(family, study, expectation_text(expected));
  verdict.value = finding.order;
  if (expected.order) {
    verdict.at_least = *expected.order - expected.band.front();
    verdict.limit = *expected.order + expected.band.back();
  }
  if (!study.problem.empty() || finding.verdict == Convergence::undetermined) {
    verdict.message = study.problem.empty() ? finding.reason : study.problem;
  } else if (finding.verdict != expected.verdict) {
    verdict.status = Status::failed;
    verdict.message = measured_text(finding);
  } else if (expected.order) {
    hold_to_limits(verdict);
    if (verdict.status == Status::failed) verdict.message = "the fitted order " + verdict.message;
  } else {
    verdict.status = Status::passed;
  }
  return verdict;
}

Verdict finest_verdict(const Family& family, const ConvergenceStudy& study) {
  const bool exact = study.expected.against == ErrorAgainst::exact;
  Verdict verdict = begun(family, study, exact ? "error of the finest level" : "grid convergence index");
  verdict.kind = "check";
  verdict.at_least = 0.0;
  verdict.limit = *study.expected.finest_at_most;
  verdict.message = study.problem;
  if (!study.problem.empty()) return verdict;
  verdict.value = exact ? study.errors.back() : study.grid.fine_index;
  const double scale = exact ? study.exact.back() : study.values.back();
  verdict.scale = fmt::format("{} on the finest level: {:.6g} {}", exact ? "exact" : "the value", scale, study.unit);
  hold_to_limits(verdict);
  return verdict;
}

Verdict scatter_verdict(const Family& family, const ConvergenceStudy& study) {
  Verdict verdict = begun(family, study, "largest error over the fitted line");
  verdict.at_least = 0.0;
  verdict.limit = *study.expected.above_fit_at_most;
  verdict.message = study.problem;
  if (!study.problem.empty()) return verdict;
  verdict.value = 0.0;
  for (std::size_t i = 0; i < study.errors.size(); ++i) {
    const double ratio = study.errors[i] / study.finding.fit.error_at(study.sizes[i]);
    verdict.value = std::isnan(ratio) ? ratio : std::max(verdict.value, ratio); // a NaN stays
  }
  hold_to_limits(verdict);
  return verdict;
}

Verdict unexpected_verdict(const Family& family, const ConvergenceStudy& study) {
  Verdict verdict = begun(family, study, "something expected");
  verdict.value = study.finding.order;
  verdict.message = fmt::format("the case does not say what it expects of {}", study.expected.solver);
  verdict.message += ". Measured: " + (study.problem.empty() ? measured_text(study.finding) : study.problem);
  return verdict;
}

void judge_study(const ConvergenceStudy& study, Family& family) {
  if (!study.is_expected) {
    family.verdicts.push_back(unexpected_verdict(family, study));
    return;
  }
  family.verdicts.push_back(trend_verdict(family, study));
  if (study.expected.finest_at_most) family.verdicts.push_back(finest_verdict(family, study));
  if (study.expected.above_fit_at_most) family.verdicts.push_back(scatter_verdict(family, study));
}

/// The usual fields of a solver of which the case expects nothing.
void add_unexpected(const Levels& levels, const std::string& solver, Family& family) {
  for (const exchange::Quantity quantity : usual_fields(levels.front()->study)) {
    ExpectedConvergence open;
    open.solver = solver;
    open.quantity = quantity;
    family.studies.push_back(study_of(levels, open, false));
  }
}

/// Where a case says what it expects of a study; its file for one of which it expects nothing.
std::string place_of(const RunOutcome& run, std::size_t study) {
  return study < run.expectation_places.size() ? run.expectation_places[study] : run.case_file;
}

Family family_of(const Levels& levels) {
  const exchange::Refinement& refinement = *levels.front()->study.converge;
  Family family{.name = levels.front()->family, .size = refinement.size};
  for (const RunOutcome* run : levels)
    family.runs.push_back(run->name);
  for (const ExpectedConvergence& expected : refinement.expectations)
    family.studies.push_back(study_of(levels, expected, true));
  for (const SolverRun& solver : levels.front()->solvers) {
    const bool named = std::any_of(refinement.expectations.begin(), refinement.expectations.end(),
                                   [&](const ExpectedConvergence& each) { return each.solver == solver.solver; });
    if (!named) add_unexpected(levels, solver.solver, family);
  }
  for (std::size_t i = 0; i < family.studies.size(); ++i) {
    const std::size_t first = family.verdicts.size();
    judge_study(family.studies[i], family);
    for (std::size_t each = first; each < family.verdicts.size(); ++each)
      family.verdicts[each].where = place_of(*levels.front(), i);
  }
  return family;
}

} // namespace

std::vector<Family> families_of(const std::vector<RunOutcome>& runs) {
  std::vector<Family> families;
  for (auto first = runs.begin(); first != runs.end();) {
    const auto other = [&](const RunOutcome& run) { return run.family != first->family; };
    const auto last = std::find_if(first, runs.end(), other);
    if (!first->family.empty()) {
      Levels levels;
      for (auto run = first; run != last; ++run)
        levels.push_back(&*run);
      families.push_back(family_of(levels));
    }
    first = last;
  }
  return families;
}

} // namespace settle::compare
