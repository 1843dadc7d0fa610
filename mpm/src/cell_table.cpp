#include "settle/mpm/cell_table.hpp"

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// Writes every point's cell; true if any is not where the table has it.
template <class Space>
bool locate_all(const Space& space, Points<Space::dim>& points) {
  bool changed = false;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto x = points.position_of(p);
    const std::int32_t cell = space.locate(x);
    if (cell < 0) throw PointLost(points.id[p], x, space.box());
    changed = changed || cell != points.cell[p];
    points.cell[p] = cell;
  }
  return changed;
}

void count(const std::vector<std::int32_t>& cells, std::size_t n_cells, CellTable& table) {
  table.begin.assign(n_cells + 1, 0);
  for (const std::int32_t cell : cells)
    ++table.begin[static_cast<std::size_t>(cell) + 1];
  table.occupied.clear();
  for (std::size_t c = 0; c < n_cells; ++c) {
    if (table.begin[c + 1] > 0) table.occupied.push_back(static_cast<std::int32_t>(c));
    table.begin[c + 1] += table.begin[c];
  }
}

} // namespace

std::vector<std::uint32_t> order_by_cell(const std::vector<std::int32_t>& cells, std::size_t n_cells,
                                         CellTable& table) {
  count(cells, n_cells, table);
  std::vector<std::uint32_t> next(table.begin.begin(), table.begin.end() - 1);
  std::vector<std::uint32_t> order(cells.size());
  for (std::uint32_t p = 0; p < order.size(); ++p)
    order[next[static_cast<std::size_t>(cells[p])]++] = p;
  return order;
}

template <class Space>
void sort_by_cell(const Space& space, Points<Space::dim>& points, CellTable& table) {
  const bool moved = locate_all(space, points);
  if (!moved && !table.begin.empty() && table.begin.back() == points.size()) return;
  points.permute(order_by_cell(points.cell, static_cast<std::size_t>(space.n_cells()), table));
  ++table.sorts;
}

#define SETTLE_INSTANTIATE(Space) template void sort_by_cell(const Space&, Points<Space::dim>&, CellTable&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
