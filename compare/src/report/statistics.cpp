#include "settle/compare/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "settle/compare/exact_column.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace {

using exchange::Quantity;
using exchange::Result;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// NaN where one of the samples is.
double largest(const FieldSamples& samples, double sign, double so_far) {
  for (const double value : samples.value) {
    if (!(sign * value <= so_far)) so_far = sign * value;
  }
  return so_far;
}

/// Over the points that were not refilled at the last stage, stresses compression positive.
double largest_value(const Result& result, const std::string& source, Quantity quantity) {
  const exchange::Stage& last = result.stages.back();
  const int dimension = result.used.dimension;
  const double sign = quantity == Quantity::settlement ? 1.0 : -1.0;
  constexpr double lowest = -std::numeric_limits<double>::infinity();
  const double value = largest(point_samples(last, dimension, quantity), sign, lowest);
  const bool with_probes = source != "mpm" || quantity == Quantity::settlement;
  return with_probes ? largest(probe_samples(last, dimension, quantity), sign, value) : value;
}

double total_volume(const exchange::SamplePoints& points) {
  double sum = 0.0;
  for (const double volume : points.volume)
    sum += volume;
  return sum;
}

/// Mass over volume of all rows of a stage [kg/m3].
double mean_density(const ReferenceTable& table, int stage) {
  double mass = 0.0;
  double volume = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table.stage[i] != stage) continue;
    mass += table.density[i] * table.volume[i];
    volume += table.volume[i];
  }
  return mass / volume;
}

double of_reference(const ReferenceTable& table, Statistic statistic) {
  if (table.size() == 0) return nan;
  constexpr double lowest = -std::numeric_limits<double>::infinity();
  const int last = *std::max_element(table.stage.begin(), table.stage.end());
  switch (statistic) {
  case Statistic::max_settlement:
    return largest(table_samples(table, last, Quantity::settlement), 1.0, lowest);
  case Statistic::max_vertical_stress:
    return largest(table_samples(table, last, Quantity::vertical_stress), -1.0, lowest);
  case Statistic::mean_density:
    return mean_density(table, last);
  case Statistic::base_reaction_stress:
  case Statistic::refilled_points:
    return nan;
  }
  return nan;
}

double exact_statistic(const ExactColumn& exact, int last, Statistic statistic) {
  switch (statistic) {
  case Statistic::max_settlement:
    return exact.largest_settlement(last);
  case Statistic::max_vertical_stress:
  case Statistic::base_reaction_stress:
    return exact.base_stress(last);
  case Statistic::mean_density:
    return exact.mean_density(last);
  case Statistic::refilled_points:
    return nan;
  }
  return nan;
}

} // namespace

exchange::Kinematics kinematics_solved(const RunOutcome& run, const std::string& solver) {
  if (const Result* result = run.result_of(solver)) return result->used.kinematics;
  if (solver == "fem") return run.study.fem.kinematics;
  const auto found = std::find_if(run.solvers.begin(), run.solvers.end(),
                                  [&](const SolverRun& each) { return each.solver == solver; });
  return found != run.solvers.end() ? found->kinematics.value_or(exchange::Kinematics::finite)
                                    : exchange::Kinematics::finite;
}

double plan_area(const exchange::Case& study) {
  const double depth = study.geometry.dimension == 3 ? study.geometry.depth.value_or(study.geometry.width) : 1.0;
  return study.geometry.width * depth;
}

double measured(const RunOutcome& run, const std::string& source, Statistic statistic) {
  if (const auto table = run.references.find(source); table != run.references.end()) {
    return of_reference(table->second, statistic);
  }
  const Result* result = run.result_of(source);
  if (result == nullptr || result->stages.empty()) return nan;
  const exchange::Stage& last = result->stages.back();
  switch (statistic) {
  case Statistic::max_settlement:
    return largest_value(*result, source, Quantity::settlement);
  case Statistic::max_vertical_stress:
    return largest_value(*result, source, Quantity::vertical_stress);
  case Statistic::mean_density:
    return last.mass / total_volume(last.points);
  case Statistic::base_reaction_stress:
    return last.base_reaction / plan_area(run.study);
  case Statistic::refilled_points:
    if (source == "fem") return nan;
    return static_cast<double>(std::count(last.points.refilled.begin(), last.points.refilled.end(), 1));
  }
  return nan;
}

double exact_value(const RunOutcome& run, const std::string& source, Statistic statistic) {
  if (run.study.geometry.shape != exchange::Shape::column) return nan;
  try {
    const ExactColumn exact(run.study, kinematics_solved(run, source));
    return exact_statistic(exact, run.study.n_stages(), statistic);
  } catch (const exchange::InputError&) {
    return nan; // the column does not exist: it is too soft to stand
  }
}

} // namespace settle::compare
