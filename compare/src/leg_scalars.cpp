#include "leg_scalars.hpp"

#include <cmath>
#include <numeric>

#include "leg_side.hpp"
#include "settle/compare/exact_solution.hpp"

namespace settle::compare {

using exchange::Quantity;

namespace {

double scalar_of(const exchange::Stage& stage, Quantity quantity) {
  if (quantity == Quantity::mass) return stage.mass;
  if (quantity == Quantity::base_reaction) return stage.base_reaction;
  return stage.mass / std::accumulate(stage.points.volume.begin(), stage.points.volume.end(), 0.0);
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
  case Side::exact:
    return exact_solution(run.study, kinematics_of(run, request.value))->scalar(request.quantity, request.stage);
  case Side::table:
    return scalar_of(run.references.at(name), request.stage, request.quantity);
  case Side::solver:
    return scalar_of(stage_of(*run.result_of(name), request.stage), request.quantity);
  }
  return std::nan("");
}

std::string obstacle(const RunOutcome& run, const LegRequest& request) {
  const bool table = side_of(run, request.value) == Side::table || side_of(run, request.reference) == Side::table;
  if (table && request.quantity == Quantity::base_reaction) return "a reference table has no base reaction";
  if (side_of(run, request.reference) != Side::exact) return {};
  return exact_solution(run.study, kinematics_of(run, request.value))->lacks(request.quantity);
}

} // namespace

LegSamples scalar_leg(const RunOutcome& run, const LegRequest& request) {
  LegSamples leg;
  leg.problem = obstacle(run, request);
  if (!leg.problem.empty()) return leg;
  leg.value = {scalar_side(run, request.value, request)};
  leg.reference = {scalar_side(run, request.reference, request)};
  leg.weight = {1.0};
  return leg;
}

} // namespace settle::compare
