/// \file
/// Axes of small drawings that are written as SVG directly.
#pragma once

#include <string>
#include <vector>

namespace settle::compare::report {

/// An axis: values and the pixels on which they lie.
struct ChartAxis {
  double lowest = 0, highest = 1; ///< values at its ends
  double from = 0, to = 1;        ///< pixels at its ends
  std::string title{};
  std::string unit{};

  [[nodiscard]] double pixel(double value) const { return from + (to - from) * (value - lowest) / (highest - lowest); }
};

/// Round values (1, 2, 5 times a power of ten apart) on an axis, `most` or fewer.
std::vector<double> round_values(double lowest, double highest, int most);
/// How the values of an axis are written: in full, or in a power of a thousand of the unit that stands in the title.
struct AxisText {
  std::string title; ///< "Settlement [10⁻⁶ m]"
  std::vector<double> values;
  std::vector<std::string> labels;
};
AxisText axis_text(const ChartAxis& axis, int most);

/// Lines, tics and titles of the axes of a drawing, as SVG elements.
std::string axes_svg(const ChartAxis& x, const ChartAxis& y);
/// Tics and title below a horizontal axis alone.
std::string axis_svg(const ChartAxis& x, double y);

/// A text fit to stand in SVG and HTML.
std::string escaped(const std::string& text);

} // namespace settle::compare::report
