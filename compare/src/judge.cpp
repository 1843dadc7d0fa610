#include "settle/compare/judge.hpp"

#include <cmath>

#include <fmt/format.h>

#include "settle/compare/error_budget.hpp"
#include "settle/compare/reference_table.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {
namespace {

Verdict solver_verdict(const RunOutcome& run, const SolverRun& solver) {
  Verdict verdict{.run = run.name, .what = solver.solver + " ran to its end", .kind = "solver", .leg = solver.solver};
  if (solver.status == SolverStatus::finished) {
    verdict.status = Status::passed;
    return verdict;
  }
  verdict.status = Status::error;
  verdict.message = fmt::format("{}: {}", name_of(solver.status), solver.message);
  if (!solver.tail.empty()) verdict.message += "\n" + solver.tail;
  return verdict;
}

std::string reference_problem(const RunOutcome& run, const std::string& name) {
  try {
    read_reference_table(reference_path(run.study, run.study.references.at(name)), run.study);
    return {};
  } catch (const exchange::FileError& error) {
    return error.what();
  }
}

std::vector<Verdict> judge_references(const RunOutcome& run) {
  std::vector<Verdict> verdicts;
  for (const auto& [name, reference] : run.study.references) {
    if (run.references.contains(name)) continue;
    verdicts.push_back({.status = Status::missing,
                        .run = run.name,
                        .what = fmt::format("reference \"{}\"", name),
                        .kind = "check",
                        .message = reference_problem(run, name)});
  }
  return verdicts;
}

void append(std::vector<Verdict>& all, std::vector<Verdict> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

void hold_to_limits(Verdict& verdict) {
  if (std::isnan(verdict.value)) {
    verdict.status = Status::missing;
    if (verdict.message.empty()) verdict.message = "there is no value to judge";
  } else if (verdict.value > verdict.limit) {
    verdict.status = Status::failed;
    verdict.message = fmt::format("{:.4g} is above the limit {:.4g}", verdict.value, verdict.limit);
  } else if (verdict.value < verdict.at_least) {
    verdict.status = Status::failed;
    verdict.message =
        fmt::format("{:.4g} is below the expected band, which starts at {:.4g}", verdict.value, verdict.at_least);
  } else {
    verdict.status = Status::passed;
  }
}

std::vector<Verdict> judge_solvers(const RunOutcome& run) {
  std::vector<Verdict> verdicts;
  for (const SolverRun& solver : run.solvers)
    verdicts.push_back(solver_verdict(run, solver));
  return verdicts;
}

std::vector<Verdict> judge(const RunOutcome& run) {
  std::vector<Verdict> verdicts = judge_solvers(run);
  append(verdicts, judge_physics(run));
  append(verdicts, judge_balance(run));
  append(verdicts, judge_run_out(run));
  append(verdicts, judge_references(run));
  for (Verdict& verdict : verdicts)
    verdict.where = run.case_file;
  if (!run.family.empty()) return verdicts; // the checks' limits are those of the case's own grid
  for (std::size_t i = 0; i < run.study.checks.size(); ++i) {
    verdicts.push_back(judge_check(run, run.study.checks[i]));
    verdicts.back().where = i < run.check_places.size() ? run.check_places[i] : run.case_file;
  }
  return verdicts;
}

void judge_into(RunOutcome& run) {
  run.references.clear();
  for (const auto& [name, reference] : run.study.references) {
    try {
      ReferenceTable table = read_reference_table(reference_path(run.study, reference), run.study);
      table.title = reference.title;
      run.references.emplace(name, std::move(table));
    } catch (const exchange::FileError&) {
      continue; // judge_references says what is wrong with it
    }
  }
  try {
    run.splits = difference_splits(run);
  } catch (const exchange::InputError&) {
    run.splits.clear(); // no exact column: every check that needs it says so
  }
  run.verdicts = judge(run);
}

} // namespace settle::compare
