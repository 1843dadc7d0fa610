#include <fmt/format.h>

#include "format.hpp"
#include "html_parts.hpp"
#include "statistic_text.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

std::vector<Cell> published_row(const CampaignOutcome& outcome, const Published& published) {
  const StatisticForm form = form_of(published.statistic);
  const RunOutcome* run = outcome.find(published.run);
  const auto shown = [&](double value) { return Cell{.text = value_text(published.statistic, value)}; };
  if (run == nullptr) {
    std::vector<Cell> row(10, {.text = std::string(no_value)});
    row[0] = {.text = published.label, .small_print = fmt::format("the campaign has no run “{}”", published.run)};
    row[2] = shown(published.value);
    row[9] = {.text = published.why};
    return row;
  }
  const double ours = measured(*run, published.source, published.statistic);
  const double fem = measured(*run, "fem", published.statistic);
  const double exact = exact_value(*run, published.source, published.statistic);
  return {{.text = published.label,
           .link = fmt::format("#{}", anchor_of(outcome, *run)),
           .small_print = form.unit.empty() ? form.title : fmt::format("{} [{}]", form.title, form.unit)},
          {.text = published.run, .small_print = fmt::format("by {}", published.source)},
          shown(published.value),
          shown(ours),
          shown(fem),
          shown(exact),
          {.text = difference_text(published.statistic, published.value, ours)},
          {.text = difference_text(published.statistic, published.value, exact)},
          {.text = difference_text(published.statistic, ours, exact)},
          {.text = published.why}};
}

} // namespace

std::string published_html(const CampaignOutcome& outcome) {
  if (outcome.campaign.published.empty()) return "";
  Table table{"Numbers somebody printed, beside ours and the exact ones",
              {{"Number", "", false},
               {"Run", "", false},
               {"Printed", "", true},
               {"Ours", "", true},
               {"Our FEM", "", true},
               {"Exact", "", true},
               {"Printed − ours", "", true},
               {"Printed − exact", "", true},
               {"Ours − exact", "", true},
               {"Why they differ", "", false}},
              {},
              true};
  for (const Published& published : outcome.campaign.published)
    table.rows.push_back(published_row(outcome, published));
  return render(templates::published, data("table", html_of(table)));
}

} // namespace settle::compare::report
