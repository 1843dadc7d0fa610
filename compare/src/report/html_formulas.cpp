#include <algorithm>

#include <fmt/format.h>

#include "exact_formulas.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "mathml.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

/// Everything that is said, as one text: equal where two runs have the same exact solutions.
std::string text_of(const std::vector<FormulaGroup>& groups) {
  std::string text;
  for (const FormulaGroup& group : groups) {
    text += group.title + "\n";
    for (const Formula& formula : group.formulas)
      text += formula.text + "\t" + formula.meaning + "\n";
  }
  return text;
}

/// The first run of the campaign with the same formulas: this one, or one before it.
const RunOutcome& first_with(const CampaignOutcome& outcome, const RunOutcome& run, const std::string& text) {
  for (const RunOutcome& each : outcome.runs) {
    if (&each == &run) break;
    if (text_of(exact_formulas(each)) == text) return each;
  }
  return run;
}

data data_of(const FormulaGroup& group) {
  data formulas(data::type::list);
  for (const Formula& formula : group.formulas) {
    const std::optional<std::string> typeset = mathml_of(formula.text);
    data entry("meaning", text_or_nothing(formula.meaning));
    entry.set("math", typeset ? data(*typeset) : data(false));
    entry.set("text", typeset ? data(false) : data(printable(formula.text)));
    formulas.push_back(entry);
  }
  data all("title", group.title);
  all.set("formulas", formulas);
  return all;
}

} // namespace

std::string formulas_html(const CampaignOutcome& outcome, const RunOutcome& run) {
  const std::vector<FormulaGroup> groups = exact_formulas(run);
  if (groups.empty()) return {};
  data section("id", anchor_of(outcome, run) + "-exact");
  const RunOutcome& first = first_with(outcome, run, text_of(groups));
  if (&first != &run) {
    section.set("same_as", anchor_of(outcome, first) + "-exact");
    section.set("name", printable(first.name));
    section.set("groups", data(false));
  } else {
    section.set("same_as", data(false));
    data list(data::type::list);
    for (const FormulaGroup& group : groups)
      list.push_back(data_of(group));
    section.set("groups", list);
  }
  return render(templates::formulas, section);
}

} // namespace settle::compare::report
