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
  double surface;                         ///< in the mean over the rows [m]
  double gap;                             ///< up to the designed surface; negative above it [m]
  const DesignColumn* parallel = nullptr; ///< of what is drawn
};

/// Of what is drawn: nothing is missing where nothing is designed.
Stack stack_below(const DesignColumn& design, int layer, int column, double height) {
  const double covered = design.covered();
  if (covered == 0.0) return {layer, column, height, 0.0, &design};
  const double gap = (design.level - height) / covered;
  return {layer, column, design.mean_top() - gap, gap, &design};
}

/// Over all columns of squares.
template <class Space>
std::vector<Stack> stacks_of(const Body<Space>& body, const Refill& refill) {
  std::vector<Stack> stacks;
  const auto next = [&stacks] { return static_cast<int>(stacks.size()); };
  if (!refill.columns.empty()) {
    const auto heights = extended_column_heights(body);
    for (const DesignColumn& design : refill.columns)
      stacks.push_back(stack_below(design, refill.layer, next(), heights[stacks.size()]));
    return stacks;
  }
  for (const double height : column_heights(body))
    stacks.push_back({refill.layer, next(), height, refill.design_level - height});
  return stacks;
}

template <class Space>
void add_rows(Body<Space>& body, const Stack& stack, int full_rows, double rest = 0.0) {
  const double height = refill_row_height(body);
  const auto add = [&](double top, double row) {
    refill_row(body,
               {.layer = stack.layer, .column = stack.column, .top = top, .height = row, .parallel = stack.parallel});
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
  const double row = refill_row_height(body);
  for (const Stack& stack : stacks_of(body, refill))
    add_rows(body, stack, rows_due(stack.gap / row, refill));
  return sort_in(body, before);
}

template <class Space>
int close_gap(Body<Space>& body, const Refill& refill) {
  if (!refill.rule) return 0;
  if (*refill.rule == exchange::RefillRule::element) return refill_empty_cells(body, refill);
  const auto before = body.points.size();
  const double row = refill_row_height(body);
  for (const Stack& stack : stacks_of(body, refill)) {
    const double gap = std::max(0.0, stack.gap);
    const int full_rows = static_cast<int>(std::floor(gap / row));
    add_rows(body, stack, full_rows, gap - full_rows * row);
  }
  return sort_in(body, before);
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template bool refill_may_be_due(const Body<Space>&, const Refill&, const std::vector<double>&);                      \
  template int refill_where_due(Body<Space>&, const Refill&);                                                          \
  template int close_gap(Body<Space>&, const Refill&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
