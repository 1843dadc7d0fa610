/// \file
/// Figures of bodies of polygons: fields along a line of probes, from one end to the other.
#pragma once

#include <string>
#include <vector>

#include "figure_data.hpp"

namespace settle::compare::report {

/// Is the case of a body of polygons, which has no height to draw profiles over?
bool is_body(const exchange::Case& study);

/// Samples along a line of probes, one segment a layer. A vector or tensor is drawn by its norm.
Profile line_profile(const FieldSamples& samples, const exchange::Probes& line, exchange::Quantity quantity);

/// A figure's curves along the first line of probes of the first of its runs that is a body of polygons.
Plot line_plot_of(const Figure& figure, const CampaignOutcome& outcome);

/// One run at its last stage, for each of its lines: displacement and stress (their norms), vertical and shear stress.
std::vector<Plot> line_plots_of(const RunOutcome& run, const CampaignOutcome& outcome);

} // namespace settle::compare::report
