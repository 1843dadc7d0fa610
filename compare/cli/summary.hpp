/// \file
/// The end of a campaign on standard output.
#pragma once

#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare::cli {

/// A line a run with its verdict counts and key figures, then every verdict that is not "passed" with its reason.
std::string summary_text(const CampaignOutcome& outcome);

/// Verdicts that are not "passed", one line each and its message.
std::string failures_text(const std::vector<Verdict>& verdicts);

} // namespace settle::compare::cli
