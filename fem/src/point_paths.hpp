/// \file
/// Single material points on the paths of a case, shape `point`.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/result.hpp"
#include "settle/fem/solver.hpp"

namespace settle::fem {

/// Drives each point through its legs, and hands over a stage for each leg. Throws NotConverged, with the leg and what
/// is left of each step tried, where stresses that are given cannot be reached.
void follow_paths(const exchange::Case& study, const StageSink& on_stage);

} // namespace settle::fem
