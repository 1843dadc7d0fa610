#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "case_entries.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "reported_verdicts.hpp"

namespace settle::compare::report {

namespace {

const std::string reading =
    "Checks are relative to what stands below them; margin: the share of the accepted band that is left.";

template <class Part>
void prepend(std::vector<Part>& list, Part first) {
  list.push_back(std::move(first));
  std::rotate(list.rbegin(), list.rbegin() + 1, list.rend());
}

/// The address of the section of a run or a family.
std::string anchor_of_name(const CampaignOutcome& outcome, const std::string& name) {
  for (const Family& family : outcome.families) {
    if (family.name == name) return anchor_of(outcome, family);
  }
  return anchor_of(outcome, *outcome.find(name));
}

std::vector<Cell> verdict_row(const Verdict& verdict) {
  const std::string band = accepted_band(verdict);
  const std::string value = band.empty() ? "" : value_text(verdict, verdict.value);
  const std::string reason = verdict.message.empty() ? verdict.why : verdict.message;
  const std::string second = verdict.message.empty() ? "" : verdict.why;
  return {
      {.text = verdict.what, .small_print = verdict.scale.empty() ? "" : fmt::format("relative to {}", verdict.scale)},
      status_cell(verdict.status),
      {.text = value},
      {.text = band},
      {.text = margin_text(margin(verdict))},
      {.text = reason, .small_print = second}};
}

} // namespace

std::string anchor_of(const CampaignOutcome& outcome, const RunOutcome& run) {
  const auto index = &run - outcome.runs.data();
  return fmt::format("run-{}-{}", index + 1, slug(run.name));
}

std::string anchor_of(const CampaignOutcome& outcome, const Family& family) {
  const auto index = &family - outcome.families.data();
  return fmt::format("family-{}-{}", index + 1, slug(family.name));
}

Table verdict_table(const std::vector<Verdict>& verdicts, const Facets& facets) {
  Table table{"Verdicts, what did not pass first",
              {{"What", "", false},
               {"Verdict", "", false},
               {"Value", "", true},
               {"Accepted", "", true},
               {"Margin", "", true},
               {"Why, and what happened", "", false}},
              {},
              true,
              "",
              "verdicts",
              false,
              false};
  for (const Verdict& verdict : verdicts) {
    table.rows.push_back(verdict_row(verdict));
    table.marks.push_back(fmt::format("data-f=\"{}\"", facets.mark_of(verdict)));
  }
  return table;
}

std::string problems_html(const CampaignOutcome& outcome, const Facets& facets) {
  std::vector<Verdict> open = for_reading(all_verdicts(outcome));
  std::erase_if(open, [](const Verdict& verdict) { return verdict.status == Status::passed; });
  if (open.empty()) return "";
  Table table = verdict_table(open, facets);
  table.caption = "Verdicts that did not pass. " + reading;
  table.id = "problem-table";
  table.kind = "verdicts of-cases";
  table.sorts = true;
  prepend(table.columns, Column{"Case", "", false});
  for (std::size_t i = 0; i < open.size(); ++i) {
    const std::string anchor = anchor_of_name(outcome, open[i].run);
    prepend(table.rows[i], Cell{.text = open[i].run, .link = "#" + anchor});
    table.marks[i] += fmt::format(" data-case=\"{}\"", anchor);
  }
  return html_of(table);
}

} // namespace settle::compare::report
