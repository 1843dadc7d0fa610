/// \file
/// The cases of a campaign as its index lists them: every run, and every refinement family.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

struct CaseEntry {
  std::string name;
  std::string anchor;              ///< of its section
  const RunOutcome* run = nullptr; ///< nothing for a family
  std::vector<Verdict> verdicts;
  Status status = Status::missing; ///< the worst
};

/// All cases, what did not pass first.
std::vector<CaseEntry> case_entries(const CampaignOutcome& outcome);

/// What verdicts can be filtered by. Each list is in the order in which verdicts first name them; legs of two sides go
/// before what concerns one solver alone.
struct Facets {
  std::vector<std::string> legs, quantities;

  /// "mpm - exact" as people read it: "mpm − exact", "mpm alone", "other".
  [[nodiscard]] static std::string title_of_leg(const std::string& leg);
  /// The verdict's status (its first letter) and its places in the two lists: "p 0 2".
  [[nodiscard]] std::string mark_of(const Verdict& verdict) const;
};

Facets facets_of(const std::vector<CaseEntry>& cases);

} // namespace settle::compare::report
