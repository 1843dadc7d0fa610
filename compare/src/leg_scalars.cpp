#include "leg_scalars.hpp"

#include <cmath>
#include <numeric>

#include "leg_side.hpp"
#include "settle/compare/exact_column.hpp"

namespace settle::compare {

using exchange::Quantity;

namespace {

double scalar_of(const exchange::Stage& stage, Quantity quantity) {
  if (quantity == Quantity::mass) return stage.mass;
  if (quantity == Quantity::base_reaction) return stage.base_reaction;
  return stage.mass / std::accumulate(stage.points.volume.begin(), stage.points.volume.end(), 0.0);
}

double scalar_of(const ExactColumn& column, const exchange::Case& study, int stage, Quantity quantity) {
  const double area = study.geometry.width * (study.geometry.dimension == 3 ? study.geometry.depth.value_or(1.0) : 1.0);
  if (quantity == Quantity::mass) return column.base_stress(stage) * area / study.gravity;
  if (quantity == Quantity::base_reaction) return column.base_stress(stage) * area;
  return column.mean_density(stage);
}

double scalar_of(const ReferenceTable& table, int stage, Quantity quantity) {
  double mass = 0.0;
  double volume = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table.stage[i] != stage) continue;
    mass += table.density[i] * table.volume[i];
    volume += table.volume[i];
  }
  return quantity == Quantity::mass ? mass : mass / volume;
}

double scalar_side(const RunOutcome& run, const std::string& name, const LegRequest& request) {
  switch (side_of(run, name)) {
  case Side::exact: {
    const ExactColumn column(run.study, kinematics_of(run, request.value));
    return scalar_of(column, run.study, request.stage, request.quantity);
  }
  case Side::table:
    return scalar_of(run.references.at(name), request.stage, request.quantity);
  case Side::solver:
    return scalar_of(stage_of(*run.result_of(name), request.stage), request.quantity);
  }
  return std::nan("");
}

} // namespace

LegSamples scalar_leg(const RunOutcome& run, const LegRequest& request) {
  const bool table = side_of(run, request.value) == Side::table || side_of(run, request.reference) == Side::table;
  if (table && request.quantity == Quantity::base_reaction) {
    LegSamples nothing;
    nothing.problem = "a reference table has no base reaction";
    return nothing;
  }
  LegSamples leg;
  leg.value = {scalar_side(run, request.value, request)};
  leg.reference = {scalar_side(run, request.reference, request)};
  leg.weight = {1.0};
  return leg;
}

} // namespace settle::compare
