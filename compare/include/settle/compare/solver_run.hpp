/// \file
/// One solver on one case: started as a process, its end and its result turned into a SolverRun.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/joined_solver.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// What is to be run and where its result goes. The log lies beside the result.
struct SolverJob {
  std::string solver{};
  std::optional<JoinedSolver> joined{}; ///< empty: mpm or fem
  std::filesystem::path case_file{};
  std::vector<std::string> overrides{}; ///< `key=value`
  std::filesystem::path result_file{};
  double time_limit = 600.0; ///< wall time [s]
  double memory_limit = 0;   ///< of it and its children, together [B]
};

/// The words that name the case of mpm or fem, and override its keys.
std::vector<std::string> case_arguments(const SolverJob& job);

/// Where the output of a job's solver is kept.
std::filesystem::path log_of(const std::filesystem::path& result_file);

/// The command as one can type it.
std::string command_of(const SolverJob& job);

/// Notes what the file that joins a solver says of it.
void describe(const JoinedSolver& joined, SolverRun& run);

/// Runs the solver, after an earlier result was removed; where the solver is not installed that stays. Never throws for
/// what a solver does: a crash, a limit, a full disk, a missing or unreadable result are statuses. `on_end` is called
/// when the process has ended, before its result is read.
SolverRun run_solver(const SolverJob& job, const std::atomic<bool>& stop, const std::function<void()>& on_end = {});

/// Takes a result that is there, without running anything: finished, no result, or bad result.
SolverRun stored_result(const std::string& solver, const std::filesystem::path& result_file);

} // namespace settle::compare
