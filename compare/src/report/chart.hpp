/// \file
/// A small chart written as SVG directly: a few kilobytes, beside the figures that gnuplot draws and as tall as they
/// are.
#pragma once

#include <string>
#include <vector>

#include "chart_frame.hpp"

namespace settle::compare::report {

struct ChartPoint {
  double x = 0, y = 0;
};

struct ChartSeries {
  std::string label;
  std::string colour;                          ///< "#0072B2"
  bool line = false;                           ///< a line, else spots
  bool dashed = false;                         ///< of a line
  std::vector<std::vector<ChartPoint>> pieces; ///< never joined; all finite
};

struct Chart {
  std::string id; ///< unique in the page
  std::string title;
  std::string caption;
  ChartAxis x{}, y{}; ///< titles and units; ends only where `keeps_y`, else they are those of the data
  bool keeps_y = false;
  std::vector<ChartSeries> series;
  std::vector<std::string> missing; ///< a sentence for whatever could not be drawn
};

/// Takes points that cannot be drawn out of a series, and says so.
void drop_points_that_are_not_finite(ChartSeries& series, std::vector<std::string>& missing);

/// The figure with its key, as HTML. Both axes reach to zero, so that sizes can be judged.
std::string chart_html(Chart chart);

} // namespace settle::compare::report
