#include "settle/mpm/point_layout.hpp"

#include <numeric>

namespace settle::mpm {

std::size_t PointLayout::points_per_square() const {
  return std::accumulate(cells.begin(), cells.end(), std::size_t{0},
                         [](std::size_t sum, const auto& positions) { return sum + positions.size(); });
}

PointLayout triangle_layout() {
  const std::vector<Vector<2>> lower{{1.0 / 6.0, 1.0 / 6.0}, {2.0 / 3.0, 1.0 / 6.0}, {1.0 / 6.0, 2.0 / 3.0}};
  std::vector<Vector<2>> upper;
  for (const auto& position : lower)
    upper.emplace_back(Vector<2>::Ones() - position);
  return {.cells = {lower, upper}, .row_height = 1.0 / 6.0, .row_points = 2};
}

PointLayout lattice_layout(int per_side) {
  std::vector<Vector<2>> positions;
  for (int j = 0; j < per_side; ++j)
    for (int i = 0; i < per_side; ++i)
      positions.emplace_back(Vector<2>(i + 0.5, j + 0.5) / per_side);
  return {.cells = {positions}, .row_height = 1.0 / per_side, .row_points = per_side};
}

} // namespace settle::mpm
