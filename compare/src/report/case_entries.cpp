#include "case_entries.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "html_parts.hpp"
#include "reported_verdicts.hpp"

namespace settle::compare::report {

namespace {

void add(std::vector<std::string>& list, const std::string& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

std::size_t place_in(const std::vector<std::string>& list, const std::string& value) {
  return static_cast<std::size_t>(std::find(list.begin(), list.end(), value) - list.begin());
}

bool has_two_sides(const std::string& leg) {
  return leg.find(" - ") != std::string::npos;
}

} // namespace

std::vector<CaseEntry> case_entries(const CampaignOutcome& outcome) {
  std::vector<CaseEntry> cases;
  for (const Family& family : outcome.families)
    cases.push_back({.name = family.name, .anchor = anchor_of(outcome, family), .verdicts = family.verdicts});
  for (const RunOutcome& run : outcome.runs)
    cases.push_back(
        {.name = run.name, .anchor = anchor_of(outcome, run), .run = &run, .verdicts = reported_verdicts(run)});
  for (CaseEntry& entry : cases)
    entry.status = worst(entry.verdicts);
  std::stable_sort(cases.begin(), cases.end(),
                   [](const CaseEntry& a, const CaseEntry& b) { return rank(a.status) < rank(b.status); });
  return cases;
}

std::string Facets::title_of_leg(const std::string& leg) {
  const std::size_t minus = leg.find(" - ");
  if (minus != std::string::npos) return leg.substr(0, minus) + " − " + leg.substr(minus + 3);
  return leg.empty() ? "other" : leg + " alone";
}

std::string Facets::mark_of(const Verdict& verdict) const {
  return fmt::format("{} {} {}", name_of(verdict.status).front(), place_in(legs, verdict.leg),
                     place_in(quantities, verdict.quantity));
}

Facets facets_of(const std::vector<CaseEntry>& cases) {
  Facets facets;
  for (const CaseEntry& entry : cases) {
    for (const Verdict& verdict : entry.verdicts) {
      add(facets.legs, verdict.leg);
      add(facets.quantities, verdict.quantity);
    }
  }
  std::stable_partition(facets.legs.begin(), facets.legs.end(), has_two_sides);
  std::stable_partition(facets.legs.begin(), facets.legs.end(), [](const std::string& leg) { return !leg.empty(); });
  return facets;
}

} // namespace settle::compare::report
