#include "settle/mpm/design_column.hpp"

#include <algorithm>
#include <cmath>

#include "settle/exchange/plane_geometry.hpp"
#include "settle/mpm/body.hpp"
#include "settle/mpm/polygon_fill.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {
namespace {

/// The heights between which a convex polygon is met by a vertical line; nothing where it is not.
std::optional<DesignColumn::Strip> cut_along(const exchange::Polygon& polygon, double x) {
  std::optional<DesignColumn::Strip> cut;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const auto &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    if (a[0] == b[0] || x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
    const double y = a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
    cut = cut ? DesignColumn::Strip{std::max(cut->top, y), std::min(cut->foot, y)} : DesignColumn::Strip{y, y};
  }
  return cut;
}

/// Adds a polygon to a column whose left side is at x.
void add(const exchange::Polygon& polygon, const exchange::PlaneBox& extent, double x, double width,
         DesignColumn& column) {
  const Vector<2> corner(x, extent.lowest[1]), sides(width, extent.highest[1] - extent.lowest[1]);
  column.level += part_in_box(polygon, corner, sides).volume / width;
  const auto n = static_cast<double>(column.strips.size());
  for (std::size_t i = 0; i < column.strips.size(); ++i)
    if (const auto cut = cut_along(polygon, x + (static_cast<double>(i) + 0.5) / n * width)) column.add(i, *cut);
}

/// Half of what a point extended along a horizontal axis when it was placed [m].
template <class Space>
double half_width(const Body<Space>& body, std::size_t p, std::size_t axis) {
  const double size = body.space.size(), origin = body.space.origin()[static_cast<int>(axis)];
  const double column = (body.points.placed[axis][p] - origin) / size;
  const double inside = column - std::floor(column);
  return size * std::min({0.5 / body.layout.row_points, inside, 1.0 - inside});
}

/// Over which squares of the grid a point extends along a horizontal axis.
struct Spread {
  double origin, size; ///< of the grid and its squares [m]
  double middle, half; ///< of the point, and half of what it extends [m]
  int first, last;     ///< squares along the axis

  /// Of the point over a square.
  [[nodiscard]] double share(int square) const {
    if (first == last) return 1.0;
    const double from = square == first ? middle - half : origin + square * size;
    const double to = square == last ? middle + half : origin + (square + 1) * size;
    return (to - from) / (2.0 * half);
  }
};

template <class Space>
Spread spread_of(const Body<Space>& body, std::size_t p, std::size_t axis) {
  Spread spread{.origin = body.space.origin()[static_cast<int>(axis)],
                .size = body.space.size(),
                .middle = body.points.position[axis][p],
                .half = half_width(body, p, axis),
                .first = 0,
                .last = 0};
  const auto square_at = [&](double x) {
    const int count = body.space.box().counts[axis];
    return std::clamp(static_cast<int>(std::floor((x - spread.origin) / spread.size)), 0, count - 1);
  };
  spread.first = square_at(spread.middle - spread.half), spread.last = square_at(spread.middle + spread.half);
  return spread;
}

} // namespace

void DesignColumn::add(std::size_t strip, const Strip& there) {
  auto& own = strips[strip];
  own = own ? Strip{std::max(own->top, there.top), std::min(own->foot, there.foot)} : there;
}

void DesignColumn::add(const DesignColumn& layer, double base) {
  level += layer.level - base;
  for (std::size_t i = 0; i < strips.size(); ++i)
    if (layer.strips[i]) add(i, *layer.strips[i]);
}

double DesignColumn::covered() const {
  const auto covered = std::count_if(strips.begin(), strips.end(), [](const auto& strip) { return strip.has_value(); });
  return static_cast<double>(covered) / static_cast<double>(strips.size());
}

double DesignColumn::mean_top() const {
  double sum = 0;
  for (const auto& strip : strips)
    if (strip) sum += strip->top;
  return sum / (covered() * static_cast<double>(strips.size()));
}

std::vector<DesignColumn> design_columns(const exchange::Geometry& geometry, const std::set<int>& layers,
                                         const GridBox<2>& grid, int strips) {
  const exchange::PlaneBox extent = exchange::bounding_box(geometry);
  std::vector<DesignColumn> columns(static_cast<std::size_t>(grid.counts[0]));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    columns[c].level = grid.origin[1];
    columns[c].strips.resize(static_cast<std::size_t>(strips));
    for (const exchange::Polygon& polygon : geometry.polygons)
      if (layers.contains(polygon.layer))
        add(polygon, extent, grid.origin[0] + static_cast<double>(c) * grid.size, grid.size, columns[c]);
  }
  return columns;
}

template <class Space>
std::vector<double> extended_column_heights(const Body<Space>& body) {
  constexpr int dim = Space::dim;
  const int across = body.space.box().counts[0];
  std::vector<double> heights(static_cast<std::size_t>(body.space.columns()), body.space.origin()[dim - 1]);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const double height = body.points.volume[p] / body.space.column_area();
    const Spread x = spread_of(body, p, 0);
    const auto add_slice = [&](int j, double share) {
      for (int i = x.first; i <= x.last; ++i)
        heights[static_cast<std::size_t>(i + across * j)] += share * x.share(i) * height;
    };
    if constexpr (dim == 2) {
      add_slice(0, 1.0);
    } else {
      const Spread y = spread_of(body, p, 1);
      for (int j = y.first; j <= y.last; ++j)
        add_slice(j, y.share(j));
    }
  }
  return heights;
}

#define SETTLE_INSTANTIATE(Space) template std::vector<double> extended_column_heights(const Body<Space>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
