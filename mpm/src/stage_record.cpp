#include "stage_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "construction.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

template <int dim>
exchange::SamplePoints sample_points(const Points<dim>& points) {
  exchange::SamplePoints samples;
  samples.id = points.id;
  samples.layer = points.layer;
  samples.refilled = points.refilled;
  samples.volume = points.volume;
  samples.plastic_strain = points.plastic_strain;
  samples.preconsolidation_pressure = points.preconsolidation_pressure;
  for (std::size_t p = 0; p < points.size(); ++p) {
    samples.density.push_back(points.density(p));
    for (std::size_t d = 0; d < dim; ++d) {
      samples.placed_position.push_back(points.placed[d][p]);
      samples.position.push_back(points.position[d][p]);
      samples.displacement.push_back(points.position[d][p] - points.placed[d][p]);
    }
    for (const auto& component : points.stress)
      samples.stress.push_back(component[p]);
    samples.stress.resize(recorded_stress_size * (p + 1), 0.0); // in the plane none with z
  }
  return samples;
}

template exchange::SamplePoints sample_points(const Points<2>&);
template exchange::SamplePoints sample_points(const Points<3>&);

template <int dim>
double highest_surface(const Points<dim>& points, double row, double spacing) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double area = points.volume[p] / row;
    const double height = points.refilled[p] != 0 ? area / spacing : std::sqrt(area);
    highest = std::max(highest, points.position[dim - 1][p] + 0.5 * height);
  }
  return highest;
}

template double highest_surface(const Points<2>&, double, double);
template double highest_surface(const Points<3>&, double, double);

template <class Space>
double surface_height(const Body<Space>& body, exchange::Convention convention) {
  if (convention != exchange::Convention::drop) return mean_surface(body);
  constexpr std::size_t vertical = Space::dim - 1;
  const auto& heights = body.points.position[vertical];
  const auto& placed = body.points.placed[vertical];
  const auto highest =
      static_cast<std::size_t>(std::distance(heights.begin(), std::max_element(heights.begin(), heights.end())));
  double row_volume = 0;
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (placed[p] == placed[highest]) row_volume += body.points.volume[p];
  return heights[highest] + 0.5 * row_volume / body.space.plan_area();
}

#define SETTLE_INSTANTIATE(Space) template double surface_height(const Body<Space>&, exchange::Convention);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
