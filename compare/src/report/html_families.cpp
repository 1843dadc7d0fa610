#include <fmt/format.h>

#include "case_entries.hpp"
#include "convergence_figure.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "reported_verdicts.hpp"
#include "settle/compare/convergence_text.hpp"
#include "settle/compare/refinement_levels.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

Table level_table(const CampaignOutcome& outcome, const Family& family, const ConvergenceStudy& study) {
  Table table{study.title(),
              {{"Level", "", false},
               {size_title(family.size), "", true},
               {"Norm", study.unit, true},
               {study.errors.empty() ? "Relative change" : "Relative error", "", true},
               {"Order", "", true}},
              {},
              false};
  const std::vector<ConvergenceRow> rows = rows_of(study);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string link = fmt::format("#{}", anchor_of(outcome, *outcome.find(family.runs[i])));
    table.rows.push_back({{.text = std::to_string(i + 1), .link = link},
                          {.text = rows[i].size},
                          {.text = rows[i].value},
                          {.text = rows[i].error},
                          {.text = rows[i].order}});
  }
  return table;
}

data studies(const CampaignOutcome& outcome, const Family& family) {
  data list(data::type::list);
  for (const ConvergenceStudy& study : family.studies) {
    data entry;
    entry.set("table", html_of(level_table(outcome, family, study)));
    entry.set("conclusion", printable(conclusion_of(study)));
    entry.set("why", text_or_nothing(study.expected.why));
    entry.set("extrapolation", text_or_nothing(extrapolation_of(study)));
    list.push_back(entry);
  }
  return list;
}

std::string figures(const CampaignOutcome& outcome, const Family& family) {
  std::vector<std::string> missing;
  const std::vector<ConvergencePlot> plots = convergence_plots(family, missing);
  const std::string id = anchor_of(outcome, family);
  std::string html;
  for (const ConvergencePlot& plot : plots) {
    const std::string quantity(exchange::name_of(plot.quantity));
    html += figure_html(Drawing{.id = fmt::format("{}-{}", id, quantity),
                                .title = fmt::format("Convergence of {}, {}", quantity, family.name),
                                .caption = "Lines are fitted; a triangle has the slope that is expected.",
                                .script = gnuplot_script(plot),
                                .missing = {}});
  }
  if (missing.empty()) return html;
  return html +
         figure_html(Drawing{.id = id + "-missing", .title = "", .caption = "", .script = "", .missing = missing});
}

std::string family_html(const CampaignOutcome& outcome, const Family& family, const Facets& facets) {
  const Status status = worst(family.verdicts);
  const RunOutcome& first = *outcome.find(family.runs.front());
  data section;
  section.set("id", anchor_of(outcome, family));
  section.set("name", printable(family.name));
  section.set("status", std::string(name_of(status)));
  section.set("status_text", status_text(status));
  section.set("counts", count_text(count(family.verdicts)));
  section.set("title", text_or_nothing(first.study.title));
  section.set("source", text_or_nothing(first.study.source));
  section.set("note", text_or_nothing(first.note));
  section.set("figures", figures(outcome, family));
  section.set("studies", studies(outcome, family));
  section.set("verdicts", html_of(verdict_table(for_reading(family.verdicts), facets)));
  return render(templates::family, section);
}

} // namespace

std::string families_html(const CampaignOutcome& outcome, const Facets& facets) {
  std::string html;
  for (const Family& family : outcome.families)
    html += family_html(outcome, family, facets);
  return html;
}

} // namespace settle::compare::report
