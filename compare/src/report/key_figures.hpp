/// \file
/// The single numbers of a campaign, one by one, for tables that machines read.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/outcome.hpp"
#include "settle/compare/statistics.hpp"

namespace settle::compare::report {

struct KeyFigure {
  std::string run;
  std::string source; ///< a solver, or the name of a reference table
  Statistic statistic = Statistic::max_settlement;
  double value = 0; ///< SI
  double exact = 0; ///< of what the source solves, SI; NaN where it is not known
};

/// The figures of every solver with a result and of every reference table, at the last stage; without those that are
/// not finite.
std::vector<KeyFigure> key_figures_of(const CampaignOutcome& outcome);

/// "m", "Pa", "kg/m3"; empty for a count.
std::string si_unit(Statistic statistic);

/// (value - exact) / |exact|; NaN where there is none.
double relative_difference(const KeyFigure& figure);

} // namespace settle::compare::report
