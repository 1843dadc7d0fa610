#include "settle/exchange/probe_points.hpp"

namespace settle::exchange {

std::vector<ProbePoint> probe_points(const Case& study, const Probes& line) {
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

} // namespace settle::exchange
