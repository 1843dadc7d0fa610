#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "case_entries.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "reported_verdicts.hpp"
#include "statistic_text.hpp"

namespace settle::compare::report {

namespace {

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

/// The smallest margin of a case's checks; NaN where none has one.
double tightest(const std::vector<Verdict>& verdicts) {
  double least = std::numeric_limits<double>::quiet_NaN();
  for (const Verdict& verdict : verdicts) {
    const double left = verdict.kind == "check" ? margin(verdict) : std::nan("");
    if (!(left >= least)) least = std::isnan(left) ? least : left;
  }
  return least;
}

/// The first cells of a row, in the index and in the matrix.
std::vector<Cell> head_of(const CaseEntry& entry) {
  std::string remark = entry.run == nullptr ? "refinement family" : "";
  if (entry.run != nullptr && !out_of_equilibrium(*entry.run).empty()) remark = "out of equilibrium";
  return {{.text = entry.name, .link = "#" + entry.anchor, .small_print = remark}, status_cell(entry.status)};
}

std::string mark_of(const CaseEntry& entry) {
  return fmt::format("data-case=\"{}\"", entry.anchor);
}

std::vector<Cell> index_row(const CampaignOutcome& outcome, const CaseEntry& entry) {
  std::vector<Cell> row = head_of(entry);
  row.push_back({.text = fmt::format("{} of {}", count(entry.verdicts).at(Status::passed), entry.verdicts.size())});
  row.push_back({.text = margin_text(tightest(entry.verdicts))});
  const auto figure = [&](const std::string& source, Statistic statistic) {
    row.push_back(entry.run == nullptr ? Cell{.text = std::string(no_value)}
                                       : against_exact(*entry.run, source, statistic));
  };
  figure("mpm", Statistic::max_settlement);
  figure("mpm", Statistic::max_vertical_stress);
  figure("mpm", Statistic::mean_density);
  figure("fem", Statistic::max_settlement);
  figure("fem", Statistic::max_vertical_stress);
  for (const SolverRun* joined : outcome.joined_solvers()) {
    figure(joined->solver, Statistic::max_settlement);
    figure(joined->solver, Statistic::max_vertical_stress);
  }
  row.push_back({.text = entry.run == nullptr ? std::string(no_value) : duration(wall_time(*entry.run))});
  return row;
}

} // namespace

Cell matrix_cell(const CaseEntry& entry, const std::string& leg) {
  std::vector<Verdict> verdicts = entry.verdicts;
  std::erase_if(verdicts, [&](const Verdict& verdict) { return verdict.leg != leg; });
  if (verdicts.empty()) return {.text = std::string(no_value)};
  const Status status = worst(verdicts);
  const std::string sign = status_text(status).substr(0, status_text(status).find(' '));
  return {.text = fmt::format("{} {} of {}", sign, count(verdicts).at(Status::passed), verdicts.size()),
          .badge = std::string(name_of(status))};
}

std::string index_html(const CampaignOutcome& outcome, const std::vector<CaseEntry>& cases) {
  Table table{"The cases at their last stage, what did not pass first; below each number its difference from the exact "
              "solution of the same model",
              {{"Case", "", false},
               {"Verdict", "", false},
               {"Passed", "", true},
               {"Least margin", "", true},
               {"MPM settlement", "m", true},
               {"MPM stress", "kPa", true},
               {"MPM density", "kg/m³", true},
               {"FEM settlement", "m", true},
               {"FEM stress", "kPa", true}},
              {},
              true,
              "index-table",
              "index of-cases",
              true};
  for (const SolverRun* joined : outcome.joined_solvers()) {
    table.columns.push_back({title_of(*joined) + " settlement", "m", true});
    table.columns.push_back({title_of(*joined) + " stress", "kPa", true});
  }
  table.columns.push_back({"Solvers' time", "", true});
  for (const CaseEntry& entry : cases) {
    table.rows.push_back(index_row(outcome, entry));
    table.marks.push_back(mark_of(entry));
  }
  return html_of(table);
}

std::string matrix_html(const std::vector<CaseEntry>& cases, const Facets& facets) {
  Table table{"Each case with each leg: how many verdicts passed of all, and the sign of the worst (✓ all passed, ✗ "
              "failed, ? missing, ! error)",
              {{"Case", "", false}, {"Verdict", "", false}},
              {},
              false,
              "matrix-table",
              "matrix of-cases",
              true};
  for (const std::string& leg : facets.legs)
    table.columns.push_back({Facets::title_of_leg(leg), "", false});
  for (const CaseEntry& entry : cases) {
    std::vector<Cell> row = head_of(entry);
    for (const std::string& leg : facets.legs)
      row.push_back(matrix_cell(entry, leg));
    table.rows.push_back(std::move(row));
    table.marks.push_back(mark_of(entry));
  }
  return html_of(table);
}

} // namespace settle::compare::report
