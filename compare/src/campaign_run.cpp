#include "settle/compare/campaign_run.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "parallel.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/judge_convergence.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/solver_run.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare {

using exchange::ExitCode;

namespace {

/// One solver's part of an expanded run.
struct Task {
  std::size_t run = 0;
  std::size_t solver = 0; ///< index in the run
  SolverJob job;
};

std::optional<JoinedSolver> joined_in(const Campaign& campaign, const std::string& solver) {
  const auto found = campaign.solvers.find(solver);
  return found != campaign.solvers.end() ? std::optional(found->second) : std::nullopt;
}

std::vector<Task> tasks_of(const Campaign& campaign, const std::vector<ExpandedRun>& runs, const RunOptions& options) {
  std::vector<Task> tasks;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const ExpandedRun& run = runs[r];
    const std::filesystem::path folder = run_folder(options.folder, run.name);
    for (std::size_t s = 0; s < run.solvers.size(); ++s) {
      tasks.push_back({.run = r,
                       .solver = s,
                       .job = {.solver = run.solvers[s],
                               .joined = joined_in(campaign, run.solvers[s]),
                               .case_file = run.case_file,
                               .overrides = run.overrides,
                               .result_file = result_in(folder, run.solvers[s]),
                               .case_text = exchange::to_toml(run.study),
                               .time_limit = run.time_limit,
                               .fresh = options.fresh}});
    }
  }
  return tasks;
}

void throw_if_interrupted(const std::atomic<bool>& stop) {
  if (stop)
    throw exchange::Error(ExitCode::interrupted, "interrupted; finished results are kept and will be used again");
}

/// Every solver sees every case before any of them runs. All complaints come in one error, each once.
void require_solvers_agree(const std::vector<Task>& tasks, int jobs, const std::atomic<bool>& stop) {
  std::vector<std::string> complaints(tasks.size());
  parallel_for(tasks.size(), jobs, [&](std::size_t i) {
    if (!stop) complaints[i] = complaint_of(tasks[i].job, stop).value_or("");
  });
  throw_if_interrupted(stop);
  std::set<std::string> shown;
  std::string text;
  for (const std::string& complaint : complaints) {
    if (!complaint.empty() && shown.insert(complaint).second) text += (text.empty() ? "" : "\n") + complaint;
  }
  if (!text.empty()) throw exchange::InputError(text);
}

/// Tells the observer, one thread at a time, what runs and what has ended.
class Observer {
public:
  Observer(std::size_t total, std::function<void(const Progress&)> tell) : tell_(std::move(tell)) {
    progress_.total = total;
  }

  void started(const std::string& run, const std::string& solver) {
    const std::scoped_lock lock(mutex_);
    progress_.running.push_back(title(run, solver));
    report();
  }
  void ended(const std::string& run, const SolverRun& solver) {
    const std::scoped_lock lock(mutex_);
    const auto position = std::find(progress_.running.begin(), progress_.running.end(), title(run, solver.solver));
    progress_.running.erase(position);
    ++progress_.finished;
    progress_.run = run;
    progress_.ended = &solver;
    report();
    progress_.run.clear();
    progress_.ended = nullptr;
  }

private:
  static std::string title(const std::string& run, const std::string& solver) { return run + ", " + solver; }
  void report() const {
    if (tell_) tell_(progress_);
  }

  std::mutex mutex_;
  Progress progress_;
  std::function<void(const Progress&)> tell_;
};

std::vector<RunOutcome> outcomes_of(const std::vector<ExpandedRun>& runs) {
  std::vector<RunOutcome> outcomes;
  for (const ExpandedRun& run : runs) {
    RunOutcome outcome;
    outcome.name = run.name;
    outcome.note = run.note;
    outcome.family = run.family;
    outcome.study = run.study;
    outcome.overrides = run.overrides;
    outcome.solvers.resize(run.solvers.size());
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

void run_all(const std::vector<Task>& tasks, const RunOptions& options, const std::atomic<bool>& stop,
             std::vector<RunOutcome>& outcomes) {
  Observer observer(tasks.size(), options.on_progress);
  parallel_for(tasks.size(), options.jobs, [&](std::size_t i) {
    if (stop) return;
    const Task& task = tasks[i];
    RunOutcome& outcome = outcomes[task.run];
    observer.started(outcome.name, task.job.solver);
    outcome.solvers[task.solver] = run_solver(task.job, stop);
    observer.ended(outcome.name, outcome.solvers[task.solver]);
  });
  throw_if_interrupted(stop);
}

bool lacks_its_result(SolverStatus status) {
  switch (status) {
  case SolverStatus::file_failed:
  case SolverStatus::no_result:
  case SolverStatus::bad_result:
    return true;
  case SolverStatus::finished:
  case SolverStatus::bad_input:
  case SolverStatus::not_converged:
  case SolverStatus::crashed:
  case SolverStatus::timed_out:
  case SolverStatus::not_found:
    return false;
  }
  return false;
}

} // namespace

CampaignOutcome run_campaign(const Campaign& campaign, const RunOptions& options, const std::atomic<bool>& stop) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<ExpandedRun> runs = expand(campaign);
  const std::vector<Task> tasks = tasks_of(campaign, runs, options);
  require_solvers_agree(tasks, options.jobs, stop);
  for (const ExpandedRun& run : runs)
    prepare_run_folder(run_folder(options.folder, run.name), run);
  CampaignOutcome outcome{.campaign = campaign,
                          .command = {},
                          .created = exchange::utc_now(),
                          .program_version = exchange::program_version(),
                          .commit = exchange::program_commit(),
                          .runs = outcomes_of(runs)};
  run_all(tasks, options, stop, outcome.runs);
  for (RunOutcome& run : outcome.runs)
    judge_into(run);
  outcome.families = families_of(outcome.runs);
  outcome.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

ExitCode exit_code_of(const std::vector<RunOutcome>& runs, const std::vector<Family>& families) {
  bool solver_failed = false;
  bool file_failed = false;
  bool not_passed = runs.empty();
  const auto look_at = [&](const std::vector<Verdict>& verdicts) {
    for (const Verdict& verdict : verdicts) {
      if (verdict.status == Status::missing) file_failed = true;
      if (verdict.status != Status::passed) not_passed = true;
    }
    if (verdicts.empty()) not_passed = true;
  };
  for (const RunOutcome& run : runs) {
    for (const SolverRun& solver : run.solvers) {
      if (solver.status == SolverStatus::finished) continue;
      (lacks_its_result(solver.status) ? file_failed : solver_failed) = true;
    }
    look_at(run.verdicts);
  }
  for (const Family& family : families)
    look_at(family.verdicts);
  if (solver_failed) return ExitCode::solver_failed;
  if (file_failed) return ExitCode::file_failed;
  return not_passed ? ExitCode::verdict_failed : ExitCode::success;
}

} // namespace settle::compare
