#include "settle/compare/task_run.hpp"

#include "settle/compare/run_folder.hpp"
#include "settle/compare/solver_run.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace {

void fail(SolverRun& run, SolverStatus status, const std::string& message) {
  run.status = is_full(run.result_file.parent_path()) ? SolverStatus::disk_full : status;
  run.message = message;
  run.result.reset();
}

/// A task's end before anything is known of it.
SolverRun begun(const Task& task) {
  SolverRun run{.solver = task.job.solver, .command = command_of(task.job), .result_file = task.job.result_file};
  if (task.job.joined) describe(*task.job.joined, run);
  return run;
}

void add_costs(const RunRecord& record, SolverRun& run) {
  run.wall_time = record.wall_time;
  run.cpu_time = record.cpu_time;
  run.peak_memory = record.peak_memory;
}

/// Notes what an attempt was made from and has cost, with a result what that holds, without one how it ended.
void note(const Task& task, SolverRun& run) {
  RunRecord record{.made_from = task.made_from,
                   .wall_time = run.wall_time,
                   .cpu_time = run.cpu_time,
                   .peak_memory = run.peak_memory};
  try {
    if (run.status == SolverStatus::finished) {
      note_success(task.job.result_file, record);
    } else {
      record.failure = {.status = std::string(name_of(run.status)),
                        .exit_code = run.exit_code,
                        .message = run.message,
                        .tail = run.tail};
      note_record(task.job.result_file, record);
    }
  } catch (const exchange::FileError& error) {
    if (run.status == SolverStatus::finished) fail(run, SolverStatus::file_failed, error.what());
  }
}

/// Nothing has been run, so that what the record says of an earlier attempt stays, unless it says that one is to come.
bool leaves_the_record(const Task& task, const SolverRun& run) {
  const bool is_awaited = task.record && task.record->failure && task.record->failure->status == submitted;
  return run.status == SolverStatus::not_found && !is_awaited;
}

} // namespace

SolverRun run_task(const Task& task, const std::atomic<bool>& stop, const std::function<void()>& on_end) {
  SolverRun run = run_solver(task.job, stop, on_end);
  const bool has_ended = !stop || run.status == SolverStatus::finished;
  if (has_ended && !leaves_the_record(task, run)) note(task, run);
  return run;
}

SolverRun taken_up(const Task& task) {
  SolverRun run = stored_result(task.job.solver, task.job.result_file);
  if (task.job.joined) describe(*task.job.joined, run);
  run.command = command_of(task.job);
  add_costs(*task.record, run);
  return run;
}

SolverRun recorded_end(const Task& task) {
  if (!task.is_due()) return taken_up(task);
  SolverRun run = begun(task);
  const bool is_known = task.record && task.record->made_from == task.made_from && task.record->failure;
  if (!is_known) {
    run.message = "it has not been run: there is no record of it";
    return run;
  }
  const FailedAttempt& failure = *task.record->failure;
  add_costs(*task.record, run);
  run.status = status_named(failure.status).value_or(SolverStatus::no_result);
  run.exit_code = failure.exit_code;
  run.message = failure.message;
  run.tail = failure.tail;
  return run;
}

SolverRun without_folder(const Task& task, const std::string& complaint) {
  SolverRun run = begun(task);
  fail(run, SolverStatus::no_folder, complaint);
  return run;
}

} // namespace settle::compare
