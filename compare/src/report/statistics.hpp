/// \file
/// The single numbers by which a run is known: largest settlement, largest stress, mean density, reaction, refill.
#pragma once

#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

/// How a statistic is written: its name, its unit, and the factor from SI units.
struct StatisticForm {
  std::string title;
  std::string unit;
  double factor = 1;
};
StatisticForm form_of(Statistic statistic);
/// A value of the statistic in its unit; a count without decimals.
std::string value_text(Statistic statistic, double value, int significant = 4);
/// How far a value is from a reference: in percent, for counts as a number.
std::string difference_text(Statistic statistic, double value, double reference);

/// What a solver's result says at its last stage [SI, stresses compression positive]; NaN where there is no result, or
/// a source that has no such number (FEM refills nothing). Settlement and stress: the largest over the solver's own
/// points that were not refilled, and for solvers other than MPM over its probes too.
double measured(const RunOutcome& run, const std::string& source, Statistic statistic);

/// The same of the exact solution of what the solver solves; NaN for refilled points, which have no exact number, and
/// where the exact column does not exist.
double exact_value(const RunOutcome& run, const std::string& source, Statistic statistic);

/// Area on which the column stands: width times depth, per metre out of plane in 2-D [m2/m or m2].
double plan_area(const exchange::Case& study);

/// The kinematics of what a solver of this run solves: as its result states, else as the case says.
exchange::Kinematics kinematics_of(const RunOutcome& run, const std::string& source);

} // namespace settle::compare::report
