/// \file
/// How the curves of a figure look: solvers and references as markers, exact solutions and Eq. (1) as lines.
#pragma once

#include <string>
#include <vector>

#include "figure_data.hpp"

namespace settle::compare::report {

struct CurveStyle {
  std::string colour;      ///< "#0072B2"
  bool line = false;       ///< a line, else markers
  int dash_type = 1;       ///< gnuplot's, of a line
  int point_type = 7;      ///< gnuplot's, of markers
  double point_size = 0.5; ///< of markers
};

/// How a source looks where it is alone: "mpm", "fem", an exact solution, or anything else.
CurveStyle style_of(const std::string& source);

/// One style a curve. A figure about one run has a colour for each source, a figure about several runs a colour for
/// each run; the shape tells the source in both. Colours: Okabe & Ito (2008), distinguishable by the colour-blind.
std::vector<CurveStyle> styles_of(const Plot& plot);

} // namespace settle::compare::report
