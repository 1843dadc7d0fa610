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
};

/// Every solver sees every case that is due before any of them runs. Throws InputError with the complaints of all, each
/// once, and Error with exit code 130 when `stop` becomes true.
void require_solvers_agree(const Plan& plan, int jobs, const std::atomic<bool>& stop);

/// Runs what is due, takes up the rest, and judges all; the folder gets cases, results, logs and records. What a solver
/// does, and a run whose folder cannot be written, never end it. Throws Error with exit code 130 when `stop` becomes
/// true.
CampaignOutcome run_campaign(const Campaign& campaign, const Plan& plan, const RunOptions& options,
                             const std::atomic<bool>& stop);

/// The exit code of `settle`: a solver that failed goes before what is missing, that before a verdict not passed.
exchange::ExitCode exit_code_of(const std::vector<RunOutcome>& runs, const std::vector<Family>& families = {});

} // namespace settle::compare
