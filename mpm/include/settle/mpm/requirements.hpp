/// \file
/// What this version of the material point method can run.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::mpm {

/// Throws exchange::InputError where the case's geometry, material law or `[mpm]` table ask for what this solver cannot
/// do.
void require_solvable(const exchange::Case& study);

} // namespace settle::mpm
