#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/judge.hpp"

namespace settle::compare {

using exchange::Used;

namespace {

constexpr double same_number = 1e-12; ///< both come from one text: round-off

/// Collects the differences between what was used and what the case says.
class Differences {
public:
  void number(const std::string& name, double used, double wanted) {
    const double difference = wanted != 0.0 ? std::abs(used - wanted) / std::abs(wanted) : std::abs(used);
    if (std::isnan(difference)) not_a_number_ = true;
    largest_ = std::max(largest_, difference);
    if (!(difference <= same_number)) texts_.push_back(fmt::format("{} {} instead of {}", name, used, wanted));
  }
  template <class Enum>
  void word(const std::string& name, Enum used, Enum wanted) {
    if (used == wanted) return;
    largest_ = std::max(largest_, 1.0);
    texts_.push_back(fmt::format("{} {} instead of {}", name, name_of(used), name_of(wanted)));
  }
  [[nodiscard]] double largest() const { return not_a_number_ ? std::nan("") : largest_; }
  [[nodiscard]] std::string text() const { return fmt::format("{}", fmt::join(texts_, ", ")); }

private:
  std::vector<std::string> texts_;
  double largest_ = 0.0;
  bool not_a_number_ = false;
};

/// What the case asks of a solver; of a program other than the two, what the file says that joins it, else its own.
exchange::Kinematics kinematics_wanted(const RunOutcome& run, const SolverRun& solver, const Used& used) {
  if (solver.solver == "mpm") return exchange::Kinematics::finite;
  if (solver.solver == "fem") return run.study.fem.kinematics;
  return solver.kinematics.value_or(used.kinematics);
}

Differences differences(const Used& used, const Used& wanted) {
  Differences found;
  found.number("youngs_modulus", used.youngs_modulus, wanted.youngs_modulus);
  found.number("poissons_ratio", used.poissons_ratio, wanted.poissons_ratio);
  found.number("density", used.density, wanted.density);
  found.number("gravity", used.gravity, wanted.gravity);
  found.number("dimension", used.dimension, wanted.dimension);
  found.word("law", used.law, wanted.law);
  found.word("convention", used.convention, wanted.convention);
  found.word("kinematics", used.kinematics, wanted.kinematics);
  return found;
}

} // namespace

std::vector<Verdict> judge_physics(const RunOutcome& run) {
  std::vector<Verdict> verdicts;
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result) continue;
    const Used& used = solver.result->used;
    const Used wanted = exchange::used_values(run.study, kinematics_wanted(run, solver, used));
    const Differences found = differences(used, wanted);
    Verdict verdict{.run = run.name,
                    .what = fmt::format("{} used what the case says", solver.solver),
                    .kind = "physics",
                    .value = found.largest(),
                    .limit = same_number,
                    .scale = "the case's value",
                    .why = "a comparison of different problems proves nothing",
                    .leg = solver.solver};
    hold_to_limits(verdict);
    if (!found.text().empty()) verdict.message = found.text();
    verdicts.push_back(verdict);
  }
  return verdicts;
}

} // namespace settle::compare
