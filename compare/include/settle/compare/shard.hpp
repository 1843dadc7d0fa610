/// \file
/// A part of a campaign, for several machines that share its work.
#pragma once

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

/// The runs of a part, in their order: runs are dealt out in turn, a refinement family as one. All parts together are
/// all runs, each once. Throws InputError where nothing is left for this part.
std::vector<ExpandedRun> runs_of(const Shard& shard, const std::vector<ExpandedRun>& runs);

/// The campaign as the part reports it: its title says which part it is, its description how much is left out; figures
/// and published numbers that need runs of other parts are left out.
Campaign campaign_of(const Shard& shard, Campaign campaign, const std::vector<ExpandedRun>& runs, std::size_t all_runs);

} // namespace settle::compare
