#include "settle/mpm/placement.hpp"

#include <algorithm>
#include <cmath>

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// The box that a square's points fill: the square itself, or a slice of a layer of another height.
template <int dim>
struct Box {
  Vector<dim> corner;
  Vector<dim> size;
};

/// What a new point has besides its place.
struct Origin {
  int layer = 1;
  bool refilled = false;
};

/// Places the points of the `which`-th cell of a square.
template <class Space>
void fill_cell(Body<Space>& body, const Box<Space::dim>& box, std::size_t which, const Origin& origin) {
  const double volume = box.size.prod() / static_cast<double>(body.layout.points_per_square());
  for (const Vector<Space::dim>& local : body.layout.cells[which])
    body.points.add({.layer = origin.layer,
                     .refilled = origin.refilled,
                     .position = box.corner + local.cwiseProduct(box.size),
                     .volume = volume,
                     .density = body.density_of(origin.layer),
                     .preconsolidation_pressure = body.preconsolidation_of(origin.layer),
                     .half_lengths = box.size / (2.0 * body.layout.row_points)});
}

} // namespace

template <class Space>
void place_layer(Body<Space>& body, const LayerPlacement& placement) {
  constexpr int vertical = Space::dim - 1;
  const double size = body.space.size();
  const int rows = std::max(1, static_cast<int>(std::lround(placement.thickness / size)));
  const double height = placement.thickness / rows;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < body.space.columns(); ++column) {
      Box<Space::dim> box{body.space.corner(column, 0), Vector<Space::dim>::Constant(size)};
      box.corner[vertical] = placement.base + row * height;
      box.size[vertical] = height;
      for (std::size_t which = 0; which < body.layout.cells.size(); ++which)
        fill_cell(body, box, which, {.layer = placement.layer});
    }
}

template <int dim>
double remove_layer(Points<dim>& points, int layer) {
  std::vector<std::uint32_t> kept;
  double mass = 0;
  for (std::uint32_t p = 0; p < points.size(); ++p)
    if (points.layer[p] == layer)
      mass += points.mass[p];
    else
      kept.push_back(p);
  points.permute(kept);
  return mass;
}

template double remove_layer(Points<2>&, int);
template double remove_layer(Points<3>&, int);

template <class Space>
void refill_cell(Body<Space>& body, int cell, int layer) {
  const auto& space = body.space;
  const Box<Space::dim> square{space.corner(space.column_of(cell), space.row_of(cell)),
                               Vector<Space::dim>::Constant(space.size())};
  fill_cell(body, square, static_cast<std::size_t>(cell % Space::cells_per_square), {.layer = layer, .refilled = true});
}

template <class Space>
double refill_row_height(const Body<Space>& body) {
  return body.layout.row_height * body.space.size();
}

template <class Space>
void refill_row(Body<Space>& body, const RefillRow& row) {
  constexpr int dim = Space::dim;
  BoxNumbering<dim - 1> plan{};
  plan.counts.fill(body.layout.row_points);
  const double spacing = body.space.size() / body.layout.row_points;
  const Vector<dim> corner = body.space.corner(row.column, 0);
  Vector<dim> sides = Vector<dim>::Constant(spacing);
  sides[dim - 1] = row.height;
  const double mean_top = row.parallel != nullptr ? row.parallel->mean_top() : 0.0;
  for (int i = 0; i < plan.size(); ++i) {
    Vector<dim> position;
    for (std::size_t d = 0; d < dim - 1; ++d)
      position[static_cast<int>(d)] = corner[static_cast<int>(d)] + (plan.index(i)[d] + 0.5) * spacing;
    position[dim - 1] = row.top - 0.5 * row.height;
    if (row.parallel != nullptr) {
      const auto& strip = row.parallel->strips[static_cast<std::size_t>(i)];
      if (!strip) continue;
      position[dim - 1] = std::max(position[dim - 1] + (strip->top - mean_top), strip->foot + 0.5 * row.height);
    }
    body.points.add({.layer = row.layer,
                     .refilled = true,
                     .position = position,
                     .volume = sides.prod(),
                     .density = body.density_of(row.layer),
                     .preconsolidation_pressure = body.preconsolidation_of(row.layer),
                     .half_lengths = 0.5 * sides});
  }
}

template <class Space>
std::vector<double> column_heights(const Body<Space>& body) {
  std::vector<double> heights(static_cast<std::size_t>(body.space.columns()), 0.0);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    heights[static_cast<std::size_t>(body.space.column_of(body.points.cell[p]))] += body.points.volume[p];
  for (double& height : heights)
    height = body.space.origin()[Space::dim - 1] + height / body.space.column_area();
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
