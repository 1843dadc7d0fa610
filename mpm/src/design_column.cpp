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
  for (std::size_t i = 0; i < column.strips.size(); ++i) {
    auto& strip = column.strips[i];
    const auto cut = cut_along(polygon, x + (static_cast<double>(i) + 0.5) / n * width);
    if (!cut) continue;
    strip = strip ? DesignColumn::Strip{std::max(strip->top, cut->top), std::min(strip->foot, cut->foot)} : *cut;
  }
}

/// Half of what a point extended along x when it was placed [m].
template <class Space>
double half_width(const Body<Space>& body, std::size_t p) {
  const double size = body.space.size(), column = (body.points.placed[0][p] - body.space.origin()[0]) / size;
  const double inside = column - std::floor(column);
  return size * std::min({0.5 / body.layout.row_points, inside, 1.0 - inside});
}

} // namespace

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
  const double left = body.space.origin()[0], size = body.space.size();
  std::vector<double> heights(static_cast<std::size_t>(body.space.columns()), body.space.origin()[1]);
  const auto column_at = [&](double x) {
    return std::clamp(static_cast<int>(std::floor((x - left) / size)), 0, body.space.columns() - 1);
  };
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const double x = body.points.position[0][p], half = half_width(body, p);
    const double height = body.points.volume[p] / body.space.column_area();
    const int first = column_at(x - half), last = column_at(x + half);
    for (int column = first; column <= last; ++column) {
      const double from = column == first ? x - half : left + column * size;
      const double to = column == last ? x + half : left + (column + 1) * size;
      heights[static_cast<std::size_t>(column)] += first == last ? height : (to - from) / (2.0 * half) * height;
    }
  }
  return heights;
}

#define SETTLE_INSTANTIATE(Space) template std::vector<double> extended_column_heights(const Body<Space>&);
SETTLE_FOR_EVERY_PLANE_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
