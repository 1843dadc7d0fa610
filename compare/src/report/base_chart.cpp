#include "base_chart.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "curve_styles.hpp"
#include "format.hpp"
#include "free_surface.hpp"
#include "html_parts.hpp"
#include "leg_region.hpp"
#include "line_figure.hpp"
#include "settle/compare/exact_solution.hpp"

namespace settle::compare::report {

namespace {

using exchange::Quantity;

/// Weighted sums over a stretch.
struct Stretch {
  double weight = 0, x = 0, value = 0;
};

/// Samples near the base, weighted means over stretches of some length, from left to right; where nothing lies for two
/// of them a new piece begins.
std::vector<std::vector<ChartPoint>> means_along(const std::vector<BoundaryPart>& base, const FieldSamples& samples,
                                                 double length) {
  std::map<long, Stretch> stretches;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!(distance(base, {samples.x[i], samples.height[i]}) <= length)) continue;
    Stretch& stretch = stretches[std::lround(std::floor(samples.x[i] / length))];
    stretch.weight += samples.weight[i];
    stretch.x += samples.weight[i] * samples.x[i];
    stretch.value += samples.weight[i] * samples.value[i];
  }
  constexpr double to_plot = -1e-3; // kPa, compression positive
  std::vector<std::vector<ChartPoint>> pieces;
  for (auto at = stretches.begin(); at != stretches.end(); ++at) {
    if (at == stretches.begin() || at->first > std::prev(at)->first + 2) pieces.emplace_back();
    const Stretch& stretch = at->second;
    pieces.back().push_back({stretch.x / stretch.weight, to_plot * stretch.value / stretch.weight});
  }
  return pieces;
}

void add(const std::string& label, const std::string& source, std::vector<std::vector<ChartPoint>> pieces,
         Chart& chart) {
  if (pieces.empty()) return;
  const CurveStyle style = style_of(source);
  ChartSeries series{
      .label = label, .colour = style.colour, .line = true, .dashed = source == "fem", .pieces = std::move(pieces)};
  drop_points_that_are_not_finite(series, chart.missing);
  chart.series.push_back(std::move(series));
}

/// The exact stress where a solver has samples.
FieldSamples exact_at(const RunOutcome& run, FieldSamples samples) {
  const auto exact = exact_solution(run.study, exchange::Kinematics::finite);
  samples.value.clear();
  if (!exact->lacks(Quantity::vertical_stress).empty()) return {};
  const int stage = run.study.n_stages();
  for (std::size_t i = 0; i < samples.size(); ++i)
    append_field(exact->at({.layer = samples.layer[i], .x = samples.x[i], .height = samples.height[i]}, stage),
                 run.study.geometry.dimension, Quantity::vertical_stress, samples.value);
  return samples;
}

} // namespace

Chart base_chart(const RunOutcome& run) {
  Chart chart;
  if (!is_body(run.study)) return chart;
  const std::vector<BoundaryPart> parts = base(run.study);
  chart.title = "Vertical stress along the base";
  chart.x = {.title = "x", .unit = "m"};
  chart.y = {.title = "Vertical stress, compression positive", .unit = "kPa"};
  for (const SolverRun& solver : run.solvers) {
    if (parts.empty() || !solver.result || solver.result->stages.empty()) continue;
    const FieldSamples samples =
        point_samples(solver.result->stages.back(), run.study.geometry.dimension, Quantity::vertical_stress);
    const double length = 0.5 * element_size_of(run, solver.solver);
    add(title_of(solver), solver.solver, means_along(parts, samples, length), chart);
    if (&solver == &run.solvers.front())
      add("exact", "exact", means_along(parts, exact_at(run, samples), length), chart);
    chart.caption += fmt::format("Base reaction of {}: {} kN/m. ", title_of(solver),
                                 number(1e-3 * solver.result->stages.back().base_reaction, 5));
  }
  chart.caption += "Means over stretches of half an element, of the points nearer to the base than that.";
  return chart;
}

} // namespace settle::compare::report
