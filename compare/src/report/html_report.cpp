#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "case_entries.hpp"
#include "drawing.hpp"
#include "figure_data.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "parallel.hpp"
#include "reported_verdicts.hpp"
#include "script_hash.hpp"
#include "shared_shapes.hpp"
#include "templates.hpp"

namespace settle::compare {

using namespace report;

namespace {

/// The choices of a filter: their places in the list, which the rows' marks name, and how they are shown.
data choices(const std::vector<std::string>& titles) {
  data list(data::type::list);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    data entry("number", std::to_string(i));
    entry.set("title", titles[i]);
    list.push_back(entry);
  }
  return list;
}

/// The statuses that occur, failures first.
data statuses(const std::vector<Verdict>& verdicts) {
  data list(data::type::list);
  for (const Status status : {Status::error, Status::missing, Status::failed, Status::passed}) {
    const int number = count(verdicts).at(status);
    if (number == 0) continue;
    const std::string name(name_of(status));
    data entry("name", name);
    entry.set("letter", name.substr(0, 1));
    entry.set("text", status_text(status));
    entry.set("count", std::to_string(number));
    list.push_back(entry);
  }
  return list;
}

void set_cases(const CampaignOutcome& outcome, const std::vector<CaseEntry>& cases, const Facets& facets, data& page) {
  std::vector<std::string> legs, quantities;
  for (const std::string& leg : facets.legs)
    legs.push_back(Facets::title_of_leg(leg));
  for (const std::string& quantity : facets.quantities)
    quantities.push_back(quantity.empty() ? "other" : quantity);
  const std::vector<Verdict> verdicts = all_verdicts(outcome);
  const std::string problems = problems_html(outcome, facets);
  page.set("legs", choices(legs));
  page.set("quantities", choices(quantities));
  page.set("statuses", statuses(verdicts));
  page.set("case_count", std::to_string(cases.size()));
  page.set("verdict_count", std::to_string(verdicts.size()));
  page.set("problems", problems.empty() ? data(false) : data(problems));
  page.set("index", index_html(outcome, cases));
  page.set("matrix", matrix_html(cases, facets));
}

std::string campaign_figures(const CampaignOutcome& outcome) {
  std::string html;
  int number = 0;
  for (const Figure& figure : outcome.campaign.figures) {
    Plot plot = plot_of(figure, outcome);
    plot.id = fmt::format("fig-{}-{}", ++number, slug(figure.name)); // names may differ in signs only
    html += figure_html(plot, figure.caption);
  }
  return html;
}

std::string runs(const CampaignOutcome& outcome, const Facets& facets, int threads) {
  constexpr std::ptrdiff_t unfolded = 5; // so many runs that did not pass are open from the start
  const auto is_open = [](const RunOutcome& run) { return worst(reported_verdicts(run)) != Status::passed; };
  const bool few = std::count_if(outcome.runs.begin(), outcome.runs.end(), is_open) <= unfolded;
  std::vector<std::string> sections(outcome.runs.size());
  parallel_for(sections.size(), threads, [&](std::size_t i) {
    const RunOutcome& run = outcome.runs[i];
    sections[i] = run_html(outcome, run, facets, few && is_open(run));
  });
  return fmt::format("{}", fmt::join(sections, ""));
}

data provenance(const CampaignOutcome& outcome) {
  data entry("version", outcome.program_version);
  entry.set("commit", outcome.commit);
  entry.set("created", outcome.created);
  entry.set("wall_time", duration(outcome.wall_time));
  return entry;
}

} // namespace

std::string html_report(const CampaignOutcome& outcome, int jobs) {
  const int threads = jobs > 0 ? jobs : cores();
  const std::vector<Verdict> verdicts = all_verdicts(outcome);
  const Status status = worst(verdicts);
  const std::vector<CaseEntry> cases = case_entries(outcome);
  const Facets facets = facets_of(cases);
  const std::string figures = campaign_figures(outcome);
  data page;
  page.set("style", std::string(templates::style));
  page.set("script", std::string(templates::script));
  page.set("script_hash", hash_of_script(templates::script));
  page.set("title", printable(outcome.campaign.title));
  page.set("description", text_or_nothing(outcome.campaign.description));
  page.set("status", std::string(name_of(status)));
  page.set("status_text", status_text(status));
  page.set("counts", count_text(count(verdicts)));
  page.set("run_count", fmt::format("{} run{}", outcome.runs.size(), outcome.runs.size() == 1 ? "" : "s"));
  set_cases(outcome, cases, facets, page);
  page.set("figures", figures.empty() ? data(false) : data(figures));
  const std::string published = published_html(outcome);
  page.set("published", published.empty() ? data(false) : data(published));
  const std::string families = families_html(outcome, facets);
  page.set("families", families.empty() ? data(false) : data(families));
  page.set("runs", runs(outcome, facets, threads));
  const bool any_split =
      std::any_of(outcome.runs.begin(), outcome.runs.end(), [](const RunOutcome& run) { return !run.splits.empty(); });
  page.set("parts", any_split ? data(html_of(parts_table())) : data(false));
  page.set("glossary", html_of(glossary_table(outcome)));
  page.set("command", printable(outcome.command));
  page.set("provenance", provenance(outcome));
  return with_shared_shapes(with_figures(render(templates::page, page), threads));
}

} // namespace settle::compare
