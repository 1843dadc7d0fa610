#include "settle/compare/campaign_run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <semaphore>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "parallel.hpp"
#include "settle/compare/baseline.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/judge_convergence.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/solver_checks.hpp"
#include "settle/compare/task_run.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare {

using exchange::ExitCode;

namespace {

void throw_if_interrupted(const std::atomic<bool>& stop) {
  if (stop)
    throw exchange::Error(ExitCode::interrupted, "interrupted; finished results are kept and will be used again");
}

std::vector<RunOutcome> outcomes_of(const std::vector<ExpandedRun>& runs) {
  std::vector<RunOutcome> outcomes;
  for (const ExpandedRun& run : runs) {
    RunOutcome outcome;
    outcome.name = run.name;
    outcome.note = run.note;
    outcome.family = run.family;
    outcome.study = run.study;
    outcome.overrides = run.overrides;
    outcome.case_file = run.case_file.string();
    for (std::size_t i = 0; i < run.study.checks.size(); ++i)
      outcome.check_places.push_back(run.study.where(fmt::format("check.{}.quantity", i)));
    for (std::size_t i = 0; run.study.converge && i < run.study.converge->expectations.size(); ++i)
      outcome.expectation_places.push_back(run.study.where(fmt::format("converge.expect.{}.solver", i)));
    outcome.solvers.resize(run.solvers.size());
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

/// A run's folder, or why it cannot be written.
std::string complaint_of_folder(const std::filesystem::path& folder, const ExpandedRun& run) {
  try {
    prepare_run_folder(folder, run);
    return {};
  } catch (const exchange::FileError& error) {
    return error.what();
  }
}

/// One of the places for solvers that run at the same time, taken until it is left.
class Slot {
public:
  explicit Slot(std::counting_semaphore<>& slots) : slots_(slots) { slots_.acquire(); }
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;
  ~Slot() { leave(); }
  void leave() {
    if (std::exchange(taken_, false)) slots_.release();
  }

private:
  std::counting_semaphore<>& slots_;
  bool taken_ = true;
};

/// The tasks of a plan being worked off by several threads: twice as many as there are solvers at a time, so that the
/// next ones run while results are read, brought to the disk, and judged.
class Execution {
public:
  Execution(const Plan& plan, const RunOptions& options, const std::atomic<bool>& stop, std::vector<RunOutcome>& runs)
      : plan_(plan), options_(options), stop_(stop), runs_(runs), observer_(plan, options.jobs, options.on_progress),
        unfinished_(runs.size()), slots_(std::max(options.jobs, 1)) {}

  void run_all() {
    folder_complaints_ = prepare_run_folders(plan_, options_.folder);
    for (std::size_t r = 0; r < plan_.runs.size(); ++r)
      unfinished_[r] = plan_.runs[r].solvers.size();
    const std::vector<std::size_t> order = order_of(plan_);
    parallel_for(order.size(), 2 * options_.jobs, [&](std::size_t i) {
      if (!stop_) execute(plan_.tasks[order[i]]);
    });
  }

private:
  void execute(const Task& task) {
    RunOutcome& run = runs_[task.run];
    Slot slot(slots_);
    if (stop_) return;
    observer_.started(task);
    run.solvers[task.solver] = outcome_of(task, slot);
    observer_.ended(task, run.solvers[task.solver]);
    if (--unfinished_[task.run] == 0 && !stop_) judge_into(run);
  }

  SolverRun outcome_of(const Task& task, Slot& slot) {
    if (!task.is_due()) {
      SolverRun run = taken_up(task);
      if (run.status == SolverStatus::finished || options_.judge_only) return run;
    } // else this build cannot read it: it is run
    const std::string& complaint = folder_complaints_[task.run];
    if (!complaint.empty()) return without_folder(task, complaint);
    return options_.judge_only ? recorded_end(task) : run_task(task, stop_, [&] { slot.leave(); });
  }

  const Plan& plan_;
  const RunOptions& options_;
  const std::atomic<bool>& stop_;
  std::vector<RunOutcome>& runs_;
  Observer observer_;
  std::vector<std::string> folder_complaints_;
  std::vector<std::atomic<std::size_t>> unfinished_; ///< solvers of each run
  std::counting_semaphore<> slots_;
};

bool lacks_its_result(SolverStatus status) {
  switch (status) {
  case SolverStatus::file_failed:
  case SolverStatus::no_result:
  case SolverStatus::bad_result:
  case SolverStatus::wrong_version:
  case SolverStatus::disk_full:
  case SolverStatus::no_folder:
    return true;
  case SolverStatus::finished:
  case SolverStatus::bad_input:
  case SolverStatus::not_converged:
  case SolverStatus::crashed:
  case SolverStatus::timed_out:
  case SolverStatus::not_found:
  case SolverStatus::out_of_memory:
    return false;
  }
  return false;
}

} // namespace

void require_solvers_agree(const Plan& plan, int jobs, const std::atomic<bool>& stop) {
  std::vector<const SolverJob*> due;
  for (const Task& task : plan.tasks) {
    if (task.is_due()) due.push_back(&task.job);
  }
  const std::vector<std::string> complaints = complaints_of(due, jobs, stop);
  throw_if_interrupted(stop);
  std::set<std::string> shown;
  std::string text;
  for (const std::string& complaint : complaints) {
    if (!complaint.empty() && shown.insert(complaint).second) text += (text.empty() ? "" : "\n") + complaint;
  }
  if (!text.empty()) throw exchange::InputError(text);
}

std::vector<std::string> prepare_run_folders(const Plan& plan, const std::filesystem::path& folder) {
  std::vector<std::string> complaints;
  for (const ExpandedRun& run : plan.runs)
    complaints.push_back(complaint_of_folder(run_folder(folder, run.name), run));
  return complaints;
}

CampaignOutcome run_campaign(const Campaign& campaign, const Plan& plan, const RunOptions& options,
                             const std::atomic<bool>& stop) {
  const auto start = std::chrono::steady_clock::now();
  CampaignOutcome outcome{.campaign = campaign,
                          .command = {},
                          .created = exchange::utc_now(),
                          .program_version = exchange::program_version(),
                          .commit = exchange::program_commit(),
                          .runs = outcomes_of(plan.runs)};
  Execution(plan, options, stop, outcome.runs).run_all();
  throw_if_interrupted(stop);
  copy_baseline(campaign, options.folder);
  judge_baseline(options.folder, outcome);
  outcome.families = families_of(outcome.runs);
  outcome.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

ExitCode exit_code_after(SolverStatus status) {
  if (status == SolverStatus::finished) return ExitCode::success;
  return lacks_its_result(status) ? ExitCode::file_failed : ExitCode::solver_failed;
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
