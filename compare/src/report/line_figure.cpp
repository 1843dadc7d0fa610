#include "line_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/exchange/probe_points.hpp"

namespace settle::compare::report {

namespace {

using exchange::Case;
using exchange::CheckStages;
using exchange::Quantity;

/// One segment a layer, and a new one where the line leaves a layer and comes back: where a distance is more than
/// `largest_gap` [m] from the one before it. A vector or tensor is drawn by its norm.
Profile profile_of(const FieldSamples& samples, const exchange::Probes& line, Quantity quantity, double largest_gap) {
  const std::size_t count = samples.components();
  Profile profile;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    double value = samples.value[i];
    if (count > 1) {
      value = 0.0;
      for (std::size_t c = 0; c < count; ++c)
        value = std::hypot(value, samples.value[i * count + c]);
    }
    const double distance =
        exchange::distance_from_start(line, {.x = samples.x[i], .y = samples.y[i], .design_height = samples.height[i]});
    const bool joined = i > 0 && samples.layer[i] == samples.layer[i - 1] &&
                        std::abs(distance - profile.back().back().height) <= largest_gap;
    if (!joined) profile.emplace_back();
    profile.back().push_back({axis_of(quantity).factor * value, distance});
  }
  return profile;
}

Profile exact_profile(const Case& study, const exchange::Probes& line, Quantity quantity, int stage) {
  constexpr int count = 121;
  exchange::Probes dense = line;
  dense.points = count;
  const auto exact = exact_solution(study, exchange::Kinematics::finite);
  FieldSamples samples;
  for (const exchange::ProbePoint& point : exchange::probe_points(study, dense)) {
    if (point.layer > stage) continue;
    samples.layer.push_back(point.layer);
    samples.x.push_back(point.x);
    samples.y.push_back(point.y);
    samples.height.push_back(point.design_height);
    samples.weight.push_back(1.0);
    append_field(
        exact->at({.layer = point.layer, .x = point.x, .height = point.design_height, .as_placed = false}, stage),
        study.geometry.dimension, quantity, samples.value);
  }
  return profile_of(samples, line, quantity, 1.5 * length_of(line) / (count - 1));
}

bool is_exact(const std::string& source) {
  return source == "exact" || source == "exact-fem";
}

/// Why a curve cannot be drawn, or nothing.
std::string obstacle(const Curve& curve, const RunOutcome* run, const std::string& line, Quantity quantity) {
  if (run == nullptr) return fmt::format("the campaign has no run “{}”", curve.run);
  if (!is_body(run->study)) return "the figure runs along a line of probes, and this is a column";
  if (!is_field(quantity)) return fmt::format("{} has no profile along a line", name_of(quantity));
  if (!run->study.probes.contains(line)) return fmt::format("the case has no [probes.{}]", line);
  if (is_exact(curve.source)) return exact_solution(run->study, exchange::Kinematics::finite)->lacks(quantity);
  if (curve.source == "eq-1") return "Eq. (1) is for a column";
  const exchange::Result* result = run->result_of(curve.source);
  if (result == nullptr || result->stages.empty())
    return fmt::format("the run “{}” has no result of “{}”", curve.run, curve.source);
  return result->stages.back().probes.contains(line) ? "" : fmt::format("{} has no such probes", curve.source);
}

Profile profile_at(const Curve& curve, const RunOutcome& run, const std::string& line, Quantity quantity, int stage) {
  const exchange::Probes& probes = run.study.probes.at(line);
  if (is_exact(curve.source)) return exact_profile(run.study, probes, quantity, stage);
  const exchange::Result& result = *run.result_of(curve.source);
  const exchange::Stage& state = result.stages[static_cast<std::size_t>(stage - 1)];
  const auto found = state.probes.find(line);
  if (found == state.probes.end()) return {};
  return line_profile(line_samples(found->second, result.used.dimension, quantity), probes, quantity);
}

PlotCurve drawn(const Curve& curve, const RunOutcome& run, const std::string& line, Quantity quantity) {
  PlotCurve shown{printable(curve.label), curve.run, curve.source, {}};
  const exchange::Result* solved = run.result_of(curve.source);
  const int last = solved != nullptr ? static_cast<int>(solved->stages.size()) : run.study.n_stages();
  for (int stage = curve.stages == CheckStages::all ? 1 : last; stage <= last; ++stage) {
    const Profile profile = profile_at(curve, run, line, quantity, stage);
    shown.profile.insert(shown.profile.end(), profile.begin(), profile.end());
  }
  return shown;
}

Plot line_plot(const Figure& figure, const std::string& line, const CampaignOutcome& outcome) {
  Plot plot;
  plot.id = "fig-" + slug(figure.name);
  plot.title = figure.title;
  plot.quantity = figure.quantity;
  plot.line = line;
  plot.height_title = fmt::format("Distance along probes.{} [m]", line);
  for (const Curve& curve : figure.curves) {
    const RunOutcome* run = outcome.find(curve.run);
    const std::string reason = obstacle(curve, run, line, figure.quantity);
    if (!reason.empty()) {
      plot.missing.push_back(fmt::format("{}: {}", curve.label, reason));
      continue;
    }
    plot.top = std::max(plot.top, length_of(run->study.probes.at(line)));
    plot.curves.push_back(drawn(curve, *run, line, figure.quantity));
    drop_values_that_are_not_finite(plot.curves.back(), plot.missing);
  }
  return plot;
}

Figure figure_of(const RunOutcome& run, const std::string& line, Quantity quantity) {
  Figure figure;
  figure.name = fmt::format("{} {} {}", run.name, line, name_of(quantity));
  figure.title = fmt::format("{} along probes.{}, {}, last stage", axis_of(quantity).title, line, run.name);
  figure.quantity = quantity;
  const auto add = [&](const std::string& source, const std::string& label) {
    figure.curves.push_back({run.name, source, label, CheckStages::last, {}, {}});
  };
  for (const SolverRun& solver : run.solvers) {
    if (solver.result) add(solver.solver, fmt::format("{}, probes", solver.solver));
  }
  add("exact", "exact, as the case states it");
  return figure;
}

} // namespace

bool is_body(const Case& study) {
  return study.geometry.drawn();
}

Profile line_profile(const FieldSamples& samples, const exchange::Probes& line, Quantity quantity) {
  return profile_of(samples, line, quantity, length_of(line));
}

Plot line_plot_of(const Figure& figure, const CampaignOutcome& outcome) {
  std::string line;
  for (const Curve& curve : figure.curves) {
    const RunOutcome* run = outcome.find(curve.run);
    if (line.empty() && run != nullptr && is_body(run->study) && !run->study.probes.empty())
      line = run->study.probes.begin()->first;
  }
  return line_plot(figure, line, outcome);
}

std::vector<Plot> line_plots_of(const RunOutcome& run, const CampaignOutcome& outcome) {
  std::vector<Plot> plots;
  for (const auto& [line, probes] : run.study.probes) {
    for (const Quantity quantity :
         {Quantity::displacement, Quantity::stress, Quantity::vertical_stress, Quantity::shear_stress})
      plots.push_back(line_plot(figure_of(run, line, quantity), line, outcome));
  }
  return plots;
}

} // namespace settle::compare::report
