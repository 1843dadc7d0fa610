/// \file
/// Strips, their points in blocks, and what goes between the points of a cell and the cell.
#pragma once

#include "lanes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Rows of squares first ... last - 1, and the nodes at their lower left.
struct Strip {
  int first_row, last_row;
  std::size_t n_squares; ///< those that do not exist included

  Strip(const Step& step, int strip)
      : first_row(strip * step.strip_rows), last_row(least(step.rows, first_row + step.strip_rows)),
        n_squares(static_cast<std::size_t>(last_row - first_row) * static_cast<std::size_t>(step.node_columns)) {}
  [[nodiscard]] std::size_t first_node(const Step& step) const {
    return static_cast<std::size_t>(first_row) * static_cast<std::size_t>(step.node_columns);
  }
};

/// Quantity k of a square is at `quantity(k)[square]`, zero for squares before the first and after the last.
struct CellArrays {
  double* base;
  std::size_t stride;

  CellArrays(const Step& step, double* cells) : base(cells + step.margin), stride(step.stride) {}
  SETTLE_INLINE double* quantity(int k) const { return base + static_cast<std::size_t>(k) * stride; }
  /// Those behind the first k.
  [[nodiscard]] CellArrays after(int k) const {
    CellArrays rest = *this;
    rest.base += static_cast<std::size_t>(k) * stride;
    return rest;
  }
};

/// `count` quantities of a block of `size` points: quantity k of point q at [k * pitch + q].
template <int points>
struct Block {
  static constexpr int size = points;
  static constexpr std::size_t pitch = points + n_lanes;
};

/// Adds up quantities k ... k + n - 1 of the points q0 ... q1 - 1 of a cell.
template <int n, std::size_t pitch>
SETTLE_INLINE void add_up(const double* block, int q0, int q1, double* cell, std::size_t stride, bool begins) {
  double sums[n];
#pragma GCC unroll 8
  for (int k = 0; k < n; ++k)
    sums[k] = begins ? 0.0 : cell[static_cast<std::size_t>(k) * stride];
  for (int q = q0; q < q1; ++q) {
#pragma GCC unroll 8
    for (int k = 0; k < n; ++k)
      sums[k] += block[static_cast<std::size_t>(k) * pitch + static_cast<std::size_t>(q)];
  }
#pragma GCC unroll 8
  for (int k = 0; k < n; ++k)
    cell[static_cast<std::size_t>(k) * stride] = sums[k];
}
template <int count, std::size_t pitch>
SETTLE_INLINE void add_up_all(const double* block, int q0, int q1, double* cell, std::size_t stride, bool begins) {
  if constexpr (count > n_lanes) {
    add_up<n_lanes, pitch>(block, q0, q1, cell, stride, begins);
    add_up_all<count - n_lanes, pitch>(block + n_lanes * pitch, q0, q1, cell + n_lanes * stride, stride, begins);
  } else {
    add_up<count, pitch>(block, q0, q1, cell, stride, begins);
  }
}

/// Gives `count` quantities of a cell to its points q0 ... q1 - 1, and to some after them.
template <int count, std::size_t pitch>
SETTLE_INLINE void spread(const double* cell, std::size_t stride, double* block, int q0, int q1) {
  if (q1 - q0 <= n_lanes / 2) { // most cells hold no more: narrow stores straddle fewer cache lines
#pragma GCC unroll 64
    for (int k = 0; k < count; ++k) {
      const double v = cell[static_cast<std::size_t>(k) * stride];
      const HalfLanes value{v, v, v, v};
      __builtin_memcpy(block + static_cast<std::size_t>(k) * pitch + q0, &value, sizeof value);
    }
    return;
  }
  for (int k = 0; k < count; ++k) {
    const Lanes value = all(cell[static_cast<std::size_t>(k) * stride]);
    double* to = block + static_cast<std::size_t>(k) * pitch;
    for (int q = q0; q < q1; q += n_lanes)
      store(to + q, value);
  }
}

/// Calls `action(cell, square, first, last)` for every cell of the strip with the range of its points.
template <int cells_per_square, class Action>
SETTLE_INLINE void for_each_cell(const Step& step, const Strip& strip, Action&& action) {
  for (int row = strip.first_row; row < strip.last_row; ++row) {
    std::size_t square = static_cast<std::size_t>(row - strip.first_row) * static_cast<std::size_t>(step.node_columns);
    const std::uint32_t* begin = step.begin + static_cast<std::size_t>(cells_per_square) *
                                                  static_cast<std::size_t>(row) *
                                                  static_cast<std::size_t>(step.columns);
    for (int column = 0; column < step.columns; ++column, ++square)
      for (int which = 0; which < cells_per_square; ++which, ++begin)
        action(which, square, std::size_t{begin[0]}, std::size_t{begin[1]});
  }
}

/// The same for its strays, with ranges of these; not for cells without any.
template <int cells_per_square, class Action>
SETTLE_INLINE void for_each_cell_of_strays(const Step& step, int strip, Action&& action) {
  const Strays& strays = step.strays[strip];
  for (std::size_t first = 0; first < strays.count;) {
    const std::int32_t cell = strays.cell[first];
    std::size_t last = first + 1;
    while (last < strays.count && strays.cell[last] == cell)
      ++last;
    const int square = cell / cells_per_square, row = square / step.columns - strip * step.strip_rows;
    action(cell % cells_per_square, static_cast<std::size_t>(row * step.node_columns + square % step.columns), first,
           last);
    first = last;
  }
}

/// Sums `count` quantities of points over their cells. `fill(points, first, n)` puts those of a block into `block`.
template <int cells_per_square, int count, class Blocks, class Fill>
SETTLE_INLINE void sum_over_cells(const Step& step, int index, double* block, const CellArrays& cells, Fill&& fill) {
  const Strip strip(step, index);
  const auto add = [&](const PointArrays& points, std::size_t end, bool strays) {
    return [&, end, strays, block_first = std::size_t{0},
            block_last = std::size_t{0}](int which, std::size_t square, std::size_t first, std::size_t last) mutable {
      double* sums = cells.quantity(which * count) + square;
      bool begins = !strays;
      if (first == last)
        for (int k = 0; k < count; ++k)
          sums[static_cast<std::size_t>(k) * cells.stride] = 0.0;
      while (first < last) {
        if (first >= block_last) {
          block_first = first;
          block_last = end - first < Blocks::size ? end : first + Blocks::size;
          fill(points, block_first, static_cast<int>(block_last - block_first));
        }
        const std::size_t until = last < block_last ? last : block_last;
        add_up_all<count, Blocks::pitch>(block, static_cast<int>(first - block_first),
                                         static_cast<int>(until - block_first), sums, cells.stride, begins);
        begins = false;
        first = until;
      }
    };
  };
  const auto last_cell = static_cast<std::size_t>(cells_per_square) * static_cast<std::size_t>(strip.last_row) *
                         static_cast<std::size_t>(step.columns);
  for_each_cell<cells_per_square>(step, strip, add(step.points, step.begin[last_cell], false));
  for_each_cell_of_strays<cells_per_square>(step, index,
                                            add(step.strays[index].points, step.strays[index].count, true));
}

/// Gives `count` quantities of the cells to their points; `use(points, first, n, strays)` takes those of a block.
template <int cells_per_square, int count, class Blocks, class Use>
SETTLE_INLINE void spread_over_points(const Step& step, int index, double* block, const CellArrays& cells, Use&& use) {
  const Strip strip(step, index);
  std::size_t block_first = 0;
  int filled = 0;
  const auto spread_cell = [&](const PointArrays& points, bool strays) {
    return [&, strays](int which, std::size_t square, std::size_t first, std::size_t last) {
      while (first < last) {
        if (filled == 0) block_first = first;
        const int room = Blocks::size - filled;
        const int taken = last - first < static_cast<std::size_t>(room) ? static_cast<int>(last - first) : room;
        spread<count, Blocks::pitch>(cells.quantity(which * count) + square, cells.stride, block, filled,
                                     filled + taken);
        filled += taken;
        first += static_cast<std::size_t>(taken);
        if (filled < Blocks::size) continue;
        use(points, block_first, filled, strays);
        filled = 0;
      }
    };
  };
  for_each_cell<cells_per_square>(step, strip, spread_cell(step.points, false));
  if (filled > 0) use(step.points, block_first, filled, false);
  filled = 0;
  for_each_cell_of_strays<cells_per_square>(step, index, spread_cell(step.strays[index].points, true));
  if (filled > 0) use(step.strays[index].points, block_first, filled, true);
}

/// Gravity on points q ... of a block, all of them [m/s2].
SETTLE_INLINE Lanes gravity_on(const Step& step, const std::int32_t* layer, int count) {
  Lanes gravity = all(0.0);
  for (int i = 0; i < least(count, n_lanes); ++i)
    gravity[i] = layer[i] == step.ramped_layer ? step.ramped_gravity : step.gravity;
  return gravity;
}

/// Zeroes what an earlier strip left behind the last square of a shorter one.
SETTLE_INLINE void clear_behind(const Step& step, const Strip& strip, const CellArrays& cells, int count) {
  if (strip.last_row - strip.first_row == step.strip_rows) return;
  const std::size_t end = strip.n_squares +
                          static_cast<std::size_t>(step.overlap) * static_cast<std::size_t>(step.node_columns + 1) +
                          n_lanes;
  const std::size_t whole = static_cast<std::size_t>(step.strip_rows) * static_cast<std::size_t>(step.node_columns);
  for (int k = 0; k < count; ++k)
    for (std::size_t s = strip.n_squares; s < (end < whole ? end : whole); ++s)
      cells.quantity(k)[s] = 0.0;
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
