/// \file
/// The single numbers by which a run is known: largest settlement, largest stress, mean density, reaction, refill.
#pragma once

#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// What a solver's result says at its last stage [SI, stresses compression positive]; NaN where there is no result, or
/// a source that has no such number (FEM refills nothing, a table has no reaction). Refilled points are left out.
/// Settlement: the largest over points and probes; stress: over points, for solvers other than MPM over probes too
/// (MPM's are extrapolated there).
double measured(const RunOutcome& run, const std::string& source, Statistic statistic);

/// The same of the exact solution of what the solver solves; NaN for refilled points, which have no exact number, and
/// where the exact column does not exist, or the case is none of a column.
double exact_value(const RunOutcome& run, const std::string& source, Statistic statistic);

/// What a solver solved, as its result states; without one, as the case or the file that joins it says.
exchange::Kinematics kinematics_solved(const RunOutcome& run, const std::string& solver);

/// Area on which the column stands: width times depth, per metre out of plane in 2-D [m2/m or m2].
double plan_area(const exchange::Case& study);

} // namespace settle::compare
