#include "figure_data.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "format.hpp"
#include "line_figure.hpp"
#include "settle/compare/statistics.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::report {

namespace {

using exchange::CheckStages;
using exchange::Kinematics;
using exchange::Quantity;
using exchange::Result;

// Markers of a curve, whatever its number of points: for one stage, and for each layer where all stages are shown.
constexpr std::size_t marker_limit = 70;
constexpr std::size_t marker_limit_of_layer = 9;

constexpr std::string_view exact_of = "exact-"; // and the solver whose model is meant

/// "exact" alone is of what MPM solves.
Kinematics kinematics_of_exact(const RunOutcome& run, const std::string& source) {
  return source == "exact" ? Kinematics::finite : kinematics_solved(run, source.substr(exact_of.size()));
}

/// "MPM, material points"; of others their probes, where they have some.
std::string label_of(const RunOutcome& run, const SolverRun& solver) {
  const bool probes = solver.solver != "mpm" && !run.study.probes.empty();
  return title_of(solver) + (solver.solver == "mpm" ? ", material points" : probes ? ", probes" : "");
}

/// The profile of a curve at one of the stages 1 ... N.
Profile profile_at(const Curve& curve, const RunOutcome& run, Quantity quantity, int stage) {
  if (curve.source == "exact") return exact_profile(run.study, Kinematics::finite, quantity, stage);
  if (is_exact(curve.source)) return exact_profile(run.study, kinematics_of_exact(run, curve.source), quantity, stage);
  if (const auto reference = run.references.find(curve.source); reference != run.references.end()) {
    return reference_profile(run.study, reference->second, quantity, stage);
  }
  const Result& result = *run.result_of(curve.source);
  if (curve.source == "mpm") return native_profile(run.study, result, quantity, stage);
  const Profile probes = probe_profile(run.study, result, quantity, stage);
  return probes.empty() ? native_profile(run.study, result, quantity, stage) : probes;
}

/// The density that a curve of Eq. (1) takes; NaN where the run it is to be read from has no result.
double density_of(const Curve& curve, const RunOutcome& run, const CampaignOutcome& outcome) {
  if (curve.density) return *curve.density;
  if (curve.density_of.empty()) return run.study.fill().density;
  const RunOutcome* source = outcome.find(curve.density_of);
  return source == nullptr ? std::numeric_limits<double>::quiet_NaN()
                           : measured(*source, "mpm", Statistic::mean_density);
}

bool is_marker_source(const RunOutcome& run, const std::string& source) {
  return !is_exact(source) && source != "eq-1" &&
         (run.references.count(source) != 0 || run.result_of(source) != nullptr);
}

/// Why a curve cannot be drawn, or nothing.
std::string obstacle(const Curve& curve, const RunOutcome* run, Quantity quantity, const CampaignOutcome& outcome) {
  if (!has_profile(quantity)) return fmt::format("{} has no profile over the height", name_of(quantity));
  if (run == nullptr) return fmt::format("the campaign has no run “{}”", curve.run);
  if (is_exact(curve.source)) return "";
  if (curve.source == "eq-1") {
    if (quantity != Quantity::settlement) return "Eq. (1) gives the settlement only";
    return std::isfinite(density_of(curve, *run, outcome))
               ? ""
               : fmt::format("the run “{}” has no MPM result to take the mean density from", curve.density_of);
  }
  if (is_marker_source(*run, curve.source)) return "";
  return fmt::format("the run “{}” has no result of “{}”", curve.run, curve.source);
}

/// "after stage k" at the upper end of the stage's profile, unless the place is taken by another curve's label.
void label_stage(Plot& plot, const Profile& profile, int stage) {
  if (profile.empty() || profile.back().empty()) return;
  const ProfilePoint end = profile.back().back();
  for (const StageLabel& label : plot.stage_labels) {
    if (std::abs(label.at.height - end.height) < 0.04 * plot.top) return;
  }
  plot.stage_labels.push_back({fmt::format("stage {}", stage), end});
}

void append(Profile& profile, const Profile& more) {
  profile.insert(profile.end(), more.begin(), more.end());
}

PlotCurve drawn(const Curve& curve, const RunOutcome& run, const CampaignOutcome& outcome, Plot& plot) {
  PlotCurve result{printable(curve.label), curve.run, curve.source, {}};
  if (curve.source == "eq-1") {
    result.profile = equation_1_profile(run.study, density_of(curve, run, outcome));
    return result;
  }
  const Result* solved = run.result_of(curve.source);
  const int last = solved != nullptr ? static_cast<int>(solved->stages.size()) : run.study.n_stages();
  for (int stage = curve.stages == CheckStages::all ? 1 : last; stage <= last; ++stage) {
    const Profile profile = profile_at(curve, run, plot.quantity, stage);
    if (curve.stages == CheckStages::all) label_stage(plot, profile, stage);
    append(result.profile, profile);
  }
  if (is_marker_source(run, curve.source)) {
    const bool all = curve.stages == CheckStages::all;
    thin(result.profile, all ? marker_limit_of_layer * result.profile.size() : marker_limit);
  }
  return result;
}

/// The first solver of a run with these kinematics, or nullptr.
const SolverRun* first_that_solves(const RunOutcome& run, Kinematics kinematics) {
  const auto found = std::find_if(run.solvers.begin(), run.solvers.end(), [&](const SolverRun& solver) {
    return kinematics_solved(run, solver.solver) == kinematics;
  });
  return found != run.solvers.end() ? &*found : nullptr;
}

/// The levels between layers, if all runs of the plot agree on them and they are few enough to be read.
std::vector<double> common_interfaces(const Plot& plot, const CampaignOutcome& outcome) {
  std::set<int> numbers;
  for (const PlotCurve& curve : plot.curves)
    numbers.insert(outcome.find(curve.run)->study.n_stages());
  std::vector<double> levels;
  if (numbers.size() != 1 || *numbers.begin() > 20) return levels;
  for (int k = 1; k < *numbers.begin(); ++k)
    levels.push_back(plot.top * k / *numbers.begin());
  return levels;
}

} // namespace

void drop_values_that_are_not_finite(PlotCurve& curve, std::vector<std::string>& missing) {
  std::size_t dropped = 0;
  for (Segment& segment : curve.profile) {
    const auto bad = std::remove_if(segment.begin(), segment.end(), [](const ProfilePoint& point) {
      return !std::isfinite(point.value) || !std::isfinite(point.height);
    });
    dropped += static_cast<std::size_t>(segment.end() - bad);
    segment.erase(bad, segment.end());
  }
  if (dropped > 0) missing.push_back(fmt::format("{}: {} points have no value and are left out", curve.label, dropped));
}

bool is_exact(const std::string& source) {
  return source == "exact" || source.starts_with(exact_of);
}

Plot plot_of(const Figure& figure, const CampaignOutcome& outcome) {
  const bool of_a_body = std::any_of(figure.curves.begin(), figure.curves.end(), [&](const Curve& curve) {
    const RunOutcome* run = outcome.find(curve.run);
    return run != nullptr && is_body(run->study);
  });
  if (of_a_body) return line_plot_of(figure, outcome);
  Plot plot{"fig-" + slug(figure.name), figure.title, figure.quantity, 0.0, {}, {}, {}, {}, {}};
  for (const Curve& curve : figure.curves) {
    if (const RunOutcome* run = outcome.find(curve.run)) plot.top = std::max(plot.top, run->study.geometry.height);
  }
  for (const Curve& curve : figure.curves) {
    const RunOutcome* run = outcome.find(curve.run);
    const std::string reason = obstacle(curve, run, figure.quantity, outcome);
    if (!reason.empty()) {
      plot.missing.push_back(fmt::format("{}: {}", curve.label, reason));
      continue;
    }
    try {
      PlotCurve shown = drawn(curve, *run, outcome, plot);
      drop_values_that_are_not_finite(shown, plot.missing);
      plot.curves.push_back(std::move(shown));
    } catch (const exchange::InputError& error) { // there is no exact column
      plot.missing.push_back(fmt::format("{}: {}", curve.label, error.what()));
    }
  }
  plot.interfaces = common_interfaces(plot, outcome);
  return plot;
}

Plot plot_of(const RunOutcome& run, Quantity quantity, const CampaignOutcome& outcome) {
  Figure figure;
  figure.name = fmt::format("{} {}", run.name, name_of(quantity));
  figure.title = fmt::format("{}, {}, last stage", axis_of(quantity).title, run.name);
  figure.quantity = quantity;
  const auto add = [&](const std::string& source, const std::string& label) {
    figure.curves.push_back({run.name, source, label, CheckStages::last, {}, {}});
  };
  for (const SolverRun& solver : run.solvers) {
    if (solver.result) add(solver.solver, label_of(run, solver));
  }
  for (const auto& [name, table] : run.references)
    add(name, table.title.empty() ? name : table.title);
  // All solutions of a model are the same: one curve for the first of those who solve it. Tables are of finite strain.
  const SolverRun* finite = first_that_solves(run, Kinematics::finite);
  const SolverRun* small = first_that_solves(run, Kinematics::small);
  if (finite != nullptr) add("exact", fmt::format("exact, finite strain (what {} solves)", title_of(*finite)));
  if (finite == nullptr && !run.references.empty()) add("exact", "exact, finite strain");
  if (small != nullptr)
    add("exact-" + small->solver, fmt::format("exact, small strain (what {} solves)", title_of(*small)));
  return plot_of(figure, outcome);
}

} // namespace settle::compare::report
