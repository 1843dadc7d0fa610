#include "key_figures.hpp"

#include <cmath>

namespace settle::compare::report {

std::vector<KeyFigure> key_figures_of(const CampaignOutcome& outcome) {
  std::vector<KeyFigure> figures;
  const auto add = [&](const RunOutcome& run, const std::string& source) {
    for (const Statistic statistic :
         {Statistic::max_settlement, Statistic::max_vertical_stress, Statistic::mean_density,
          Statistic::base_reaction_stress, Statistic::refilled_points}) {
      const double value = measured(run, source, statistic);
      if (std::isfinite(value))
        figures.push_back({run.name, source, statistic, value, exact_value(run, source, statistic)});
    }
  };
  for (const RunOutcome& run : outcome.runs) {
    for (const SolverRun& solver : run.solvers)
      add(run, solver.solver);
    for (const auto& [name, table] : run.references)
      add(run, name);
  }
  return figures;
}

std::string si_unit(Statistic statistic) {
  switch (statistic) {
  case Statistic::max_settlement:
    return "m";
  case Statistic::max_vertical_stress:
  case Statistic::base_reaction_stress:
    return "Pa";
  case Statistic::mean_density:
    return "kg/m3";
  case Statistic::refilled_points:
    return "";
  }
  return "";
}

double relative_difference(const KeyFigure& figure) {
  return (figure.value - figure.exact) / std::abs(figure.exact);
}

} // namespace settle::compare::report
