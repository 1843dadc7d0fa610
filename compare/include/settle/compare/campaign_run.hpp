/// \file
/// Running a campaign: every solver of every run as a process, several at a time, each run judged when its last solver
/// has ended.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <vector>

#include "settle/compare/campaign_plan.hpp"
#include "settle/compare/campaign_progress.hpp"
#include "settle/compare/outcome.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

struct RunOptions {
  std::filesystem::path folder;                     ///< gets everything
  int jobs = 1;                                     ///< solvers at a time
  std::function<void(const Progress&)> on_progress; ///< called by one thread at a time; may be empty
  bool judge_only = false; ///< nothing is run: what is not up to date is taken for what its record says of it
};

/// Every solver sees every case that is due before any of them runs. Throws InputError with the complaints of all, each
/// once, and Error with exit code 130 when `stop` becomes true.
void require_solvers_agree(const Plan& plan, int jobs, const std::atomic<bool>& stop);

/// Creates the folder of every run. The complaint of each that cannot be written; empty ones for the others.
std::vector<std::string> prepare_run_folders(const Plan& plan, const std::filesystem::path& folder);

/// Runs what is due, takes up the rest, and judges all; the folder gets cases, results, logs and records. What a solver
/// does, and a run whose folder cannot be written, never end it. Throws Error with exit code 130 when `stop` becomes
/// true.
CampaignOutcome run_campaign(const Campaign& campaign, const Plan& plan, const RunOptions& options,
                             const std::atomic<bool>& stop);

/// What one solver's end makes of the exit code.
exchange::ExitCode exit_code_after(SolverStatus status);

/// The exit code of `settle`: a solver that failed goes before what is missing, that before a verdict not passed.
exchange::ExitCode exit_code_of(const std::vector<RunOutcome>& runs, const std::vector<Family>& families = {});

} // namespace settle::compare
