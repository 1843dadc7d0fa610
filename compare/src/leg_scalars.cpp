#include "leg_scalars.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "leg_side.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare {

using exchange::Quantity;

namespace {

/// Size of the force of one support.
double reaction_of(const exchange::Stage& stage, std::size_t dimension, int support) {
  double square = 0;
  for (std::size_t c = 0; c < dimension; ++c) {
    const double force = stage.support_reactions[static_cast<std::size_t>(support - 1) * dimension + c];
    square += force * force;
  }
  return std::sqrt(square);
}

double scalar_of(const exchange::Stage& stage, Quantity quantity) {
  if (quantity == Quantity::mass) return stage.mass;
  if (quantity == Quantity::base_reaction) return stage.base_reaction;
  return stage.mass / std::accumulate(stage.points.volume.begin(), stage.points.volume.end(), 0.0);
}

double scalar_of(const RunOutcome& run, const exchange::Result& result, const LegRequest& request) {
  if (request.quantity == Quantity::failure_height)
    return exchange::fill_height(run.study, result.failure->stage, result.failure->share);
  const exchange::Stage& stage = stage_of(result, request.stage);
  if (request.quantity != Quantity::support_reaction) return scalar_of(stage, request.quantity);
  return reaction_of(stage, static_cast<std::size_t>(result.used.dimension), request.support);
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
    if (request.exact) return *request.exact;
    return exact_solution(run.study, kinematics_of(run, request.value))->scalar(request.quantity, request.stage);
  case Side::table:
    return scalar_of(run.references.at(name), request.stage, request.quantity);
  case Side::solver:
    return scalar_of(run, *run.result_of(name), request);
  }
  return std::nan("");
}

/// Why a result has no such number; empty where it has.
std::string lacks(const RunOutcome& run, const std::string& name, const LegRequest& request) {
  const exchange::Result* result = run.result_of(name);
  if (result == nullptr) return {};
  if (request.quantity == Quantity::failure_height && !result->failure)
    return fmt::format("{} did not fail: it stands at its full height", name);
  const auto needed = static_cast<std::size_t>(request.support * result->used.dimension);
  if (request.quantity == Quantity::support_reaction &&
      stage_of(*result, request.stage).support_reactions.size() < needed)
    return fmt::format("{} does not say what its supports exert", name);
  return {};
}

std::string obstacle(const RunOutcome& run, const LegRequest& request) {
  const bool table = side_of(run, request.value) == Side::table || side_of(run, request.reference) == Side::table;
  if (table && request.quantity != Quantity::mass && request.quantity != Quantity::density)
    return fmt::format("a reference table has no {}", name_of(request.quantity));
  for (const std::string& name : {request.value, request.reference})
    if (std::string problem = lacks(run, name, request); !problem.empty()) return problem;
  if (side_of(run, request.reference) != Side::exact || request.exact) return {};
  return exact_solution(run.study, kinematics_of(run, request.value))->lacks(request.quantity);
}

/// The horizontal forces of all supports, in the order of the case.
LegSamples thrust_leg(const RunOutcome& run, const LegRequest& request) {
  LegSamples leg;
  const auto dim = static_cast<std::size_t>(run.study.geometry.dimension);
  const std::size_t supports = run.study.supports.size();
  for (const bool is_value : {true, false}) {
    const std::string& name = is_value ? request.value : request.reference;
    if (side_of(run, name) != Side::solver) {
      leg.problem = fmt::format("{} says nothing of the thrust of supports", name);
      return leg;
    }
    const exchange::Stage& stage = stage_of(*run.result_of(name), request.stage);
    if (stage.support_reactions.size() != dim * supports || supports == 0) {
      leg.problem = fmt::format("{} gives {} numbers for the reactions of {} supports", name,
                                stage.support_reactions.size(), supports);
      return leg;
    }
    for (std::size_t i = 0; i < supports; ++i)
      (is_value ? leg.value : leg.reference).push_back(stage.support_reactions[dim * i]);
  }
  leg.weight.assign(supports, 1.0);
  return leg;
}

} // namespace

LegSamples scalar_leg(const RunOutcome& run, const LegRequest& request) {
  if (request.quantity == Quantity::thrust) return thrust_leg(run, request);
  LegSamples leg;
  leg.problem = obstacle(run, request);
  if (!leg.problem.empty()) return leg;
  leg.value = {scalar_side(run, request.value, request)};
  leg.reference = {scalar_side(run, request.reference, request)};
  leg.weight = {1.0};
  return leg;
}

} // namespace settle::compare
