#include "settle/mpm/refill.hpp"

#include <algorithm>
#include <cmath>

#include "settle/mpm/placement.hpp"

namespace settle::mpm {

namespace {

/// A gap below this share of a row's height is left open: the error it leaves is far below that of the grid.
constexpr double negligible_gap = 5e-3;

int sort_in(Body<TriangleGrid>& body, std::size_t size_before) {
  const auto added = static_cast<int>(body.points.size() - size_before);
  if (added > 0) body.sort();
  return added;
}

int refill_empty_cells(Body<TriangleGrid>& body, const Refill& refill) {
  const auto before = body.points.size();
  const auto row_at = [&](double level) { return static_cast<int>(std::lround(level / body.grid.size())); };
  const int first = 2 * body.grid.columns() * row_at(refill.lower_level);
  const int last = 2 * body.grid.columns() * row_at(refill.design_level);
  for (int cell = first; cell < last; ++cell)
    if (body.cells.is_empty(cell)) refill_cell(body, cell, refill.layer);
  return sort_in(body, before);
}

/// Rows stacked downwards from the design level in one column of squares.
void add_rows(Body<TriangleGrid>& body, const Refill& refill, int column, int full_rows, double rest = 0.0) {
  const double height = refill_row_height(body.grid);
  for (int k = 0; k < full_rows; ++k)
    refill_row(body,
               {.layer = refill.layer, .column = column, .top = refill.design_level - k * height, .height = height});
  if (rest > negligible_gap * height)
    refill_row(
        body,
        {.layer = refill.layer, .column = column, .top = refill.design_level - full_rows * height, .height = rest});
}

} // namespace

int refill_where_due(Body<TriangleGrid>& body, const Refill& refill) {
  if (!refill.rule) return 0;
  if (*refill.rule == exchange::RefillRule::element) return refill_empty_cells(body, refill);
  const auto before = body.points.size();
  const auto heights = column_heights(body);
  for (int column = 0; column < body.grid.columns(); ++column) {
    const double gap = refill.design_level - heights[static_cast<std::size_t>(column)];
    add_rows(body, refill, column, static_cast<int>(std::ceil(gap / refill_row_height(body.grid) - 0.5)));
  }
  return sort_in(body, before);
}

int close_gap(Body<TriangleGrid>& body, const Refill& refill) {
  if (!refill.rule) return 0;
  if (*refill.rule == exchange::RefillRule::element) return refill_empty_cells(body, refill);
  const auto before = body.points.size();
  const double row = refill_row_height(body.grid);
  const auto heights = column_heights(body);
  for (int column = 0; column < body.grid.columns(); ++column) {
    const double gap = std::max(0.0, refill.design_level - heights[static_cast<std::size_t>(column)]);
    const int full_rows = static_cast<int>(std::floor(gap / row));
    add_rows(body, refill, column, full_rows, gap - full_rows * row);
  }
  return sort_in(body, before);
}

} // namespace settle::mpm
