/// \file
/// What the stages of a case may ask for.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::mpm {

/// Throws exchange::InputError where a stage asks for what this solver cannot do: a stress of level ground where ground
/// is not level or its stress follows from its deformation, a load beside the surface, or on a layer that is taken
/// away.
void require_stages_that_fit(const exchange::Case& study);

} // namespace settle::mpm
