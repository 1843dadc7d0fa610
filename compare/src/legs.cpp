#include "settle/compare/legs.hpp"

#include <cmath>

#include <fmt/format.h>

#include "leg_scalars.hpp"
#include "leg_side.hpp"
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

bool wanted(const LegRequest& request, int layer) {
  return request.layers.empty() || (request.layers.front() <= layer && layer <= request.layers.back());
}

FieldSamples samples_of(const RunOutcome& run, const std::string& name, const LegRequest& request, Over over) {
  if (side_of(run, name) == Side::table) return table_samples(run.references.at(name), request.stage, request.quantity);
  const Result& result = *run.result_of(name);
  const exchange::Stage& stage = stage_of(result, request.stage);
  return over == Over::probes ? probe_samples(stage, result.used.dimension, request.quantity)
                              : point_samples(stage, result.used.dimension, request.quantity);
}

LegSamples against_exact(const RunOutcome& run, const LegRequest& request, Over over) {
  const FieldSamples samples = samples_of(run, request.value, request, over);
  const ExactColumn column(run.study, kinematics_of(run, request.value));
  const double thickness = run.study.layer_thickness();
  LegSamples leg;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int layer = samples.layer[i];
    if (layer < 1 || layer > request.stage) {
      return nothing(fmt::format("{} has a point in layer {} at stage {}", request.value, layer, request.stage));
    }
    if (!wanted(request, layer)) continue;
    const double xi = over == Over::probes ? samples.height[i] / thickness - (layer - 1)
                                           : column.relative_height(layer, samples.height[i]);
    leg.value.push_back(samples.value[i]);
    leg.reference.push_back(value_of(column.at(layer, xi, request.stage), request.quantity));
    leg.weight.push_back(samples.weight[i]);
  }
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
  LegSamples leg;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < values.size() || j < references.size()) {
    const bool both = i < values.size() && j < references.size();
    const int layers = both ? values.layer[i] - references.layer[j] : (i < values.size() ? -1 : 1);
    const double gap = both ? values.height[i] - references.height[j] : 0.0;
    if (both && layers == 0 && std::abs(gap) <= tolerance) {
      if (wanted(request, values.layer[i])) {
        leg.value.push_back(values.value[i]);
        leg.reference.push_back(references.value[j]);
        leg.weight.push_back(values.weight[i]);
      }
      ++i, ++j;
    } else if (layers < 0 || (layers == 0 && gap < 0.0)) {
      leg.without_partner += wanted(request, values.layer[i++]) ? 1U : 0U;
    } else {
      leg.without_partner += wanted(request, references.layer[j++]) ? 1U : 0U;
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
  const double tolerance = 1e-9 * run.study.geometry.height;
  LegSamples leg;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double gap = std::abs(values.height[i] - references.height[i]);
    if (values.layer[i] != references.layer[i] || !(gap <= tolerance)) {
      return nothing(fmt::format("probe {} is not the same material point for {} and {}", i + 1, request.value,
                                 request.reference));
    }
    if (!wanted(request, values.layer[i])) continue;
    leg.value.push_back(values.value[i]);
    leg.reference.push_back(references.value[i]);
    leg.weight.push_back(1.0);
  }
  return leg;
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
    if (std::string problem = absence_of(run, name, request.stage); !problem.empty())
      return nothing(std::move(problem));
  }
  if (!is_field(request.quantity)) return scalar_leg(run, request);
  const Over over = place_of(run, request);
  if (side_of(run, request.reference) == Side::exact) return against_exact(run, request, over);
  if (over == Over::points) return matched_by_height(run, request);
  if (side_of(run, request.reference) == Side::table) return nothing("a reference table has no probes");
  return matched_probes(run, request);
}

std::vector<DifferenceSplit> difference_splits(const RunOutcome& run) {
  std::vector<DifferenceSplit> splits;
  for (const Quantity quantity : {Quantity::settlement, Quantity::vertical_stress}) {
    LegRequest request{.value = "mpm", .reference = "exact", .quantity = quantity, .over = Over::probes};
    request.stage = run.study.construction.layers;
    const LegSamples mpm = leg_samples(run, request);
    request.value = "fem";
    const LegSamples fem = leg_samples(run, request);
    request.value = "mpm";
    request.reference = "fem";
    const LegSamples total = leg_samples(run, request);
    const LegSamples model{.value = mpm.reference, .reference = fem.reference, .weight = fem.weight};
    if (mpm.size() == 0 || mpm.size() != fem.size() || total.size() != mpm.size()) continue;
    const double scale = norm_of(fem.reference, fem.weight, exchange::Norm::l2);
    const auto part = [scale](const LegSamples& leg) { return relative_norm(leg, exchange::Norm::l2, scale).value; };
    splits.push_back({.quantity = quantity,
                      .total = part(total),
                      .mpm_error = part(mpm),
                      .model_difference = part(model),
                      .fem_error = part(fem)});
  }
  return splits;
}

} // namespace settle::compare
