#include "embankment_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace settle::fem {
namespace {

using exchange::Polygon;

/// Left to right, and their heights from below.
struct Lines {
  std::vector<double> left, right; ///< (lifts + 1) ends of the fill where lifts begin and end, from below [m]
  std::vector<double> heights;     ///< (lifts + 1) [m]
};

Lines lines_of(const exchange::Embankment& fill, int lifts) {
  Lines lines;
  for (int i = 0; i <= lifts; ++i) {
    const double height = i == lifts ? fill.height : fill.height * i / lifts, below_crest = fill.height - height;
    lines.heights.push_back(height);
    lines.left.push_back(-0.5 * fill.crest - fill.slopes[0] * below_crest);
    lines.right.push_back(0.5 * fill.crest + fill.slopes[1] * below_crest);
  }
  return lines;
}

/// From the end of lift `from` on the left to that on the right: all vertical lines between them.
std::vector<double> across(const Lines& lines, std::size_t from) {
  std::vector<double> positions(lines.left.begin() + static_cast<std::ptrdiff_t>(from), lines.left.end());
  positions.insert(positions.end(), lines.right.rbegin(), lines.right.rend() - static_cast<std::ptrdiff_t>(from));
  return positions;
}

/// Rectangles between vertical lines; two lines in one place have none between them.
void add_row(const std::vector<double>& lines, double bottom, double top, Polygon like, std::vector<Polygon>& row) {
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (!(lines[i] > lines[i - 1])) continue;
    like.corners = {{lines[i - 1], bottom}, {lines[i], bottom}, {lines[i], top}, {lines[i - 1], top}};
    row.push_back(like);
  }
}

void add_lift(const Lines& lines, std::size_t lift, const Polygon& like, std::vector<Polygon>& polygons) {
  const double bottom = lines.heights[lift], top = lines.heights[lift + 1];
  const auto add_triangle = [&](double toe, double foot, std::vector<std::vector<double>> corners) {
    if (toe == foot) return;
    polygons.push_back(like);
    polygons.back().corners = std::move(corners);
  };
  const double left_toe = lines.left[lift], left_foot = lines.left[lift + 1];
  const double right_toe = lines.right[lift], right_foot = lines.right[lift + 1];
  add_triangle(left_toe, left_foot, {{left_toe, bottom}, {left_foot, bottom}, {left_foot, top}});
  add_row(across(lines, lift + 1), bottom, top, like, polygons);
  add_triangle(right_toe, right_foot, {{right_foot, bottom}, {right_toe, bottom}, {right_foot, top}});
}

/// Rows of one cell each, as high as those of the fill or less.
void add_foundation(const exchange::Embankment& fill, const Lines& lines, double row_height,
                    std::vector<Polygon>& polygons) {
  const std::vector<double> under_fill = across(lines, 0);
  std::vector<double> vertical{under_fill.front() - fill.foundation_left};
  vertical.insert(vertical.end(), under_fill.begin(), under_fill.end());
  vertical.push_back(under_fill.back() + fill.foundation_right);
  constexpr double round_off = 1e-6; // of a row
  const auto rows = static_cast<int>(std::ceil(fill.foundation_depth / row_height - round_off));
  for (int row = 0; row < rows; ++row)
    add_row(vertical, -fill.foundation_depth * (rows - row) / rows, -fill.foundation_depth * (rows - row - 1) / rows,
            {.layer = 1, .corners = {}, .material = fill.foundation_material}, polygons);
}

} // namespace

exchange::Case divided_embankment(const exchange::Case& study) {
  const exchange::Embankment& fill = *study.geometry.embankment;
  const int ground = fill.foundation_depth > 0 ? 1 : 0, lifts = study.construction.layers - ground;
  const double thickness = fill.height / lifts, slope = std::max(fill.slopes[0], fill.slopes[1]);
  constexpr double round_off = 1e-6; // of a pair of rows
  const double pairs =
      std::ceil(thickness * std::sqrt(std::max(slope, 1.0)) / (2 * study.fem.element_size) - round_off);
  const double rows = 2 * std::max(pairs, 1.0); // of a lift: a triangle's edges have an even number of parts
  const Lines lines = lines_of(fill, lifts);

  exchange::Case divided = study;
  divided.geometry.shape = exchange::Shape::polygons;
  divided.fem.element_size = std::hypot(thickness, slope * thickness) / rows;
  std::vector<Polygon> polygons;
  if (ground == 1) add_foundation(fill, lines, thickness / rows, polygons);
  for (int lift = 0; lift < lifts; ++lift)
    add_lift(lines, static_cast<std::size_t>(lift), {.layer = ground + lift + 1}, polygons);
  divided.geometry.polygons.swap(polygons);
  return divided;
}

} // namespace settle::fem
