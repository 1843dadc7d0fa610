/// \file
/// Errors over the size of a level, both logarithmic, with fitted lines and slope triangles.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/family.hpp"

namespace settle::compare::report {

/// The studies of one quantity of a family.
struct ConvergencePlot {
  exchange::Quantity quantity = exchange::Quantity::settlement;
  exchange::RefinedSize size = exchange::RefinedSize::element_size;
  std::vector<const ConvergenceStudy*> studies;
};

/// One plot for each quantity of a family, in the order of its studies; what cannot be drawn on logarithmic axes is
/// named in `missing`.
std::vector<ConvergencePlot> convergence_plots(const Family& family, std::vector<std::string>& missing);

/// The gnuplot script of a plot, its data inside.
std::string gnuplot_script(const ConvergencePlot& plot);

} // namespace settle::compare::report
