/// \file
/// The result of a solver that makes no error: the exact column written as a result.
#pragma once

#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare::test {

/// What a perfect solver hands over: 2 points at each of 4 heights a layer, the case's probes, balanced stages.
exchange::Result perfect_result(const exchange::Case& study, exchange::Kinematics kinematics,
                                const std::string& solver);

/// A run of mpm (finite strain) and fem (small strain), both perfect.
RunOutcome perfect_run(const exchange::Case& study);

/// The solver's result, to be spoilt.
exchange::Result& result_in(RunOutcome& run, const std::string& solver);

} // namespace settle::compare::test
