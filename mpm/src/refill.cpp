#include "settle/mpm/refill.hpp"

#include <algorithm>
#include <cmath>

#include "settle/mpm/placement.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// A gap below this share of a row's height is left open: the error it leaves is far below that of the grid.
constexpr double negligible_gap = 5e-3;
/// Of a row: by how much heights summed in another order may differ.
constexpr double round_off = 1e-9;

template <class Space>
int sort_in(Body<Space>& body, std::size_t size_before) {
  const auto added = static_cast<int>(body.points.size() - size_before);
  if (added > 0) body.sort();
  return added;
}

template <class Space>
int refill_empty_cells(Body<Space>& body, const Refill& refill) {
  const auto before = body.points.size();
  const auto row_at = [&](double level) {
    return static_cast<int>(std::lround((level - body.space.origin()[Space::dim - 1]) / body.space.size()));
  };
  const int first = Space::cells_per_square * body.space.columns() * row_at(refill.lower_level);
  const int last = Space::cells_per_square * body.space.columns() * row_at(refill.design_level);
  for (int cell = first; cell < last; ++cell)
    if (body.cells.is_empty(cell)) refill_cell(body, cell, refill.layer);
  return sort_in(body, before);
}

/// How many rows a gap gets before the stage is over, `gap` in rows. None may stand above the design level where the
/// next layer is placed on it: points that overlap share the load of their place.
int rows_due(double gap, const Refill& refill) {
  return static_cast<int>(std::max(0.0, refill.ends_closed ? std::floor(gap) : std::ceil(gap - 0.5)));
}

/// Where rows are stacked: on the surface of a column of squares, so that they touch the points below and overlap none.
struct Stack {
  int layer;
  int column;
  double surface; ///< [m]
};

template <class Space>
void add_rows(Body<Space>& body, const Stack& stack, int full_rows, double rest = 0.0) {
  const double height = refill_row_height(body);
  const auto add = [&](double top, double row) {
    refill_row(body, {.layer = stack.layer, .column = stack.column, .top = top, .height = row});
  };
  for (int k = 1; k <= full_rows; ++k)
    add(stack.surface + k * height, height);
  if (rest > negligible_gap * height) add(stack.surface + full_rows * height + rest, rest);
}

} // namespace

template <class Space>
bool refill_may_be_due(const Body<Space>& body, const Refill& refill, const std::vector<double>& heights) {
  if (!refill.rule) return false;
  if (*refill.rule == exchange::RefillRule::element) return true;
  const double row = refill_row_height(body);
  return std::any_of(heights.begin(), heights.end(), [&](double surface) {
    return rows_due((refill.design_level - surface) / row + round_off, refill) > 0;
  });
}

template <class Space>
int refill_where_due(Body<Space>& body, const Refill& refill) {
  if (!refill.rule) return 0;
  if (*refill.rule == exchange::RefillRule::element) return refill_empty_cells(body, refill);
  const auto before = body.points.size();
  const auto heights = column_heights(body);
  for (int column = 0; column < body.space.columns(); ++column) {
    const double surface = heights[static_cast<std::size_t>(column)], gap = refill.design_level - surface;
    add_rows(body, {refill.layer, column, surface}, rows_due(gap / refill_row_height(body), refill));
  }
  return sort_in(body, before);
}

template <class Space>
int close_gap(Body<Space>& body, const Refill& refill) {
  if (!refill.rule) return 0;
  if (*refill.rule == exchange::RefillRule::element) return refill_empty_cells(body, refill);
  const auto before = body.points.size();
  const double row = refill_row_height(body);
  const auto heights = column_heights(body);
  for (int column = 0; column < body.space.columns(); ++column) {
    const double surface = heights[static_cast<std::size_t>(column)];
    const double gap = std::max(0.0, refill.design_level - surface);
    const int full_rows = static_cast<int>(std::floor(gap / row));
    add_rows(body, {refill.layer, column, surface}, full_rows, gap - full_rows * row);
  }
  return sort_in(body, before);
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template bool refill_may_be_due(const Body<Space>&, const Refill&, const std::vector<double>&);                      \
  template int refill_where_due(Body<Space>&, const Refill&);                                                          \
  template int close_gap(Body<Space>&, const Refill&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
