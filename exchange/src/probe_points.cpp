#include "settle/exchange/probe_points.hpp"

#include <algorithm>
#include <cmath>

#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::exchange {
namespace {

std::vector<ProbePoint> points_in_column(const Case& study, const Probes& line) {
  const bool solid = study.geometry.dimension == 3;
  const double x = line.x.value_or(study.geometry.width / 2);
  const double y = solid ? line.y.value_or(middle_of_depth(study.geometry)) : 0.0;
  std::vector<ProbePoint> points;
  for (int layer = 1; layer <= study.construction.layers; ++layer) {
    for (int i = 0; i < line.points_per_layer; ++i) {
      const double xi = static_cast<double>(i) / (line.points_per_layer - 1);
      const double height = study.geometry.height * (layer - 1 + xi) / study.construction.layers;
      points.push_back({.layer = layer, .relative_height = xi, .x = x, .y = y, .design_height = height});
    }
  }
  return points;
}

bool is_between_flanks(const Valley& valley, double y, double height, double slack) {
  const Span flanks = valley_at(valley, height);
  return y >= flanks.from - slack && y <= flanks.to + slack;
}

std::vector<ProbePoint> points_across_polygons(const Geometry& geometry, const Probes& line) {
  const double slack = 1e-9 * (geometry.width + geometry.height); // ends of lines stand on boundaries up to round-off
  constexpr int usual_count = 9;
  const int count = line.points.value_or(usual_count);
  const double middle = geometry.dimension == 3 ? middle_of_depth(geometry) : 0.0;
  std::vector<ProbePoint> points;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const auto along = [&](std::size_t axis) { return line.from[axis] + share * (line.to[axis] - line.from[axis]); };
    const PlanePoint at{along(0), along(line.from.size() - 1)};
    const double y = geometry.varies_along_y() ? along(1) : middle;
    if (geometry.valley && !is_between_flanks(*geometry.valley, y, at[1], slack)) continue;
    const bool solid = geometry.solid_mesh();
    for (const int layer : solid ? layers_at(*geometry.mesh, {at[0], y, at[1]}, slack) : layers_at(geometry, at, slack))
      points.push_back({.layer = layer, .x = at[0], .y = y, .design_height = at[1]});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const ProbePoint& a, const ProbePoint& b) { return a.layer < b.layer; });
  return points;
}

} // namespace

std::vector<ProbePoint> probe_points(const Case& study, const Probes& line) {
  if (study.geometry.drawn()) return points_across_polygons(study.geometry, line);
  return points_in_column(study, line);
}

double distance_from_start(const Probes& line, const ProbePoint& point) {
  const double dy = line.from.size() == 3 ? point.y - line.from[1] : 0.0;
  return std::hypot(point.x - line.from.front(), dy, point.design_height - line.from.back());
}

double length_of(const Probes& line) {
  const double y = line.to.size() == 3 ? line.to[1] : 0.0;
  return distance_from_start(line, {.x = line.to.front(), .y = y, .design_height = line.to.back()});
}

} // namespace settle::exchange
