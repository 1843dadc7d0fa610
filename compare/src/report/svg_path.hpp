/// \file
/// Lines of a drawing: read from an SVG path, and written as a short one. Coordinates are pixels of the drawing.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace settle::compare::report {

struct SvgPoint {
  double x = 0, y = 0;
};

struct SvgLine {
  std::vector<SvgPoint> points;
  bool closed = false;
};

/// The lines of a path made of M, L, h, v and z; nothing for any other.
std::optional<std::vector<SvgLine>> parse_path(std::string_view text);

/// The line without points that lie nearer than `tolerance` to what is left (Douglas & Peucker 1973).
SvgLine simplified(const SvgLine& line, double tolerance);

/// A coordinate with one decimal at most: "12.3", "-.5", "7".
std::string short_coordinate(double value);

/// A path with one decimal: the start of each line absolute where that is shorter, all else relative. A line of one
/// point is a dot.
std::string path_text(const std::vector<SvgLine>& lines);

} // namespace settle::compare::report
