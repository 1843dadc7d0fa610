#include <fmt/format.h>

#include "base_chart.hpp"
#include "case_entries.hpp"
#include "difference_chart.hpp"
#include "figure_data.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "line_figure.hpp"
#include "reported_verdicts.hpp"
#include "settle/compare/statistics.hpp"
#include "settle/exchange/case_io.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

using exchange::Quantity;

data paragraphs(const std::vector<std::string>& texts) {
  data list(data::type::list);
  for (const std::string& text : texts)
    list.push_back(data("text", printable(text)));
  return texts.empty() ? data(false) : list;
}

/// Beside the figure they are the differences of.
std::string differences(Chart chart, const std::string& figure) {
  chart.id = figure + "-differences";
  return chart_html(std::move(chart));
}

std::string line_figures(const CampaignOutcome& outcome, const RunOutcome& run) {
  std::string html;
  for (Plot& plot : line_plots_of(run, outcome)) {
    plot.id = fmt::format("{}-{}", anchor_of(outcome, run), plot.id);
    html += figure_html(plot, "");
    html += differences(difference_chart(run, plot.line, plot.quantity), plot.id);
  }
  return html;
}

std::string figures(const CampaignOutcome& outcome, const RunOutcome& run) {
  if (is_body(run.study)) return line_figures(outcome, run);
  std::string html;
  for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress}) {
    Plot plot = plot_of(run, quantity, outcome);
    plot.id = fmt::format("{}-{}", anchor_of(outcome, run), name_of(quantity));
    html += figure_html(plot, "");
    html += differences(difference_chart(run, quantity), plot.id);
  }
  return html;
}

std::string distribution_along_base(const CampaignOutcome& outcome, const RunOutcome& run) {
  Chart chart = base_chart(run);
  if (chart.series.empty()) return {};
  chart.id = anchor_of(outcome, run) + "-base";
  return chart_html(std::move(chart));
}

std::string balances(const RunOutcome& run) {
  const Table table = balance_table(run);
  return table.rows.empty() ? std::string() : html_of(table);
}

std::string splits(const RunOutcome& run) {
  std::string html;
  for (const DifferenceSplit& split : run.splits)
    html += html_of(split_table(split, run.study.geometry.dimension));
  return html;
}

data refill(const RunOutcome& run) {
  if (!(measured(run, "mpm", Statistic::refilled_points) > 0.0)) return data(false);
  return data(html_of(refill_table(*run.result_of("mpm"))));
}

data failure(const RunOutcome& run) {
  const Table onsets = onset_table(run), run_outs = run_out_table(run);
  if (onsets.rows.empty()) return data(false);
  return data(html_of(onsets) + (run_outs.rows.empty() ? std::string() : html_of(run_outs)));
}

/// What the solvers that did not finish said last.
data tails(const RunOutcome& run) {
  data list(data::type::list);
  bool any = false;
  for (const SolverRun& solver : run.solvers) {
    if (solver.tail.empty() || solver.status == SolverStatus::finished) continue;
    data entry("solver", solver.solver);
    entry.set("tail", printable(solver.tail));
    list.push_back(entry);
    any = true;
  }
  return any ? list : data(false);
}

data commands(const RunOutcome& run) {
  data list(data::type::list);
  for (const SolverRun& solver : run.solvers)
    list.push_back(data("command", printable(solver.command)));
  return list;
}

/// The case in the words of a solver's result, where they say something else than the parameters do.
data case_text(const RunOutcome& run) {
  const std::string parameters = exchange::to_toml(run.study);
  for (const SolverRun& solver : run.solvers) {
    if (solver.result && solver.result->case_text != parameters) return text_or_nothing(solver.result->case_text);
  }
  return data(false);
}

} // namespace

std::string run_html(const CampaignOutcome& outcome, const RunOutcome& run, const Facets& facets, bool open) {
  const std::vector<Verdict> verdicts = reported_verdicts(run);
  const Status status = worst(verdicts);
  const std::vector<std::string> restless = out_of_equilibrium(run);
  data section;
  section.set("id", anchor_of(outcome, run));
  section.set("name", printable(run.name));
  section.set("status", std::string(name_of(status)));
  section.set("status_text", status_text(status));
  section.set("counts", count_text(count(verdicts)));
  section.set("open", open);
  section.set("title", text_or_nothing(run.study.title));
  section.set("source", text_or_nothing(run.study.source));
  section.set("note", text_or_nothing(run.note));
  section.set("out_of_equilibrium", !restless.empty());
  section.set("restless", paragraphs(restless));
  section.set("overrides", paragraphs(run.overrides));
  section.set("verdicts", html_of(verdict_table(for_reading(verdicts), facets)));
  section.set("solvers", html_of(solver_table(run)));
  section.set("tails", tails(run));
  section.set("failure", failure(run));
  section.set("key_figures", html_of(key_figure_table(run)));
  section.set("figures", figures(outcome, run) + distribution_along_base(outcome, run));
  section.set("exact", formulas_html(outcome, run));
  section.set("history", history_html(outcome, run));
  section.set("fields", fields_html(outcome, run));
  section.set("splits", run.splits.empty() ? data(false) : data(splits(run)));
  section.set("unaudited", paragraphs(unaudited_reactions(run)));
  section.set("balances", balances(run));
  section.set("refill", refill(run));
  section.set("parameters", html_of(parameter_table(run)));
  section.set("case_text", case_text(run));
  section.set("commands", commands(run));
  section.set("provenance", html_of(provenance_table(run)));
  return render(templates::run, section);
}

} // namespace settle::compare::report
