#include "settle/mpm/body.hpp"

#include <numeric>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

template <class Space>
void replace_stress_by_cell_average(Body<Space>& body) {
  for (const int cell : body.cells.occupied) {
    const PointRange range = points_in(body, cell);
    const auto average = average_stress_of(body.points, range).average;
    for (std::size_t p = range.first; p < range.last; ++p) {
      body.points.stress[0][p] = average.tensor(0, 0);
      body.points.stress[1][p] = average.tensor(1, 1);
      body.points.stress[2][p] = average.out_of_plane;
      body.points.stress[3][p] = average.tensor(0, 1);
    }
  }
}

template <class Space>
std::vector<PerAxis<bool, Space::dim>> oedometer_supports(const Space& space) {
  std::vector<PerAxis<bool, Space::dim>> fixed(static_cast<std::size_t>(space.n_nodes()));
  for (int node = 0; node < space.n_nodes(); ++node) {
    const int column = node % space.node_columns(), row = node / space.node_columns();
    fixed[static_cast<std::size_t>(node)] = {column == 0 || column == space.node_columns() - 1, row == 0};
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
template double total_volume(const Points<2>&);

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template void replace_stress_by_cell_average(Body<Space>&);                                                          \
  template std::vector<PerAxis<bool, Space::dim>> oedometer_supports(const Space&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
