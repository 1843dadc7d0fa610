#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "curve_styles.hpp"
#include "format.hpp"
#include "history_chart.hpp"
#include "html_parts.hpp"
#include "profiles.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/compare/statistics.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::report {

namespace {

using exchange::Kinematics;
using exchange::Quantity;

/// One value a stage.
struct History {
  std::string label, source;
  std::vector<double> values; ///< [m]
};

/// NaN where one of the values is, or there is none.
double largest(const std::vector<double>& values) {
  double so_far = values.empty() ? std::nan("") : values.front();
  for (const double value : values)
    if (!(value <= so_far)) so_far = value;
  return so_far;
}

/// Over the points that were not refilled and the probes.
History of_solver(const SolverRun& solver) {
  History history{.label = title_of(solver), .source = solver.solver, .values = {}};
  for (const exchange::Stage& stage : solver.result->stages) {
    const int dimension = solver.result->used.dimension;
    std::vector<double> values = point_samples(stage, dimension, Quantity::settlement).value;
    const std::vector<double> probes = probe_samples(stage, dimension, Quantity::settlement).value;
    values.insert(values.end(), probes.begin(), probes.end());
    history.values.push_back(largest(values));
  }
  return history;
}

/// Of a column its own largest; of a body the largest at the points of the first solver that has some.
double exact_largest(const RunOutcome& run, Kinematics kinematics, int stage) {
  if (run.study.geometry.shape == exchange::Shape::column)
    return ExactColumn(run.study, kinematics).largest_settlement(stage);
  const auto exact = exact_solution(run.study, kinematics);
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result || solver.result->stages.size() < static_cast<std::size_t>(stage)) continue;
    const auto& state = solver.result->stages[static_cast<std::size_t>(stage - 1)];
    const FieldSamples samples = point_samples(state, 2, Quantity::settlement);
    std::vector<double> values;
    for (std::size_t i = 0; i < samples.size(); ++i)
      append_field(exact->at({samples.layer[i], samples.x[i], samples.height[i], true}, stage), 2, Quantity::settlement,
                   values);
    if (!values.empty()) return largest(values);
  }
  return std::nan("");
}

/// Of each model that a solver of the run solves; a body has one whatever its solvers do.
std::vector<History> of_exact(const RunOutcome& run, std::vector<std::string>& missing) {
  std::set<Kinematics> models;
  const bool is_column = run.study.geometry.shape == exchange::Shape::column;
  for (const SolverRun& solver : run.solvers)
    models.insert(is_column ? kinematics_solved(run, solver.solver) : Kinematics::finite);
  std::vector<History> histories;
  for (const Kinematics kinematics : models) {
    History history{.label = "exact", .source = "exact", .values = {}};
    if (is_column) history.label += fmt::format(", {} strain", name_of(kinematics));
    if (kinematics == Kinematics::small) history.source = "exact-small";
    try {
      const std::string reason = exact_solution(run.study, kinematics)->lacks(Quantity::settlement);
      for (int stage = 1; reason.empty() && stage <= run.study.n_stages(); ++stage)
        history.values.push_back(exact_largest(run, kinematics, stage));
      if (reason.empty())
        histories.push_back(std::move(history));
      else
        missing.push_back(fmt::format("{}: {}", history.label, reason));
    } catch (const exchange::InputError& error) { // there is no exact column
      missing.push_back(fmt::format("{}: {}", history.label, error.what()));
    }
  }
  return histories;
}

ChartSeries series_of(const History& history) {
  const CurveStyle style = style_of(history.source);
  ChartSeries series{.label = history.label,
                     .colour = style.colour,
                     .line = style.line,
                     .dashed = style.line && style.dash_type != 1,
                     .pieces = {{}}};
  for (std::size_t i = 0; i < history.values.size(); ++i)
    series.pieces[0].push_back({static_cast<double>(i + 1), history.values[i]});
  return series;
}

/// The numbers of a chart whose series have a finite value at every stage or end early.
Table table_of(const Chart& chart) {
  Table table{chart.title + " [m]", {{"Stage", "", false}}, {}};
  std::size_t stages = 0;
  for (const ChartSeries& series : chart.series) {
    table.columns.push_back({series.label.substr(0, series.label.find(':')), "", true});
    stages = std::max(stages, series.pieces[0].size());
  }
  for (std::size_t i = 0; i < stages; ++i) {
    std::vector<Cell> row{{.text = std::to_string(i + 1)}};
    for (const ChartSeries& series : chart.series) {
      const auto& points = series.pieces[0];
      row.push_back({.text = i < points.size() ? number(points[i].y, 4) : std::string(no_value)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

} // namespace

Chart history_chart(const RunOutcome& run) {
  Chart chart;
  std::vector<History> histories;
  for (const SolverRun& solver : run.solvers)
    if (solver.result) histories.push_back(of_solver(solver));
  if (histories.empty()) return chart;
  for (History& exact : of_exact(run, chart.missing))
    histories.push_back(std::move(exact));
  for (const History& history : histories) {
    chart.series.push_back(series_of(history));
    drop_points_that_are_not_finite(chart.series.back(), chart.missing);
    if (!history.values.empty()) chart.series.back().label += fmt::format(": {} m", number(history.values.back(), 4));
  }
  chart.title = "Largest settlement after each stage";
  chart.x = {.title = "Stage"};
  chart.y = {.title = "Largest settlement", .unit = "m"};
  return chart;
}

std::string history_html(const CampaignOutcome& outcome, const RunOutcome& run) {
  constexpr int few = 5; // stages whose numbers are read more easily than a drawing
  Chart chart = history_chart(run);
  if (run.study.n_stages() < 2 || chart.series.empty()) return {};
  if (run.study.n_stages() <= few && chart.missing.empty()) return html_of(table_of(chart));
  chart.id = anchor_of(outcome, run) + "-history";
  return chart_html(std::move(chart));
}

} // namespace settle::compare::report
