/// \file
/// A campaign that has nothing to do: its end is remembered, with what it was the end of.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "settle/compare/campaign_plan.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

/// What a campaign has ended with.
struct FinishedCampaign {
  exchange::ExitCode exit_code = exchange::ExitCode::success;
  std::string summary{}; ///< as it was shown
};

/// SHA-256 of all that verdicts and report are made from: the campaign, every case and result, reference tables, and
/// this program. Nothing where a task is due. Throws FileError where this program cannot be read.
std::optional<std::string> fingerprint_of(const Campaign& campaign, const Plan& plan);

/// The end that is noted in a folder, where it has the same fingerprint and its report is still there.
std::optional<FinishedCampaign> finished_before(const std::filesystem::path& folder, const std::string& fingerprint);

/// Notes the end, after everything else was written. Throws FileError.
void note_finished(const std::filesystem::path& folder, const std::string& fingerprint, const FinishedCampaign& end);

/// Removes outcome, verdicts and report, which are about to be of another state than the runs.
void discard_outcome(const std::filesystem::path& folder);

} // namespace settle::compare
