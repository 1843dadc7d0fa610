/// \file
/// Values that somebody has accepted, where no closed form says what they have to be: kept beside the campaign file,
/// with who, when and why. Nothing but `settle baseline accept` ever writes them.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// One number of a run: a key figure of a solver, or how far two solvers are apart in a check.
struct BaselineValue {
  double value = 0; ///< SI; of a check relative to its scale
  double scale = 0; ///< what a change is relative to: the key figure itself, the limit of the check
};

/// "RUN: mpm max-settlement" or "RUN: settlement, mpm - fem, l2 over probes, last stage" -> its value.
using BaselineValues = std::map<std::string, BaselineValue>;

/// What was accepted once.
struct Acceptance {
  std::string when{}; ///< UTC, ISO 8601
  std::string who{}, reason{};
  std::string commit{}; ///< of settle
  double tolerance = 0; ///< largest change that passes, relative to each value's scale
  BaselineValues values{};
};

/// All that was ever accepted, the newest last. It is the newest that results are held to.
using Baseline = std::vector<Acceptance>;

/// Where the baseline of a campaign lies: campaign.toml -> campaign.baseline.json; of a single case, beside that.
std::filesystem::path baseline_file(const Campaign& campaign);

/// Throws FileError where a file is there but is no baseline.
Baseline read_baseline(const std::filesystem::path& file);
void write_baseline(const Baseline& baseline, const std::filesystem::path& file);

/// The baseline beside the campaign or, where the results were carried elsewhere, the copy in their folder; nothing
/// where there is neither. Throws FileError likewise.
std::optional<Baseline> baseline_of(const Campaign& campaign, const std::filesystem::path& folder);

/// Today's values: largest settlement, largest stress, mean density and base reaction of every result, and every check
/// of the case without the exact solution. Levels of refinement families are left out.
BaselineValues baseline_values(const CampaignOutcome& outcome);

/// Adds a verdict to each run for every value, by `baseline_of`. A value that was never accepted, or is gone, is
/// missing. One that has moved in one direction with every one of the last three acceptances passes, and says so.
/// Without a baseline nothing is added. Throws FileError for a baseline that cannot be read.
void judge_baseline(const std::filesystem::path& folder, CampaignOutcome& outcome);

/// Puts the copy of the campaign's baseline into the results' folder, or removes one that is no longer there.
void copy_baseline(const Campaign& campaign, const std::filesystem::path& folder);

} // namespace settle::compare
