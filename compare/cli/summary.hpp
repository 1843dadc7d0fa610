/// \file
/// The end of a campaign on standard output.
#pragma once

#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare::cli {

/// The levels of every refinement family with their errors and orders, and what is said of each.
std::string convergence_text(const std::vector<Family>& families);

/// Values that pass but move in one direction from one accepted baseline to the next.
std::string drifts_text(const CampaignOutcome& outcome);

/// A line a run with its verdict counts and key figures, the levels of refinement families, then every verdict that is
/// not "passed" with its reason.
std::string summary_text(const CampaignOutcome& outcome);

/// Verdicts that are not "passed", one line each and its message.
std::string failures_text(const std::vector<Verdict>& verdicts);

} // namespace settle::compare::cli
