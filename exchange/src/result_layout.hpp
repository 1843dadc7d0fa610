/// \file
/// The names and shapes of a result file's datasets, once, for the writer and the reader (docs/formats.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hdf5.hpp"
#include "settle/exchange/result.hpp"

namespace settle::exchange::layout {

inline constexpr const char* format = "settle-result";
inline constexpr const char* complete = "complete";

/// The group of stage 1, 2, ...
std::string stage_name(std::size_t number);

/// Calls `visit(name, columns, vector)` for every dataset; columns is 0 for one value a point.
template <class Points, class Visit>
void for_each_array(Points& points, std::size_t dimension, const Visit& visit) requires requires {
  points.refilled;
}
{
  visit("id", 0, points.id);
  visit("layer", 0, points.layer);
  visit("refilled", 0, points.refilled);
  visit("placed_position", dimension, points.placed_position);
  visit("position", dimension, points.position);
  visit("displacement", dimension, points.displacement);
  visit("stress", 6, points.stress);
  visit("density", 0, points.density);
  visit("volume", 0, points.volume);
  visit("plastic_strain", 0, points.plastic_strain);
  visit("preconsolidation_pressure", 0, points.preconsolidation_pressure);
}

template <class Samples, class Visit>
void for_each_array(Samples& samples, std::size_t dimension, const Visit& visit) requires requires {
  samples.design_position;
}
{
  visit("layer", 0, samples.layer);
  visit("design_position", dimension, samples.design_position);
  visit("placed_position", dimension, samples.placed_position);
  visit("displacement", dimension, samples.displacement);
  visit("stress", 6, samples.stress);
}

/// Calls `visit(name, value)` for every number that is an attribute of a stage.
template <class AnyStage, class Visit>
void for_each_attribute(AnyStage& stage, const Visit& visit) {
  visit("layer", stage.layer);
  visit("steps", stage.steps);
  visit("linear_solves", stage.linear_solves);
  visit("out_of_balance", stage.out_of_balance);
  visit("in_equilibrium", stage.in_equilibrium);
  visit("mass", stage.mass);
  visit("mass_placed", stage.mass_placed);
  visit("mass_refilled", stage.mass_refilled);
  visit("weight", stage.weight);
  visit("base_reaction", stage.base_reaction);
  visit("surface_height", stage.surface_height);
  visit("wall_time", stage.wall_time);
}

/// The same for a run-out.
template <class AnyRunOut, class Visit>
void for_each_attribute_of_run_out(AnyRunOut& run_out, const Visit& visit) {
  visit("at_rest", run_out.at_rest);
  visit("duration", run_out.duration);
  visit("largest_displacement", run_out.largest_displacement);
  visit("distance", run_out.distance);
  visit("mass_before", run_out.mass_before);
  visit("points_before", run_out.points_before);
  visit("external_work", run_out.external_work);
  visit("stress_work", run_out.stress_work);
  visit("damping_loss", run_out.damping_loss);
  visit("kinetic_energy", run_out.kinetic_energy);
}

inline constexpr const char* support_reactions = "support_reactions";
inline constexpr const char* failure = "failure";
inline constexpr const char* run_out = "run_out";     ///< in `failure`
inline constexpr const char* run_out_state = "state"; ///< in `run_out`

/// May a dataset be left out?
bool is_optional(std::string_view name);

/// The shape of a dataset of `rows` points.
hdf5::Sizes sizes(std::size_t rows, std::size_t columns);

} // namespace settle::exchange::layout
