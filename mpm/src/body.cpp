#include "settle/mpm/body.hpp"

#include <numeric>

namespace settle::mpm {

template <class Grid>
CellStress<Grid::dim> average_stress_of(const Body<Grid>& body, int cell) {
  static_assert(Grid::dim == 2, "the component order below is that of plane strain");
  const auto& points = body.points;
  const auto c = static_cast<std::size_t>(cell);
  double volume = 0, xx = 0, yy = 0, zz = 0, xy = 0;
  for (std::size_t p = body.cells.begin[c]; p < body.cells.begin[c + 1]; ++p) {
    const double v = points.volume[p];
    volume += v;
    xx += v * points.stress[0][p];
    yy += v * points.stress[1][p];
    zz += v * points.stress[2][p];
    xy += v * points.stress[3][p];
  }
  CellStress<2> result;
  result.points_volume = volume;
  result.average.tensor << xx, xy, xy, yy;
  result.average.tensor /= volume;
  result.average.out_of_plane = zz / volume;
  return result;
}

template <class Grid>
void replace_stress_by_cell_average(Body<Grid>& body) {
  for (const int cell : body.cells.occupied) {
    const auto average = average_stress_of(body, cell).average;
    const auto c = static_cast<std::size_t>(cell);
    for (std::size_t p = body.cells.begin[c]; p < body.cells.begin[c + 1]; ++p) {
      body.points.stress[0][p] = average.tensor(0, 0);
      body.points.stress[1][p] = average.tensor(1, 1);
      body.points.stress[2][p] = average.out_of_plane;
      body.points.stress[3][p] = average.tensor(0, 1);
    }
  }
}

std::vector<std::array<bool, 2>> oedometer_supports(const TriangleGrid& grid) {
  std::vector<std::array<bool, 2>> fixed(static_cast<std::size_t>(grid.n_nodes()));
  for (int node = 0; node < grid.n_nodes(); ++node) {
    const int column = node % (grid.columns() + 1), row = node / (grid.columns() + 1);
    fixed[static_cast<std::size_t>(node)] = {column == 0 || column == grid.columns(), row == 0};
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

template CellStress<2> average_stress_of(const Body<TriangleGrid>&, int);
template void replace_stress_by_cell_average(Body<TriangleGrid>&);
template double total_mass(const Points<2>&);
template double total_volume(const Points<2>&);

} // namespace settle::mpm
