#include "ground.hpp"

#include <algorithm>

namespace settle::mpm {
namespace {

double horizontal_ratio(const exchange::Case& study, int layer) {
  for (const exchange::StageEntry& entry : study.stages)
    if (entry.action == exchange::Action::ground && entry.layer == layer && entry.k0) return *entry.k0;
  const double nu = study.material_of(layer).poissons_ratio;
  return nu / (1.0 - nu);
}

/// Upper and lower side of a level layer [m].
std::pair<double, double> levels_of(const exchange::Geometry& geometry, int layer) {
  std::pair<double, double> levels{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const exchange::Polygon& polygon : geometry.polygons)
    for (const auto& corner : polygon.corners)
      if (polygon.layer == layer) levels = {std::max(levels.first, corner[1]), std::min(levels.second, corner[1])};
  return levels;
}

} // namespace

template <int dim>
void set_level_stress(const exchange::Case& study, int layer, Points<dim>& points) {
  constexpr std::size_t up = dim - 1;
  const auto [upper, lower] = levels_of(study.geometry, layer);
  const double unit_weight = study.gravity * study.material_of(layer).density;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double cover = points.layer[p] == layer ? upper - points.position[up][p] : upper - lower;
    const double vertical = -unit_weight * cover, horizontal = horizontal_ratio(study, points.layer[p]) * vertical;
    for (std::size_t c = 0; c < 3; ++c)
      points.stress[c][p] += c == up ? vertical : horizontal;
  }
}

template void set_level_stress(const exchange::Case&, int, Points<2>&);
template void set_level_stress(const exchange::Case&, int, Points<3>&);

} // namespace settle::mpm
