#include "settle/exchange/probe_points.hpp"

#include <algorithm>

#include "settle/exchange/plane_geometry.hpp"

namespace settle::exchange {
namespace {

std::vector<ProbePoint> points_in_column(const Case& study, const Probes& line) {
  const bool solid = study.geometry.dimension == 3;
  const double x = line.x.value_or(study.geometry.width / 2);
  const double y = solid ? line.y.value_or(study.geometry.depth.value_or(study.geometry.width) / 2) : 0.0;
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

std::vector<ProbePoint> points_across_polygons(const Geometry& geometry, const Probes& line) {
  const double slack = 1e-9 * (geometry.width + geometry.height); // ends of lines stand on boundaries up to round-off
  constexpr int usual_count = 9;
  const int count = line.points.value_or(usual_count);
  const double y = geometry.dimension == 3 ? geometry.depth.value_or(geometry.width) / 2 : 0.0;
  std::vector<ProbePoint> points;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const PlanePoint at{line.from[0] + share * (line.to[0] - line.from[0]),
                        line.from[1] + share * (line.to[1] - line.from[1])};
    for (const int layer : layers_at(geometry, at, slack))
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

} // namespace settle::exchange
