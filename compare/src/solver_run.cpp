#include "settle/compare/solver_run.hpp"

#include <cstring>

#include <fmt/format.h>

#include "settle/compare/command_words.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/result_cache.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/solver_programs.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare {

using exchange::ExitCode;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t tail_lines = 15;

/// What is started for a job.
struct Invocation {
  std::filesystem::path program{}; ///< empty: there is none
  std::vector<std::string> arguments{};
};

Invocation invocation_of(const SolverJob& job) {
  if (job.joined) {
    const fs::path folder = fs::absolute(job.result_file).parent_path(); // a program may change its own folder
    std::vector<std::string> words = words_of(*job.joined, case_in(folder), folder / job.result_file.filename());
    words.erase(words.begin());
    return {.program = program_of(*job.joined), .arguments = std::move(words)};
  }
  Invocation invocation{.program = find_solver(job.solver), .arguments = case_arguments(job)};
  invocation.arguments.insert(invocation.arguments.end(), {"--out", job.result_file.string(), "--quiet"});
  return invocation;
}

SolverStatus status_of_exit(int code) {
  switch (code) {
  case static_cast<int>(ExitCode::success):
    return SolverStatus::finished;
  case static_cast<int>(ExitCode::bad_input):
    return SolverStatus::bad_input;
  case static_cast<int>(ExitCode::solver_failed):
    return SolverStatus::not_converged;
  case static_cast<int>(ExitCode::file_failed):
    return SolverStatus::file_failed;
  default:
    return SolverStatus::crashed;
  }
}

void fill_end(const ProcessOutcome& outcome, const SolverJob& job, SolverRun& run) {
  switch (outcome.end) {
  case ProcessEnd::exited:
    run.status = status_of_exit(outcome.code);
    run.exit_code = outcome.code;
    run.message = fmt::format("exit code {}", outcome.code);
    return;
  case ProcessEnd::signalled:
    run.status = SolverStatus::crashed;
    run.exit_code = 128 + outcome.code; // as a shell reports it
    run.message = fmt::format("killed by signal {} ({})", outcome.code, strsignal(outcome.code));
    return;
  case ProcessEnd::timed_out:
    run.status = SolverStatus::timed_out;
    run.message = fmt::format("stopped after its time limit of {} s", job.time_limit);
    return;
  case ProcessEnd::out_of_memory:
    run.status = SolverStatus::out_of_memory;
    run.message = fmt::format("stopped when it took more than its memory limit of {:.3g} GB", job.memory_limit / 1e9);
    return;
  case ProcessEnd::stopped:
    run.status = SolverStatus::timed_out;
    run.message = "interrupted";
    return;
  case ProcessEnd::not_started:
    run.status = SolverStatus::not_found;
    run.message = fmt::format("cannot be started: {}", outcome.problem);
    return;
  }
}

/// Reads the result of a solver that says it has finished.
void read_into(SolverRun& run) {
  std::error_code failure;
  if (!fs::exists(run.result_file, failure)) {
    run.status = SolverStatus::no_result;
    run.message = fmt::format("there is no result {}", run.result_file.string());
    return;
  }
  try {
    run.result = exchange::read_result(run.result_file);
    run.status = SolverStatus::finished;
    run.message.clear();
  } catch (const exchange::VersionError& error) {
    run.status = SolverStatus::wrong_version;
    run.message = error.what();
  } catch (const exchange::Error& error) {
    run.status = SolverStatus::bad_result;
    run.message = error.what();
  }
}

SolverRun not_found(const SolverJob& job, SolverRun run) {
  run.status = SolverStatus::not_found;
  run.message = job.joined ? fmt::format("the program of its command is not there: {}", job.joined->command)
                           : fmt::format("{} is neither beside settle nor in PATH; {} can name another program",
                                         program_name(run.solver), program_variable(run.solver));
  return run;
}

/// Could a full disk be why the solver failed? Then it is said to be.
void blame_full_disk(const SolverJob& job, SolverRun& run) {
  const bool may_be = run.status == SolverStatus::file_failed || run.status == SolverStatus::crashed ||
                      run.status == SolverStatus::no_result || run.status == SolverStatus::bad_result;
  if (!may_be || !is_full(job.result_file.parent_path())) return;
  run.status = SolverStatus::disk_full;
  discard_result(job.result_file); // the other runs need the space
  run.message += fmt::format("; there is no space left in {}", job.result_file.parent_path().string());
}

void run_process_of(const SolverJob& job, const Invocation& invocation, const std::atomic<bool>& stop,
                    const std::function<void()>& on_end, SolverRun& run) {
  const fs::path log = log_of(job.result_file);
  const ProcessOutcome outcome = run_process({.program = invocation.program,
                                              .arguments = invocation.arguments,
                                              .log = log,
                                              .time_limit = job.time_limit,
                                              .memory_limit = job.memory_limit},
                                             stop);
  if (on_end) on_end();
  run.wall_time = outcome.wall_time;
  run.cpu_time = outcome.cpu_time;
  run.peak_memory = outcome.peak_memory;
  fill_end(outcome, job, run);
  if (run.status == SolverStatus::finished) read_into(run);
  if (run.status == SolverStatus::finished) return;
  run.tail = tail_of(log, tail_lines);
  blame_full_disk(job, run);
}

} // namespace

std::vector<std::string> case_arguments(const SolverJob& job) {
  std::vector<std::string> arguments{job.case_file.string()};
  for (const std::string& override_text : job.overrides) {
    arguments.emplace_back("--set");
    arguments.push_back(override_text);
  }
  return arguments;
}

fs::path log_of(const fs::path& result_file) {
  return fs::path(result_file).replace_extension(".log");
}

std::string command_of(const SolverJob& job) {
  if (job.joined) {
    const fs::path folder = fs::absolute(job.result_file).parent_path();
    return joined(words_of(*job.joined, case_in(folder), folder / job.result_file.filename()));
  }
  std::string text = program_name(job.solver);
  for (const std::string& argument : case_arguments(job))
    text.append(" ").append(quoted(argument));
  return text.append(" --out ").append(quoted(job.result_file.string()));
}

void describe(const JoinedSolver& joined, SolverRun& run) {
  run.title = joined.title;
  run.kinematics = joined.kinematics;
}

SolverRun run_solver(const SolverJob& job, const std::atomic<bool>& stop, const std::function<void()>& on_end) {
  SolverRun run{.solver = job.solver, .command = command_of(job), .result_file = job.result_file};
  if (job.joined) describe(*job.joined, run);
  const Invocation invocation = invocation_of(job);
  if (invocation.program.empty()) return not_found(job, std::move(run));
  discard_result(job.result_file);
  run_process_of(job, invocation, stop, on_end, run);
  return run;
}

SolverRun stored_result(const std::string& solver, const fs::path& result_file) {
  SolverRun run{.solver = solver, .reused = true, .result_file = result_file};
  read_into(run);
  if (run.result) run.wall_time = run.result->provenance.wall_time;
  return run;
}

} // namespace settle::compare
