/// \file
/// Legs of two solvers at the same material points all over a body.
#pragma once

#include "settle/compare/legs.hpp"

namespace settle::compare {

/// Both solvers at the native points of one of them, refilled ones left out, where the other's field is interpolated
/// (field_interpolation.hpp) in the same layer, by the position as placed; weighted by the volume of the points.
/// Elements are interpolated rather than points, and of two alike the one with more points. A point without a partner
/// is a problem: what lies nowhere near the other's material has not been compared.
LegSamples field_leg(const RunOutcome& run, const LegRequest& request);

} // namespace settle::compare
