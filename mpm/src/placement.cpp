#include "settle/mpm/placement.hpp"

#include <algorithm>
#include <cmath>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// The box that a square's points fill: the square itself, or a slice of a layer of another height.
struct Box {
  Vector<2> corner;
  Vector<2> size;
};

/// What a new point has besides its place.
struct Origin {
  int layer = 1;
  bool refilled = false;
};

/// Places the points of the `which`-th cell of a square.
template <class Space>
void fill_cell(Body<Space>& body, const Box& box, std::size_t which, const Origin& origin) {
  const double volume = box.size.prod() / static_cast<double>(body.layout.points_per_square());
  for (const Vector<2>& local : body.layout.cells[which])
    body.points.add({.layer = origin.layer,
                     .refilled = origin.refilled,
                     .position = box.corner + local.cwiseProduct(box.size),
                     .volume = volume,
                     .density = body.density,
                     .half_lengths = box.size / (2.0 * body.layout.row_points)});
}

} // namespace

template <class Space>
void place_layer(Body<Space>& body, const LayerPlacement& placement) {
  const double size = body.space.size();
  const int rows = std::max(1, static_cast<int>(std::lround(placement.thickness / size)));
  const double height = placement.thickness / rows;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < body.space.columns(); ++column) {
      const double left = body.space.corner(column, 0)[0];
      for (std::size_t which = 0; which < body.layout.cells.size(); ++which)
        fill_cell(body, {{left, placement.base + row * height}, {size, height}}, which, {.layer = placement.layer});
    }
}

template <class Space>
void refill_cell(Body<Space>& body, int cell, int layer) {
  const auto& space = body.space;
  const Box square{space.corner(space.column_of(cell), space.row_of(cell)), Vector<2>::Constant(space.size())};
  fill_cell(body, square, static_cast<std::size_t>(cell % Space::cells_per_square), {.layer = layer, .refilled = true});
}

template <class Space>
double refill_row_height(const Body<Space>& body) {
  return body.layout.row_height * body.space.size();
}

template <class Space>
void refill_row(Body<Space>& body, const RefillRow& row) {
  const int count = body.layout.row_points;
  const double spacing = body.space.size() / count, left = body.space.corner(row.column, 0)[0];
  for (int i = 0; i < count; ++i)
    body.points.add({.layer = row.layer,
                     .refilled = true,
                     .position = {left + (i + 0.5) * spacing, row.top - 0.5 * row.height},
                     .volume = spacing * row.height,
                     .density = body.density,
                     .half_lengths = {0.5 * spacing, 0.5 * row.height}});
}

template <class Space>
std::vector<double> column_heights(const Body<Space>& body) {
  std::vector<double> heights(static_cast<std::size_t>(body.space.columns()), 0.0);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    heights[static_cast<std::size_t>(body.space.column_of(body.points.cell[p]))] += body.points.volume[p];
  for (double& height : heights)
    height = body.space.origin()[1] + height / body.space.size();
  return heights;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template void place_layer(Body<Space>&, const LayerPlacement&);                                                      \
  template void refill_cell(Body<Space>&, int, int);                                                                   \
  template double refill_row_height(const Body<Space>&);                                                               \
  template void refill_row(Body<Space>&, const RefillRow&);                                                            \
  template std::vector<double> column_heights(const Body<Space>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
