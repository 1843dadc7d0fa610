/// \file
/// The verdicts of a campaign as all four outputs state them.
#pragma once

#include <map>
#include <vector>

#include "settle/compare/report.hpp"

namespace settle::compare::report {

/// Failing statuses first; within them the ones that need a look soonest.
int rank(Status status);
/// The verdicts of all refinement families, then of all runs, in their order.
std::vector<Verdict> all_verdicts(const CampaignOutcome& outcome);
/// The same with what did not pass first: error, missing, failed, passed; the order within one status is kept.
std::vector<Verdict> worst_first(std::vector<Verdict> verdicts);
/// What did not pass first, and within one status the case's own checks before audits.
std::vector<Verdict> for_reading(std::vector<Verdict> verdicts);
/// How many there are of each status; every status has an entry.
std::map<Status, int> count(const std::vector<Verdict>& verdicts);
/// "3 failed, 1 missing, 12 passed": failures first, statuses that do not occur left out ("no verdict" if none does).
std::string count_text(const std::map<Status, int>& counts);

/// A value of this verdict: in percent for a check, else a plain number (many audits count or are at round-off).
std::string value_text(const Verdict& verdict, double value);
/// The accepted values: "≤ 1 %", "98.7 % … 101 %", "5"; nothing for a verdict without a number.
std::string accepted_band(const Verdict& verdict);
/// How much of the accepted band is left on the nearer side, relative to its upper end; negative outside; NaN where
/// there is none.
double margin(const Verdict& verdict);

/// A margin in whole percent; "far outside" below −1000 %; nothing where there is none.
std::string margin_text(double left);

} // namespace settle::compare::report
