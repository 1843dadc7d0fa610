/// \file
/// A whole case with the material point method: stage by stage, each handed over when it has ended.
#pragma once

#include "settle/exchange/solver_program.hpp"

namespace settle::mpm {

/// What the solver uses of the case's values; kinematics are finite.
exchange::Used used(const exchange::Case& study);

/// How many threads `solve` may use: one for single material points.
int threads(const exchange::Case& study);

/// Builds the construction layer by layer. Throws exchange::InputError (`require_solvable`, or a `drop` that has no
/// quasi-static equilibrium), exchange::NotConverged, PointLost. Returns where the body failed, if the case allows that
/// and no equilibrium was found; by the explicit scheme, with what became of the body.
std::optional<exchange::Failure> solve(const exchange::Case& study, const exchange::StageSink& sink);

} // namespace settle::mpm
