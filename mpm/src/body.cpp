#include "settle/mpm/body.hpp"

#include <numeric>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

template <class Space>
void replace_stress_by_cell_average(Body<Space>& body) {
  for (const int cell : body.cells.occupied) {
    const PointRange range = points_in(body, cell);
    const auto average = average_stress_of(body.points, range).average;
    for (std::size_t p = range.first; p < range.last; ++p)
      set_stress(body.points, p, average);
  }
}

template <class Space>
std::vector<PerAxis<bool, Space::dim>> oedometer_supports(const Space& space) {
  constexpr std::size_t vertical = Space::dim - 1;
  const auto& numbering = space.node_numbering();
  std::vector<PerAxis<bool, Space::dim>> fixed(static_cast<std::size_t>(space.n_nodes()));
  for (int node = 0; node < space.n_nodes(); ++node) {
    const auto index = numbering.index(node);
    auto& held = fixed[static_cast<std::size_t>(node)];
    for (std::size_t d = 0; d <= vertical; ++d)
      held[d] = index[d] == 0 || (d != vertical && index[d] == numbering.counts[d] - 1);
  }
  return fixed;
}

template <int dim>
double total_mass(const Points<dim>& points) {
  return std::accumulate(points.mass.begin(), points.mass.end(), 0.0);
}

template <int dim>
double total_volume(const Points<dim>& points) {
  return std::accumulate(points.volume.begin(), points.volume.end(), 0.0);
}

template double total_mass(const Points<2>&);
template double total_mass(const Points<3>&);
template double total_volume(const Points<2>&);
template double total_volume(const Points<3>&);

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template void replace_stress_by_cell_average(Body<Space>&);                                                          \
  template std::vector<PerAxis<bool, Space::dim>> oedometer_supports(const Space&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
