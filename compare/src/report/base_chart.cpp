#include "base_chart.hpp"

#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "boundary_band.hpp"
#include "curve_styles.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "leg_region.hpp"
#include "line_figure.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::compare::report {

namespace {

using exchange::Quantity;

/// Weighted sums over a stretch.
struct Stretch {
  double weight = 0, x = 0, value = 0;
};

/// Of a body that varies along y, what is charted: its middle. A section is the same all along y.
std::optional<double> charted_y(const exchange::Geometry& geometry) {
  if (!geometry.varies_along_y()) return {};
  return exchange::middle_of_depth(geometry);
}

/// Samples near the base, no further than a length, weighted means over stretches of that length, from left to right;
/// where nothing lies for two of them a new piece begins.
std::vector<std::vector<ChartPoint>> means_along(const exchange::Case& study, const FieldSamples& samples,
                                                 double length) {
  const BoundaryBand base = BoundaryBand::along_base(study, length);
  const std::optional<double> middle = charted_y(study.geometry);
  std::map<long, Stretch> stretches;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (middle && !(std::abs(samples.y[i] - *middle) <= length)) continue;
    if (!base.holds({samples.x[i], samples.y[i], samples.height[i]})) continue;
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
  const std::optional<double> middle = charted_y(run.study.geometry);
  chart.title = "Vertical stress along the base";
  if (middle) chart.title += fmt::format(", in the middle (y = {} m)", number(*middle, 3));
  chart.x = {.title = "x", .unit = "m"};
  chart.y = {.title = "Vertical stress, compression positive", .unit = "kPa"};
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result || solver.result->stages.empty()) continue;
    const FieldSamples samples =
        point_samples(solver.result->stages.back(), run.study.geometry.dimension, Quantity::vertical_stress);
    const double length = 0.5 * element_size_of(run, solver.solver);
    add(title_of(solver), solver.solver, means_along(run.study, samples, length), chart);
    if (&solver == &run.solvers.front())
      add("exact", "exact", means_along(run.study, exact_at(run, samples), length), chart);
    chart.caption += fmt::format("Base reaction of {}: {} {}. ", title_of(solver),
                                 number(1e-3 * solver.result->stages.back().base_reaction, 5),
                                 run.study.geometry.dimension == 2 ? "kN/m" : "kN");
  }
  chart.caption += "Means over stretches of half an element, of the points nearer to the base than that";
  chart.caption += middle ? ", and to the middle." : ".";
  return chart;
}

} // namespace settle::compare::report
