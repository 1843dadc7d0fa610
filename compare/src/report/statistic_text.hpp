/// \file
/// How the single numbers of a run are written.
#pragma once

#include <string>

#include "settle/compare/statistics.hpp"

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

} // namespace settle::compare::report
