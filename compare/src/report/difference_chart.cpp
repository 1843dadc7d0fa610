#include "difference_chart.hpp"

#include <fmt/format.h>

#include "curve_styles.hpp"
#include "line_figure.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/compare/statistics.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/probe_points.hpp"

namespace settle::compare::report {

namespace {

using exchange::Quantity;

constexpr std::size_t spots_of_a_curve = 45;

/// Where a solver is compared, and how samples become a profile.
struct Place {
  const RunOutcome& run;
  Quantity quantity;
  std::string line; ///< of probes; empty: a column

  [[nodiscard]] bool by_points(const SolverRun& solver) const {
    return line.empty() && (solver.solver == "mpm" || run.study.probes.empty());
  }
  /// At probes of the design geometry, or at points as placed.
  [[nodiscard]] FieldSamples samples(const SolverRun& solver) const {
    const exchange::Result& result = *solver.result;
    const exchange::Stage& last = result.stages.back();
    if (by_points(solver)) return point_samples(last, result.used.dimension, quantity);
    if (line.empty()) return probe_samples(last, result.used.dimension, quantity);
    const auto found = last.probes.find(line);
    return found != last.probes.end() ? line_samples(found->second, result.used.dimension, quantity) : FieldSamples{};
  }
  [[nodiscard]] Profile profile(const FieldSamples& samples) const {
    if (line.empty()) return column_profile(samples, run.study, quantity);
    return line_profile(samples, run.study.probes.at(line), quantity);
  }
  [[nodiscard]] int last_stage() const { return run.study.n_stages(); }
};

std::vector<std::vector<ChartPoint>> pieces_of(Profile profile) {
  thin(profile, spots_of_a_curve);
  std::vector<std::vector<ChartPoint>> pieces;
  for (const Segment& segment : profile) {
    pieces.emplace_back();
    for (const ProfilePoint& point : segment)
      pieces.back().push_back({point.value, point.height});
  }
  return pieces;
}

void add_series(ChartSeries series, Chart& chart) {
  drop_points_that_are_not_finite(series, chart.missing);
  chart.series.push_back(std::move(series));
}

/// Solver minus the exact solution of what it solves, at the solver's own samples.
void add_error(const Place& place, const SolverRun& solver, Chart& chart) {
  const exchange::Kinematics kinematics = kinematics_solved(place.run, solver.solver);
  const std::string label = title_of(solver) + " − exact";
  const auto exact = exact_solution(place.run.study, kinematics);
  const std::string reason = exact->lacks(place.quantity);
  FieldSamples samples = place.samples(solver);
  if (!reason.empty() || samples.size() == 0) {
    chart.missing.push_back(fmt::format("{}: {}", label, reason.empty() ? "it has no such probes" : reason));
    return;
  }
  std::vector<double> values;
  const bool as_placed = place.by_points(solver);
  for (std::size_t i = 0; i < samples.size(); ++i)
    append_field(exact->at({samples.layer[i], samples.x[i], samples.height[i], as_placed}, place.last_stage()),
                 place.run.study.geometry.dimension, place.quantity, values);
  for (std::size_t c = 0; c < values.size(); ++c)
    samples.value[c] -= values[c];
  if (as_placed) use_design_heights(samples, place.run.study, kinematics);
  const CurveStyle style = style_of(solver.solver);
  add_series({.label = label,
              .colour = style.colour,
              .line = true,
              .dashed = solver.solver != "mpm",
              .pieces = pieces_of(place.profile(samples))},
             chart);
}

/// MPM minus FEM at the probes that both have.
void add_gap(const Place& place, Chart& chart) {
  const auto probes_of = [&](const std::string& name) -> FieldSamples {
    const exchange::Result* result = place.run.result_of(name);
    if (result == nullptr || result->stages.empty()) return {};
    const auto& probes = result->stages.back().probes;
    if (place.line.empty()) return probe_samples(result->stages.back(), result->used.dimension, place.quantity);
    const auto found = probes.find(place.line);
    return found != probes.end() ? line_samples(found->second, result->used.dimension, place.quantity) : FieldSamples{};
  };
  FieldSamples mpm = probes_of("mpm");
  const FieldSamples fem = probes_of("fem");
  if (mpm.size() == 0 || mpm.layer != fem.layer || mpm.value.size() != fem.value.size()) return;
  for (std::size_t c = 0; c < mpm.value.size(); ++c)
    mpm.value[c] -= fem.value[c];
  add_series({.label = "MPM − FEM, probes",
              .colour = "#000000",
              .line = true,
              .dashed = false,
              .pieces = pieces_of(place.profile(mpm))},
             chart);
}

Chart chart_of(const Place& place) {
  const Axis axis = axis_of(place.quantity);
  const bool is_tensor_or_vector = place.quantity == Quantity::displacement || place.quantity == Quantity::stress;
  Chart chart;
  chart.title = axis.title + ": differences";
  chart.x.title = fmt::format("{}: difference{}", axis.title, is_tensor_or_vector ? ", norm" : "");
  chart.x.unit = axis.unit;
  chart.keeps_y = true;
  for (const SolverRun& solver : place.run.solvers) {
    if (!solver.result || solver.result->stages.empty()) continue;
    try {
      add_error(place, solver, chart);
    } catch (const exchange::InputError& error) { // there is no exact column
      chart.missing.push_back(fmt::format("{} − exact: {}", title_of(solver), error.what()));
    }
  }
  add_gap(place, chart);
  return chart;
}

} // namespace

Chart difference_chart(const RunOutcome& run, Quantity quantity) {
  Chart chart = chart_of({run, quantity, {}});
  chart.y = {.lowest = 0.0, .highest = 1.02 * run.study.geometry.height, .title = "Height", .unit = "m"};
  return chart;
}

Chart difference_chart(const RunOutcome& run, const std::string& line, Quantity quantity) {
  Chart chart = chart_of({run, quantity, line});
  const exchange::Probes& probes = run.study.probes.at(line);
  chart.title = fmt::format("{}: differences along probes.{}", axis_of(quantity).title, line);
  chart.y = {.lowest = 0.0,
             .highest = 1.02 * exchange::length_of(probes),
             .title = fmt::format("Distance along probes.{}", line),
             .unit = "m"};
  return chart;
}

} // namespace settle::compare::report
