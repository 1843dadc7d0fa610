/// \file
/// A campaign's outcome on disk, so that it can be judged and shown again without running anything.
#pragma once

#include <filesystem>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// Writes `outcome.json`: the campaign, how each solver ended, provenance; results and cases lie in the runs' folders.
/// Throws FileError.
void write_outcome(const CampaignOutcome& outcome, const std::filesystem::path& folder);

/// Reads a campaign's folder and judges all of it anew. Throws FileError where it is none.
CampaignOutcome read_outcome(const std::filesystem::path& folder);

} // namespace settle::compare
