#include "settle/compare/legs.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "leg_fields.hpp"
#include "leg_region.hpp"
#include "leg_scalars.hpp"
#include "leg_side.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/compare/field_samples.hpp"

namespace settle::compare {

using exchange::Over;
using exchange::Quantity;
using exchange::Result;

namespace {

LegSamples nothing(std::string problem) {
  LegSamples samples;
  samples.problem = std::move(problem);
  return samples;
}

FieldSamples samples_of(const RunOutcome& run, const std::string& name, const LegRequest& request, Over over) {
  if (side_of(run, name) == Side::table) return table_samples(run.references.at(name), request.stage, request.quantity);
  const Result& result = *run.result_of(name);
  const exchange::Stage& stage = stage_of(result, request.stage);
  return over == Over::probes ? probe_samples(stage, result.used.dimension, request.quantity)
                              : point_samples(stage, result.used.dimension, request.quantity);
}

/// Appends a sample's components.
void append(const FieldSamples& samples, std::size_t i, std::vector<double>& values) {
  const auto first = samples.value.begin() + static_cast<std::ptrdiff_t>(i * samples.components());
  values.insert(values.end(), first, first + static_cast<std::ptrdiff_t>(samples.components()));
}

LegSamples against_exact(const RunOutcome& run, const LegRequest& request, Over over) {
  const auto exact = exact_solution(run.study, kinematics_of(run, request.value));
  if (std::string problem = exact->lacks(request.quantity); !problem.empty()) return nothing(std::move(problem));
  const FieldSamples samples = samples_of(run, request.value, request, over);
  const std::set<int> present = run.study.layers_present(request.stage);
  const LegRegion region(run, request);
  LegSamples leg;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int layer = samples.layer[i];
    if (!present.contains(layer)) {
      return nothing(fmt::format("{} has a point in layer {} at stage {}", request.value, layer, request.stage));
    }
    if (!region.holds(samples, i)) continue;
    const MaterialPoint point{
        .layer = layer, .x = samples.x[i], .height = samples.height[i], .as_placed = over != Over::probes};
    append(samples, i, leg.value);
    append_field(exact->at(point, request.stage), run.study.geometry.dimension, request.quantity, leg.reference);
    leg.weight.push_back(samples.weight[i]);
  }
  return leg;
}

/// A solver beside itself: its values are their own reference.
LegSamples against_itself(const RunOutcome& run, const LegRequest& request, Over over) {
  const FieldSamples samples = samples_of(run, request.value, request, over);
  const LegRegion region(run, request);
  LegSamples leg;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!region.holds(samples, i)) continue;
    append(samples, i, leg.value);
    leg.weight.push_back(samples.weight[i]);
  }
  leg.reference = leg.value;
  return leg;
}

/// Points of two sides that lie in the same layer at the same placed height, both averaged over points at one height.
/// Weighted by the volume of the value's points.
LegSamples matched_by_height(const RunOutcome& run, const LegRequest& request) {
  const double tolerance = 1e-4 * run.study.layer_thickness(); // tables print 8 digits; rows lie 1e-3 t apart or more
  const auto rows = [&](const std::string& name) {
    return averaged_by_height(samples_of(run, name, request, Over::points), tolerance);
  };
  const FieldSamples values = rows(request.value);
  const FieldSamples references = rows(request.reference);
  const LegRegion region(run, request);
  const auto wanted = [&](const FieldSamples& row, std::size_t k) { return region.holds(row, k); };
  LegSamples leg;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < values.size() || j < references.size()) {
    const bool both = i < values.size() && j < references.size();
    const int layers = both ? values.layer[i] - references.layer[j] : (i < values.size() ? -1 : 1);
    const double gap = both ? values.height[i] - references.height[j] : 0.0;
    if (both && layers == 0 && std::abs(gap) <= tolerance) {
      if (wanted(values, i)) {
        append(values, i, leg.value);
        append(references, j, leg.reference);
        leg.weight.push_back(values.weight[i]);
      }
      ++i, ++j;
    } else if (layers < 0 || (layers == 0 && gap < 0.0)) {
      leg.without_partner += wanted(values, i++) ? 1U : 0U;
    } else {
      leg.without_partner += wanted(references, j++) ? 1U : 0U;
    }
  }
  if (leg.size() == 0) {
    leg.problem = fmt::format("no point of {} was placed at the height of a point of {} ({} without a partner)",
                              request.value, request.reference, leg.without_partner);
  }
  return leg;
}

/// The probes of two solvers are the same material points in the same order, or they cannot be compared.
LegSamples matched_probes(const RunOutcome& run, const LegRequest& request) {
  const FieldSamples values = samples_of(run, request.value, request, Over::probes);
  const FieldSamples references = samples_of(run, request.reference, request, Over::probes);
  if (values.size() != references.size()) {
    return nothing(fmt::format("{} has {} probes at stage {}, {} has {}", request.value, values.size(), request.stage,
                               request.reference, references.size()));
  }
  const double tolerance = 1e-9 * (run.study.geometry.width + run.study.geometry.height);
  const LegRegion region(run, request);
  LegSamples leg;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double gap = std::hypot(values.x[i] - references.x[i], values.y[i] - references.y[i],
                                  values.height[i] - references.height[i]);
    if (values.layer[i] != references.layer[i] || !(gap <= tolerance)) {
      return nothing(fmt::format("probe {} is not the same material point for {} and {}", i + 1, request.value,
                                 request.reference));
    }
    if (!region.holds(values, i)) continue;
    append(values, i, leg.value);
    append(references, i, leg.reference);
    leg.weight.push_back(1.0);
  }
  return leg;
}

/// Why points of the two sides cannot be told to be the same; empty where their heights tell it.
std::string obstacle_to_matching(const RunOutcome& run, const LegRequest& request) {
  if (run.study.geometry.drawn()) {
    return "points of two sides are matched by their height, which means something in a column only: compare them "
           "over probes or fields";
  }
  const bool with_table = side_of(run, request.reference) == Side::table || side_of(run, request.value) == Side::table;
  const bool known = request.quantity == Quantity::settlement || request.quantity == Quantity::vertical_stress ||
                     request.quantity == Quantity::lateral_stress;
  if (!with_table || known) return {};
  return fmt::format("a reference table has no {}", name_of(request.quantity));
}

/// Why a case has no such place to compare; empty where it has.
std::string obstacle_to_region(const RunOutcome& run, const LegRequest& request, Over over) {
  if (over != Over::fields && request.region == exchange::Region::whole) return {};
  if (!run.study.geometry.drawn())
    return "a column is the same all over its width: compare it over points or probes, without a region";
  const bool two_solvers =
      side_of(run, request.value) == Side::solver && side_of(run, request.reference) == Side::solver;
  if (over == Over::fields && !two_solvers) return "fields are compared between two solvers";
  return {};
}

} // namespace

std::pair<std::string, std::string> value_and_reference(const RunOutcome& run,
                                                        const std::vector<std::string>& between) {
  const std::string& first = between.at(0);
  const std::string& second = between.at(1);
  if (side_of(run, first) < side_of(run, second)) return {second, first};
  return {first, second};
}

Over place_of(const RunOutcome& run, const LegRequest& request) {
  if (request.over != Over::automatic) return request.over;
  const bool two_solvers =
      side_of(run, request.value) == Side::solver && side_of(run, request.reference) == Side::solver;
  return two_solvers ? Over::probes : Over::points;
}

LegSamples leg_samples(const RunOutcome& run, const LegRequest& request) {
  if (request.value == "exact") return nothing("the exact solution cannot be compared with itself");
  for (const std::string& name : {request.value, request.reference}) {
    const int stage = request.quantity == Quantity::failure_height ? 0 : request.stage;
    if (std::string problem = absence_of(run, name, stage); !problem.empty()) return nothing(std::move(problem));
  }
  if (!is_field(request.quantity)) return scalar_leg(run, request);
  const Over over = place_of(run, request);
  const bool with_exact = side_of(run, request.reference) == Side::exact;
  if (std::string obstacle = obstacle_to_region(run, request, over); !obstacle.empty())
    return nothing(std::move(obstacle));
  if (over == Over::fields) return field_leg(run, request);
  if (over == Over::probes && request.quantity == Quantity::plastic_strain)
    return nothing("probes carry no plastic strain: compare it over points or fields");
  if (request.value == request.reference) return against_itself(run, request, over);
  if (!with_exact || side_of(run, request.value) == Side::table) {
    std::string obstacle = over == Over::points ? obstacle_to_matching(run, request) : std::string();
    if (!obstacle.empty()) return nothing(std::move(obstacle));
  }
  if (with_exact) return against_exact(run, request, over);
  if (over == Over::points) return matched_by_height(run, request);
  if (side_of(run, request.reference) == Side::table) return nothing("a reference table has no probes");
  return matched_probes(run, request);
}

} // namespace settle::compare
