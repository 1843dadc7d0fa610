#include "load_carriers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

template <class Space>
std::vector<int> cells_of_carriers(const exchange::Case& study, const Body<Space>& body) {
  std::vector<int> cells(body.points.cell.begin(), body.points.cell.end());
  if constexpr (Space::dim == 3)
    if (!study.geometry.varies_along_y())
      for (int& cell : cells) {
        auto square = body.space.squares().index(cell / Space::cells_per_square);
        square[1] = 0;
        cell = body.space.squares().number(square);
      }
  return cells;
}

LoadCarriers::LoadCarriers(Scattered points, const std::vector<int>& cells, double size)
    : points_(std::move(points)), size_(size) {
  for (std::size_t i = 0; i < points_.points.size(); ++i) {
    cells_.push_back(cells[points_.points[i]]);
    Scattered& cell = by_cell_[cells_.back()];
    cell.points.push_back(points_.points[i]);
    cell.places.push_back(points_.places[i]);
    bins_[bin_of(points_.places[i])].push_back(i);
  }
}

const Scattered& LoadCarriers::near(const Place& place) const {
  return by_cell_.at(cells_[nearest(place)]);
}

auto LoadCarriers::bin_of(const Place& place) const -> Bin {
  const auto index = [&](int d) { return static_cast<int>(std::floor(place[d] / size_)); };
  return {index(0), index(1), index(2)};
}

/// Ring by ring of bins, until no other one can hold a nearer point. Of equal ones the first.
std::size_t LoadCarriers::nearest(const Place& place) const {
  const Bin middle = bin_of(place);
  auto best = std::pair(std::numeric_limits<double>::infinity(), std::size_t{0});
  for (int ring = 0; !(std::sqrt(best.first) < (ring - 1) * size_); ++ring)
    for (int i = -ring; i <= ring; ++i)
      for (int j = -ring; j <= ring; ++j)
        for (int k = -ring; k <= ring; ++k) {
          if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != ring) continue;
          const auto bin = bins_.find({middle[0] + i, middle[1] + j, middle[2] + k});
          if (bin == bins_.end()) continue;
          for (const std::size_t point : bin->second)
            best = std::min(best, std::pair((points_.places[point] - place).squaredNorm(), point));
        }
  return best.second;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template std::vector<int> cells_of_carriers(const exchange::Case&, const Body<Space>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
