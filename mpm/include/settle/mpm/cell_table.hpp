/// \file
/// Which points are in which cell.
#pragma once

#include <cstdint>
#include <vector>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Ranges of the sorted points by cell.
struct CellTable {
  std::vector<std::uint32_t> begin;   ///< (cells + 1): the points of cell c are begin[c] ... begin[c + 1] - 1
  std::vector<std::int32_t> occupied; ///< cells with at least one point, in ascending order
  std::uint64_t sorts = 0;            ///< how often points have changed their places

  /// In any of the cells first ... last - 1?
  [[nodiscard]] bool has_points(int first, int last) const {
    return begin[static_cast<std::size_t>(first)] != begin[static_cast<std::size_t>(last)];
  }
  [[nodiscard]] bool is_empty(int cell) const { return !has_points(cell, cell + 1); }
};

/// Fills the table, but for `sorts`, in from the cells of the points in any order. Returns the order by cell: the point
/// to be at place i is now at place order[i] (counting sort, stable).
std::vector<std::uint32_t> order_by_cell(const std::vector<std::int32_t>& cells, std::size_t n_cells, CellTable& table);

/// Finds the cell of every point and, where a point is new, gone or has changed its cell, sorts the points by cell: the
/// same points give the same order. Throws PointLost.
template <class Space>
void sort_by_cell(const Space& space, Points<Space::dim>& points, CellTable& table);

} // namespace settle::mpm
