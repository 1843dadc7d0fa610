/// \file
/// Legs of quantities with one value a stage: density, base reaction, mass.
#pragma once

#include "settle/compare/legs.hpp"

namespace settle::compare {

/// Density is all mass over all volume; mass and base reaction are those of the whole plan area.
LegSamples scalar_leg(const RunOutcome& run, const LegRequest& request);

} // namespace settle::compare
