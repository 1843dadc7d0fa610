/// \file
/// A figure as data: which curves it shows, and what could not be shown.
#pragma once

#include "profiles.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

struct PlotCurve {
  std::string label;
  std::string run;
  std::string source; ///< as in the campaign file: a solver, "exact", "exact-SOLVER", "eq-1", a reference
  Profile profile;
};

/// A word beside the upper end of a curve that is one of several stages.
struct StageLabel {
  std::string text;
  ProfilePoint at;
};

struct Plot {
  std::string id; ///< unique in the page
  std::string title;
  exchange::Quantity quantity = exchange::Quantity::settlement;
  double top = 0;                 ///< upper end of the height axis [m]
  std::vector<double> interfaces; ///< between layers, where all runs have the same [m]
  std::vector<PlotCurve> curves;
  std::vector<StageLabel> stage_labels;
  std::vector<std::string> missing; ///< a sentence for each curve that could not be drawn
  std::string line;                 ///< of probes along which a body is drawn; empty: over the height of a column
  std::string height_title = "Height in the design geometry [m]"; ///< of the axis that `ProfilePoint::height` is along
};

/// Takes values that cannot be drawn out of a curve, and says so.
void drop_values_that_are_not_finite(PlotCurve& curve, std::vector<std::string>& missing);
/// "exact", of what MPM solves, or "exact-SOLVER", of what that one solves.
bool is_exact(const std::string& source);

/// The curves of a figure of the campaign.
Plot plot_of(const Figure& figure, const CampaignOutcome& outcome);

/// One run's own profile at its last stage: its solvers, its references, the exact solution of each model.
Plot plot_of(const RunOutcome& run, exchange::Quantity quantity, const CampaignOutcome& outcome);

} // namespace settle::compare::report
