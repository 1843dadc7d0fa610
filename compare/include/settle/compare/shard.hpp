/// \file
/// A part of a campaign, for several machines that share its work.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "settle/compare/campaign.hpp"
#include "settle/compare/expand.hpp"

namespace settle::compare {

/// One of `count` parts.
struct Shard {
  int index = 1; ///< 1 ... count
  int count = 1;
};

/// "2/3". Throws InputError for anything else.
Shard parse_shard(const std::string& text);

/// What each run has cost an earlier campaign: run -> wall time of all its solvers [s].
using RunCosts = std::map<std::string, double>;

/// The costs in the outcome.json of an earlier campaign. Throws FileError where it is none.
RunCosts read_costs(const std::filesystem::path& file);

/// The runs of a part, in their order, a refinement family as one. Without costs they are dealt out in turn; with them
/// the longest first, each to the part that has least to do by then, one of unknown cost for an average one. All parts
/// together are all runs, each once, as long as they are given the same costs. Throws InputError where nothing is left
/// for this part.
std::vector<ExpandedRun> runs_of(const Shard& shard, const std::vector<ExpandedRun>& runs, const RunCosts& costs = {});

/// The campaign as the part reports it: its title says which part it is, its description how much is left out; figures
/// and published numbers that need runs of other parts are left out.
Campaign campaign_of(const Shard& shard, Campaign campaign, const std::vector<ExpandedRun>& runs, std::size_t all_runs);

} // namespace settle::compare
