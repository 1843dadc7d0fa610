/// \file
/// Legs of quantities with a value for each stage, not for each point: density, base reaction, mass, reactions of
/// supports.
#pragma once

#include "settle/compare/legs.hpp"

namespace settle::compare {

/// Density is all mass over all volume; mass and base reaction are those of the whole plan area; the thrust has a
/// sample for each support of the case.
LegSamples scalar_leg(const RunOutcome& run, const LegRequest& request);

} // namespace settle::compare
