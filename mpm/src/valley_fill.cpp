#include "settle/mpm/valley_fill.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "lattice_fill.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::mpm {
namespace {

using exchange::Span;

/// The rectangle of a dam at a height.
struct Rectangle {
  Span x, y;
};

Rectangle at_height(const exchange::Geometry& dam, double height) {
  return {exchange::fill_at(*dam.embankment, height), exchange::valley_at(*dam.valley, height)};
}

/// What two spans share; of no width where they do not meet.
Span common(const Span& one, const Span& other) {
  const double from = std::max(one.from, other.from);
  return {from, std::max(from, std::min(one.to, other.to))};
}

/// Adds the heights between `levels` at which a line, linear in the height, passes the ends of a span.
void add_passages(const Levels& levels, double at_low, double at_high, const Span& ends, std::vector<double>& heights) {
  for (const double end : {ends.from, ends.to}) {
    const double share = (end - at_low) / (at_high - at_low);
    if (share > 0.0 && share < 1.0) heights.push_back(levels.low + share * (levels.high - levels.low)); // no NaN
  }
}

/// Heights in ascending order between which the sides of what the dam and a cube share are linear.
std::vector<double> break_points(const exchange::Geometry& dam, const Levels& levels, const Rectangle& cube) {
  const Rectangle low = at_height(dam, levels.low), high = at_height(dam, levels.high);
  std::vector<double> heights{levels.low, levels.high};
  add_passages(levels, low.x.from, high.x.from, cube.x, heights);
  add_passages(levels, low.x.to, high.x.to, cube.x, heights);
  add_passages(levels, low.y.from, high.y.from, cube.y, heights);
  add_passages(levels, low.y.to, high.y.to, cube.y, heights);
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Adds volume and first moment, which are of degree 2 and 3 in the height between break points: two Gauss points are
/// exact.
void add_slab(const exchange::Geometry& dam, const Levels& slab, const Rectangle& cube, Piece<3>& part) {
  const double middle = 0.5 * (slab.low + slab.high), half = 0.5 * (slab.high - slab.low);
  for (const double side : {-1.0, 1.0}) {
    const double height = middle + side * half / std::numbers::sqrt3;
    const Rectangle whole = at_height(dam, height);
    const Span x = common(whole.x, cube.x), y = common(whole.y, cube.y);
    const double volume = half * x.width() * y.width();
    part.volume += volume;
    part.centroid += volume * Vector<3>(0.5 * (x.from + x.to), 0.5 * (y.from + y.to), height);
  }
}

Piece<3> part_in_cube(const exchange::Geometry& dam, const Levels& layer, const Vector<3>& corner, double size) {
  Piece<3> part{Vector<3>::Zero(), 0.0};
  const Levels levels{std::max(layer.low, corner[2]), std::min(layer.high, corner[2] + size)};
  if (!(levels.high > levels.low)) return part;
  const Rectangle cube{{corner[0], corner[0] + size}, {corner[1], corner[1] + size}};
  const std::vector<double> heights = break_points(dam, levels, cube);
  for (std::size_t i = 1; i < heights.size(); ++i)
    add_slab(dam, {heights[i - 1], heights[i]}, cube, part);
  if (part.volume > 0) part.centroid /= part.volume;
  return part;
}

/// Of a slope, which starts that far before a place [m]: infinite at a vertical one.
double climb(double beyond, double slope) {
  return beyond > 0.0 ? beyond / slope : 0.0;
}

} // namespace

Levels levels_of_layer(const exchange::Geometry& geometry, int layer) {
  Levels levels{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const exchange::Polygon& polygon : geometry.polygons)
    for (const auto& corner : polygon.corners)
      if (polygon.layer == layer) levels = {std::min(levels.low, corner[1]), std::max(levels.high, corner[1])};
  return levels;
}

std::optional<Levels> dam_on_vertical(const exchange::Geometry& geometry, const Levels& levels, double x, double y) {
  const exchange::Embankment& fill = *geometry.embankment;
  const exchange::Valley& valley = *geometry.valley;
  const double below_crest =
      std::max(climb(-0.5 * fill.crest - x, fill.slopes[0]), climb(x - 0.5 * fill.crest, fill.slopes[1]));
  const double above_floor =
      std::max(climb(-0.5 * valley.bottom - y, valley.slopes[0]), climb(y - 0.5 * valley.bottom, valley.slopes[1]));
  const Levels there{std::max(levels.low, above_floor), std::min(levels.high, fill.height - below_crest)};
  if (!(there.high > there.low)) return {};
  return there;
}

std::vector<Piece<3>> cut_dam(const exchange::Geometry& geometry, const Levels& levels, const Lattice<3>& lattice) {
  const Rectangle low = at_height(geometry, levels.low), high = at_height(geometry, levels.high);
  const LatticeFill fill(
      lattice, [&](const Vector<3>& corner, double size) { return part_in_cube(geometry, levels, corner, size); });
  return fill.pieces({low.x.from, high.y.from, levels.low}, {low.x.to, high.y.to, levels.high});
}

} // namespace settle::mpm
