#include "convergence_study.hpp"

#include <fmt/format.h>

#include "quantity_unit.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/legs.hpp"
#include "settle/compare/refinement_levels.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/formulas.hpp"

namespace settle::compare {

using exchange::ErrorAgainst;
using exchange::ExpectedConvergence;

namespace {

std::optional<double> exact_value(const exchange::Case& study, const ExpectedConvergence& wanted) {
  if (wanted.exact.empty()) return {};
  return exchange::value_of(study, wanted.exact, "converge.expect.exact");
}

/// Measures one level; the sentence says why it cannot be measured, and is empty where it could.
std::string measure_level(const RunOutcome& run, ConvergenceStudy& study) {
  const ExpectedConvergence& wanted = study.expected;
  const bool exact = wanted.against == ErrorAgainst::exact;
  const LegSamples leg = leg_samples(run, {.value = wanted.solver,
                                           .reference = exact ? "exact" : wanted.solver,
                                           .quantity = wanted.quantity,
                                           .over = wanted.over,
                                           .stage = run.study.n_stages(),
                                           .layers = {},
                                           .support = wanted.support.value_or(0),
                                           .exact = exact_value(run.study, wanted)});
  const RelativeNorm error = relative_norm(leg, wanted.norm);
  if (!error.problem.empty()) return fmt::format("{}: {}", run.name, error.problem);
  study.values.push_back(norm_of(leg.value, leg.weight, wanted.norm));
  if (!exact) return {};
  study.exact.push_back(error.scale);
  study.errors.push_back(error.value);
  return {};
}

void find(ConvergenceStudy& study) {
  const std::size_t n = study.values.size();
  study.finding = study.expected.against == ErrorAgainst::exact ? judge_errors(study.sizes, study.errors)
                                                                : judge_values(study.sizes, study.values);
  if (n < 3) return;
  study.grid = grid_convergence({{{study.sizes[n - 1], study.values[n - 1]},
                                  {study.sizes[n - 2], study.values[n - 2]},
                                  {study.sizes[n - 3], study.values[n - 3]}}});
}

} // namespace

ConvergenceStudy study_of(const Levels& levels, const ExpectedConvergence& expected, bool is_expected) {
  ConvergenceStudy study{.expected = expected, .is_expected = is_expected};
  study.unit = unit_of(expected.quantity, levels.front()->study.geometry.dimension);
  try {
    for (const RunOutcome* run : levels) {
      study.sizes.push_back(level_size(run->study, expected.solver));
      study.problem = measure_level(*run, study);
      if (!study.problem.empty()) return study;
    }
    find(study);
  } catch (const exchange::InputError& error) { // there is no exact column
    study.problem = error.what();
  }
  return study;
}

std::string ConvergenceStudy::title() const {
  const bool with_exact = expected.against == ErrorAgainst::exact;
  std::string text =
      fmt::format("{}, {} {}", name_of(expected.quantity), expected.solver, with_exact ? "- exact" : "against itself");
  if (is_field(expected.quantity)) text += fmt::format(", {} over {}", name_of(expected.norm), name_of(expected.over));
  return text;
}

} // namespace settle::compare
