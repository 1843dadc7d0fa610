#include "settle/compare/outcome.hpp"

#include <algorithm>

namespace settle::compare {

std::string_view name_of(SolverStatus status) {
  switch (status) {
  case SolverStatus::finished:
    return "finished";
  case SolverStatus::bad_input:
    return "bad input";
  case SolverStatus::not_converged:
    return "not converged";
  case SolverStatus::file_failed:
    return "cannot write its result";
  case SolverStatus::crashed:
    return "crashed";
  case SolverStatus::timed_out:
    return "timed out";
  case SolverStatus::no_result:
    return "no result";
  case SolverStatus::bad_result:
    return "unreadable result";
  case SolverStatus::not_found:
    return "not found";
  case SolverStatus::out_of_memory:
    return "out of memory";
  case SolverStatus::wrong_version:
    return "result of another version";
  case SolverStatus::disk_full:
    return "disk full";
  case SolverStatus::no_folder:
    return "folder cannot be written";
  }
  return "unknown";
}

std::string title_of(const SolverRun& solver) {
  if (solver.solver == "mpm") return "MPM";
  if (solver.solver == "fem") return "FEM";
  return solver.title.empty() ? solver.solver : solver.title;
}

std::optional<SolverStatus> status_named(std::string_view name) {
  constexpr auto last = static_cast<int>(SolverStatus::no_folder);
  for (int number = 0; number <= last; ++number) {
    const auto status = static_cast<SolverStatus>(number);
    if (name_of(status) == name) return status;
  }
  return {};
}

const exchange::Result* RunOutcome::result_of(const std::string& solver) const {
  const auto found =
      std::find_if(solvers.begin(), solvers.end(), [&](const SolverRun& run) { return run.solver == solver; });
  return found != solvers.end() && found->result ? &*found->result : nullptr;
}

const RunOutcome* CampaignOutcome::find(const std::string& run) const {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const RunOutcome& each) { return each.name == run; });
  return found != runs.end() ? &*found : nullptr;
}

std::vector<const SolverRun*> CampaignOutcome::joined_solvers() const {
  std::vector<const SolverRun*> joined;
  for (const RunOutcome& run : runs) {
    for (const SolverRun& solver : run.solvers) {
      const auto same = [&](const SolverRun* known) { return known->solver == solver.solver; };
      if (solver.solver == "mpm" || solver.solver == "fem" || std::any_of(joined.begin(), joined.end(), same)) continue;
      joined.push_back(&solver);
    }
  }
  return joined;
}

} // namespace settle::compare
