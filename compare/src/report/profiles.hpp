/// \file
/// Profiles over the height of a column: what a solver, the exact solution, Eq. (1) or a table of reference values say.
///
/// Heights are those of the design geometry, so that one material point has one height in every profile. A profile is a
/// list of segments, one a layer: the pieces are never joined, because settlement has two values at an interface.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/field_samples.hpp"

namespace settle::compare::report {

struct ProfilePoint {
  double value = 0;  ///< in the unit of the quantity's axis
  double height = 0; ///< in the design geometry [m]
};
using Segment = std::vector<ProfilePoint>;
using Profile = std::vector<Segment>;

/// How a quantity stands along an axis: stresses are drawn in kPa, compression positive.
struct Axis {
  std::string title;
  std::string sense; ///< which direction counts as positive, where that needs saying
  std::string unit;
  double factor = 1; ///< from SI units, tension positive
};
Axis axis_of(exchange::Quantity quantity);

/// Turns the heights at which material points of a column were placed into their heights in the design geometry.
/// Throws InputError where there is no exact column.
void use_design_heights(FieldSamples& samples, const exchange::Case& study, exchange::Kinematics kinematics);

/// Samples of a column at heights in its design geometry: a segment a layer, samples at one height averaged.
Profile column_profile(const FieldSamples& samples, const exchange::Case& study, exchange::Quantity quantity);

/// Can this quantity be drawn over the height?
bool has_profile(exchange::Quantity quantity);

/// What a solver's own sample points say at the end of a stage: refilled points left out, points at one height
/// averaged.
Profile native_profile(const exchange::Case& study, const exchange::Result& result, exchange::Quantity quantity,
                       int stage);
/// The same at the probes; empty where there is none or the quantity is not sampled there.
Profile probe_profile(const exchange::Case& study, const exchange::Result& result, exchange::Quantity quantity,
                      int stage);
/// The exact solution, densely sampled.
Profile exact_profile(const exchange::Case& study, exchange::Kinematics kinematics, exchange::Quantity quantity,
                      int stage);
/// Eq. (1) with a density [kg/m3] over the whole height; settlement only.
Profile equation_1_profile(const exchange::Case& study, double density);
/// The rows of a reference table at one stage.
Profile reference_profile(const exchange::Case& study, const ReferenceTable& table, exchange::Quantity quantity,
                          int stage);

/// Keeps about `limit` points in all, evenly chosen; both ends of every segment stay.
void thin(Profile& profile, std::size_t limit);

} // namespace settle::compare::report
