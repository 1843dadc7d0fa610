#include "settle/mpm/point_layout.hpp"

#include <numeric>

#include "settle/mpm/square_grid.hpp"

namespace settle::mpm {

template <int dim>
std::size_t PointLayout<dim>::points_per_square() const {
  return std::accumulate(cells.begin(), cells.end(), std::size_t{0},
                         [](std::size_t sum, const auto& positions) { return sum + positions.size(); });
}

PointLayout<2> triangle_layout() {
  const std::vector<Vector<2>> lower{{1.0 / 6.0, 1.0 / 6.0}, {2.0 / 3.0, 1.0 / 6.0}, {1.0 / 6.0, 2.0 / 3.0}};
  std::vector<Vector<2>> upper;
  for (const auto& position : lower)
    upper.emplace_back(Vector<2>::Ones() - position);
  return {.cells = {lower, upper}, .row_height = 1.0 / 6.0, .row_points = 2};
}

template <int dim>
PointLayout<dim> lattice_layout(int per_side) {
  BoxNumbering<dim> lattice{};
  lattice.counts.fill(per_side);
  std::vector<Vector<dim>> positions(static_cast<std::size_t>(lattice.size()));
  for (int point = 0; point < lattice.size(); ++point)
    for (std::size_t d = 0; d < dim; ++d)
      positions[static_cast<std::size_t>(point)][static_cast<int>(d)] = (lattice.index(point)[d] + 0.5) / per_side;
  return {.cells = {positions}, .row_height = 1.0 / per_side, .row_points = per_side};
}

template struct PointLayout<2>;
template struct PointLayout<3>;
template PointLayout<2> lattice_layout(int);
template PointLayout<3> lattice_layout(int);

} // namespace settle::mpm
