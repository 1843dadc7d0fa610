#include "settle/mpm/point_layout.hpp"

#include <cmath>
#include <numeric>

#include "settle/mpm/tetrahedron_space.hpp"

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

PointLayout<3> tetrahedron_layout() {
  const double far = (5.0 - std::sqrt(5.0)) / 20.0, near = 1.0 - 3.0 * far;
  PointLayout<3> layout{.cells = {}, .row_height = far, .row_points = 2};
  for (const PerAxis<int, 3>& order : TetrahedronSpace::orders) {
    auto& positions = layout.cells.emplace_back();
    for (int nearest = 0; nearest < 4; ++nearest) {
      Vector<3>& position = positions.emplace_back(Vector<3>::Zero());
      for (int k = 0; k < 3; ++k) // of the nodes after node k, which lie beyond the edge along this axis
        position[order[static_cast<std::size_t>(k)]] = (3 - k) * far + (nearest > k ? near - far : 0.0);
    }
  }
  return layout;
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
