#include "leg_fields.hpp"

#include <memory>

#include <fmt/format.h>

#include "element_points.hpp"
#include "field_interpolation.hpp"
#include "leg_region.hpp"
#include "leg_side.hpp"
#include "settle/compare/field_samples.hpp"

namespace settle::compare {

namespace {

/// A solver's field at the stage.
struct FieldSide {
  std::string name;
  FieldSamples samples;
  bool comes_in_elements;
  int dimension;
};

FieldSide field_side(const RunOutcome& run, const std::string& name, const LegRequest& request) {
  const exchange::Result& result = *run.result_of(name);
  const exchange::Stage& stage = stage_of(result, request.stage);
  return {.name = name,
          .samples = point_samples(stage, result.used.dimension, request.quantity),
          .comes_in_elements =
              result.provenance.solver == "settle-fem" && come_in_elements(stage.points, points_along_edge(run.study)),
          .dimension = result.used.dimension};
}

/// Is the second rather interpolated than the first?
bool second_is_interpolated(const FieldSide& first, const FieldSide& second) {
  if (first.comes_in_elements != second.comes_in_elements) return second.comes_in_elements;
  return second.samples.size() >= first.samples.size();
}

void append(const std::vector<double>& values, std::size_t i, std::size_t components, std::vector<double>& all) {
  for (std::size_t c = 0; c < components; ++c)
    all.push_back(values[i * components + c]);
}

/// The samples of one side that are asked for in `own`, the other side's field there in `other`.
LegSamples sampled(const FieldSamples& samples, const InterpolatedField& field, const LegRegion& region,
                   std::vector<double> LegSamples::*own, std::vector<double> LegSamples::*other) {
  LegSamples leg;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!region.holds(samples, i)) continue;
    const auto partner = field.at(samples.layer[i], {samples.x[i], samples.height[i], samples.y[i]});
    if (!partner) {
      ++leg.without_partner;
      continue;
    }
    append(samples.value, i, samples.components(), leg.*own);
    append(*partner, 0, samples.components(), leg.*other);
    leg.weight.push_back(samples.weight[i]);
  }
  return leg;
}

std::unique_ptr<InterpolatedField> field_of(const RunOutcome& run, const FieldSide& side) {
  return side.comes_in_elements ? field_of_elements(side.samples, points_along_edge(run.study))
                                : field_of_points(side.samples, side.dimension);
}

} // namespace

LegSamples field_leg(const RunOutcome& run, const LegRequest& request) {
  const FieldSide value = field_side(run, request.value, request);
  const FieldSide reference = field_side(run, request.reference, request);
  const LegRegion region(run, request);
  const bool at_value = second_is_interpolated(value, reference);
  const FieldSide& own = at_value ? value : reference;
  const FieldSide& other = at_value ? reference : value;
  LegSamples leg =
      sampled(own.samples, *field_of(run, other), region, at_value ? &LegSamples::value : &LegSamples::reference,
              at_value ? &LegSamples::reference : &LegSamples::value);
  if (leg.without_partner > 0)
    leg.problem = fmt::format("{} of {} points of {} have no partner: no material of {} in their layer is near them",
                              leg.without_partner, leg.size() + leg.without_partner, own.name, other.name);
  return leg;
}

} // namespace settle::compare
