#include "settle/compare/solver_run.hpp"

#include <cstring>

#include <fmt/format.h>

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

std::vector<std::string> case_arguments(const SolverJob& job) {
  std::vector<std::string> arguments{job.case_file.string()};
  for (const std::string& override_text : job.overrides) {
    arguments.emplace_back("--set");
    arguments.push_back(override_text);
  }
  return arguments;
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

SolverRun not_found(SolverRun run) {
  run.status = SolverStatus::not_found;
  run.message = fmt::format("{} is neither beside settle nor in PATH; {} can name another program",
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

void run_process_of(const SolverJob& job, const fs::path& program, const std::atomic<bool>& stop, SolverRun& run) {
  std::vector<std::string> arguments = case_arguments(job);
  arguments.insert(arguments.end(), {"--out", job.result_file.string(), "--quiet"});
  const fs::path log = log_of(job.result_file);
  const ProcessOutcome outcome = run_process({.program = program,
                                              .arguments = arguments,
                                              .log = log,
                                              .time_limit = job.time_limit,
                                              .memory_limit = job.memory_limit},
                                             stop);
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

fs::path log_of(const fs::path& result_file) {
  return fs::path(result_file).replace_extension(".log");
}

std::string quoted(const std::string& word) {
  const char* harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+:,@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string text(1, '\'');
  for (const char letter : word) {
    if (letter == '\'') text += "'\\'"; // leaves the quotes, a quote, enters them again
    text += letter;
  }
  text += '\'';
  return text;
}

std::string command_of(const SolverJob& job) {
  std::string text = program_name(job.solver);
  for (const std::string& argument : case_arguments(job))
    text.append(" ").append(quoted(argument));
  return text.append(" --out ").append(quoted(job.result_file.string()));
}

SolverRun run_solver(const SolverJob& job, const std::atomic<bool>& stop) {
  SolverRun run{.solver = job.solver, .command = command_of(job), .result_file = job.result_file};
  const fs::path program = find_solver(job.solver);
  if (program.empty()) return not_found(std::move(run));
  discard_result(job.result_file);
  run_process_of(job, program, stop, run);
  return run;
}

std::optional<std::string> complaint_of(const SolverJob& job, const std::atomic<bool>& stop) {
  const fs::path program = find_solver(job.solver);
  if (program.empty()) return {};
  constexpr double enough_to_read_a_case = 60.0;
  std::vector<std::string> arguments = case_arguments(job);
  arguments.emplace_back("--check");
  const CapturedOutput answer = run_captured(program, arguments, enough_to_read_a_case, stop);
  const bool refused =
      answer.outcome.end == ProcessEnd::exited && answer.outcome.code == static_cast<int>(ExitCode::bad_input);
  return refused ? std::optional(answer.text) : std::nullopt;
}

SolverRun stored_result(const std::string& solver, const fs::path& result_file) {
  SolverRun run{.solver = solver, .reused = true, .result_file = result_file};
  read_into(run);
  if (run.result) run.wall_time = run.result->provenance.wall_time;
  return run;
}

} // namespace settle::compare
