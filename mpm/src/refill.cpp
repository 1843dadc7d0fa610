#include "settle/mpm/refill.hpp"

#include <algorithm>
#include <cmath>

#include "settle/mpm/placement.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// A gap below this share of a row's height is left open: the error it leaves is far below that of the grid.
constexpr double negligible_gap = 5e-3;

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
    return static_cast<int>(std::lround((level - body.space.origin()[1]) / body.space.size()));
  };
  const int first = Space::cells_per_square * body.space.columns() * row_at(refill.lower_level);
  const int last = Space::cells_per_square * body.space.columns() * row_at(refill.design_level);
  for (int cell = first; cell < last; ++cell)
    if (body.cells.is_empty(cell)) refill_cell(body, cell, refill.layer);
  return sort_in(body, before);
}

/// Rows stacked downwards from the design level in one column of squares.
template <class Space>
void add_rows(Body<Space>& body, const Refill& refill, int column, int full_rows, double rest = 0.0) {
  const double height = refill_row_height(body);
  for (int k = 0; k < full_rows; ++k)
    refill_row(body,
               {.layer = refill.layer, .column = column, .top = refill.design_level - k * height, .height = height});
  if (rest > negligible_gap * height)
    refill_row(
        body,
        {.layer = refill.layer, .column = column, .top = refill.design_level - full_rows * height, .height = rest});
}

} // namespace

template <class Space>
int refill_where_due(Body<Space>& body, const Refill& refill) {
  if (!refill.rule) return 0;
  if (*refill.rule == exchange::RefillRule::element) return refill_empty_cells(body, refill);
  const auto before = body.points.size();
  const auto heights = column_heights(body);
  for (int column = 0; column < body.space.columns(); ++column) {
    const double gap = refill.design_level - heights[static_cast<std::size_t>(column)];
    add_rows(body, refill, column, static_cast<int>(std::ceil(gap / refill_row_height(body) - 0.5)));
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
    const double gap = std::max(0.0, refill.design_level - heights[static_cast<std::size_t>(column)]);
    const int full_rows = static_cast<int>(std::floor(gap / row));
    add_rows(body, refill, column, full_rows, gap - full_rows * row);
  }
  return sort_in(body, before);
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template int refill_where_due(Body<Space>&, const Refill&);                                                          \
  template int close_gap(Body<Space>&, const Refill&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
