#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "html_parts.hpp"
#include "reported_verdicts.hpp"
#include "statistic_text.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

const std::string reading =
    "Checks are relative to what stands below them; margin: the share of the accepted band that is left.";
constexpr std::size_t foldable = 12; // so many passed verdicts are shown without being asked for

std::vector<Column> verdict_columns() {
  return {{"Status", "", false},
          {"Run", "", false},
          {"What", "", false},
          {"Value", "", true},
          {"Accepted", "", true},
          {"Margin", "", true},
          {"Why, and what happened", "", false}};
}

std::string margin_text(double left) {
  if (!std::isfinite(left)) return "";
  return left < -10.0 ? "far outside" : percent(left);
}

/// The address of the section of a run or a family.
std::string anchor_of_name(const CampaignOutcome& outcome, const std::string& name) {
  for (const Family& family : outcome.families) {
    if (family.name == name) return anchor_of(outcome, family);
  }
  return anchor_of(outcome, *outcome.find(name));
}

std::vector<Cell> verdict_row(const CampaignOutcome& outcome, const Verdict& verdict) {
  const std::string band = accepted_band(verdict);
  const std::string value = band.empty() ? "" : value_text(verdict, verdict.value);
  const double left = margin(verdict);
  const std::string reason = verdict.message.empty() ? verdict.why : verdict.message;
  const std::string second = verdict.message.empty() ? "" : verdict.why;
  return {
      status_cell(verdict.status),
      {.text = verdict.run, .link = fmt::format("#{}", anchor_of_name(outcome, verdict.run))},
      {.text = verdict.what, .small_print = verdict.scale.empty() ? "" : fmt::format("relative to {}", verdict.scale)},
      {.text = value},
      {.text = band},
      {.text = margin_text(left)},
      {.text = reason, .small_print = second}};
}

std::string verdict_list(const CampaignOutcome& outcome, const std::vector<Verdict>& verdicts, std::string caption) {
  Table table{std::move(caption), verdict_columns(), {}, true};
  for (const Verdict& verdict : verdicts)
    table.rows.push_back(verdict_row(outcome, verdict));
  return html_of(table);
}

double wall_time(const RunOutcome& run) {
  double sum = 0.0;
  for (const SolverRun& solver : run.solvers)
    sum += solver.wall_time;
  return sum;
}

/// Ours, with its difference from the exact value below.
Cell against_exact(const RunOutcome& run, const std::string& source, Statistic statistic) {
  const double value = measured(run, source, statistic);
  if (!std::isfinite(value)) return {.text = std::string(no_value)};
  return {.text = value_text(statistic, value),
          .small_print = difference_text(statistic, value, exact_value(run, source, statistic))};
}

std::vector<Cell> overview_row(const CampaignOutcome& outcome, const RunOutcome& run) {
  const std::vector<Verdict> verdicts = reported_verdicts(run);
  const std::string remark = out_of_equilibrium(run).empty() ? "" : "out of equilibrium";
  std::vector<Cell> row{{.text = run.name, .link = fmt::format("#{}", anchor_of(outcome, run)), .small_print = remark},
                        status_cell(worst(verdicts)),
                        {.text = fmt::format("{} of {}", count(verdicts).at(Status::passed), verdicts.size())},
                        against_exact(run, "mpm", Statistic::max_settlement),
                        against_exact(run, "mpm", Statistic::max_vertical_stress),
                        against_exact(run, "mpm", Statistic::mean_density),
                        against_exact(run, "fem", Statistic::max_settlement),
                        against_exact(run, "fem", Statistic::max_vertical_stress),
                        {.text = duration(wall_time(run))}};
  for (const SolverRun* joined : outcome.joined_solvers()) {
    row.push_back(against_exact(run, joined->solver, Statistic::max_settlement));
    row.push_back(against_exact(run, joined->solver, Statistic::max_vertical_stress));
  }
  return row;
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

std::string verdicts_html(const CampaignOutcome& outcome) {
  const std::vector<Verdict> all = worst_first(all_verdicts(outcome));
  const auto first_passed =
      std::find_if(all.begin(), all.end(), [](const Verdict& verdict) { return verdict.status == Status::passed; });
  const std::vector<Verdict> open(all.begin(), first_passed);
  const std::vector<Verdict> passed(first_passed, all.end());
  data page;
  page.set("open", open.empty() ? data(false) : data(verdict_list(outcome, open, "Did not pass. " + reading)));
  page.set("passed", passed.empty() ? data(false) : data(verdict_list(outcome, passed, "Passed. " + reading)));
  page.set("passed_count", std::to_string(passed.size()));
  page.set("unfolded", passed.size() <= foldable);
  return render(templates::verdicts, page);
}

std::string overview_html(const CampaignOutcome& outcome) {
  Table table{
      "The runs at their last stage; below each number its difference from the exact solution of the same model",
      {{"Run", "", false},
       {"Status", "", false},
       {"Passed", "", true},
       {"MPM settlement", "m", true},
       {"MPM stress", "kPa", true},
       {"MPM density", "kg/m³", true},
       {"FEM settlement", "m", true},
       {"FEM stress", "kPa", true},
       {"Solvers' time", "", true}},
      {},
      true};
  for (const SolverRun* joined : outcome.joined_solvers()) {
    table.columns.push_back({title_of(*joined) + " settlement", "m", true});
    table.columns.push_back({title_of(*joined) + " stress", "kPa", true});
  }
  for (const RunOutcome& run : outcome.runs)
    table.rows.push_back(overview_row(outcome, run));
  return html_of(table);
}

} // namespace settle::compare::report
