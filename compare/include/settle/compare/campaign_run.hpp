/// \file
/// Running a campaign: every solver of every run as a process, several at a time, then judging.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "settle/compare/expand.hpp"
#include "settle/compare/outcome.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

/// What somebody who waits wants to know.
struct Progress {
  std::size_t finished = 0, total = 0; ///< solver runs
  std::vector<std::string> running;    ///< "RUN, SOLVER"
  std::string run;                     ///< of the solver run that has just ended; empty where one has started
  const SolverRun* ended = nullptr;    ///< it, valid during the call only
};

struct RunOptions {
  std::filesystem::path folder;                     ///< gets everything
  int jobs = 1;                                     ///< solvers at a time
  bool fresh = false;                               ///< run again what is up to date
  std::function<void(const Progress&)> on_progress; ///< called by one thread at a time; may be empty
};

/// Runs and judges a campaign; the folder gets cases, results and logs. What a solver does never ends it.
/// Throws InputError before anything is written where the campaign, a case, or a solver's `--check` refuses the input,
/// FileError where the folder cannot be written, and Error with exit code 130 when `stop` becomes true.
CampaignOutcome run_campaign(const Campaign& campaign, const RunOptions& options, const std::atomic<bool>& stop);

/// The exit code of `settle`: a solver that failed goes before what is missing, that before a verdict not passed.
exchange::ExitCode exit_code_of(const std::vector<RunOutcome>& runs, const std::vector<Family>& families = {});

} // namespace settle::compare
