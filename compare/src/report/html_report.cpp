#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawing.hpp"
#include "figure_data.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "parallel.hpp"
#include "reported_verdicts.hpp"
#include "templates.hpp"

namespace settle::compare {

using namespace report;

namespace {

/// Anchors and names of the runs, for the table of contents.
data contents(const CampaignOutcome& outcome) {
  data list(data::type::list);
  for (const RunOutcome& run : outcome.runs) {
    data entry("anchor", anchor_of(outcome, run));
    entry.set("name", printable(run.name));
    const Status status = worst(reported_verdicts(run));
    entry.set("mark", status == Status::passed ? data(false) : data(status_text(status)));
    list.push_back(entry);
  }
  return list;
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

std::string runs(const CampaignOutcome& outcome, int jobs) {
  std::vector<std::string> sections(outcome.runs.size());
  parallel_for(sections.size(), jobs, [&](std::size_t i) { sections[i] = run_html(outcome, outcome.runs[i]); });
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
  const std::string figures = campaign_figures(outcome);
  data page;
  page.set("style", std::string(templates::style));
  page.set("title", printable(outcome.campaign.title));
  page.set("description", text_or_nothing(outcome.campaign.description));
  page.set("status", std::string(name_of(status)));
  page.set("status_text", status_text(status));
  page.set("counts", count_text(count(verdicts)));
  page.set("run_count", fmt::format("{} run{}", outcome.runs.size(), outcome.runs.size() == 1 ? "" : "s"));
  page.set("contents", contents(outcome));
  page.set("verdicts", verdicts_html(outcome));
  page.set("overview", overview_html(outcome));
  page.set("figures", figures.empty() ? data(false) : data(figures));
  const std::string published = published_html(outcome);
  page.set("published", published.empty() ? data(false) : data(published));
  const std::string families = families_html(outcome);
  page.set("families", families.empty() ? data(false) : data(families));
  page.set("runs", runs(outcome, threads));
  page.set("command", printable(outcome.command));
  page.set("provenance", provenance(outcome));
  return with_figures(render(templates::page, page), threads);
}

} // namespace settle::compare
