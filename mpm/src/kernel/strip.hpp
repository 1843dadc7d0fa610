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

/// Sums of eight cells with four points each, from the point of the block on that `block` is at.
template <int count, std::size_t pitch>
SETTLE_INLINE void add_up_fours(const double* block, double* cells, std::size_t stride) {
  for (int k = 0; k < count; ++k, block += pitch, cells += stride) {
#ifdef __AVX512F__
    typedef std::int64_t Order __attribute__((vector_size(64)));
    const auto pairs = [](const Lanes& a, const Lanes& b) {
      return __builtin_shuffle(a, b, Order{0, 2, 4, 6, 8, 10, 12, 14}) +
             __builtin_shuffle(a, b, Order{1, 3, 5, 7, 9, 11, 13, 15});
    };
    store(cells, pairs(pairs(load(block), load(block + 8)), pairs(load(block + 16), load(block + 24))));
#else
    for (int i = 0; i < n_lanes; ++i)
      cells[i] = (block[4 * i] + block[4 * i + 1]) + (block[4 * i + 2] + block[4 * i + 3]);
#endif
  }
}
/// Do eight cells have four points each?
SETTLE_INLINE bool are_fours(const std::uint32_t* begin) {
  bool fours = true;
  for (int i = 0; i < n_lanes; ++i)
    fours = fours && begin[i + 1] - begin[i] == 4;
  return fours;
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

/// Calls `action(cell, square, first, last)` for every cell of the strip with the range of its points; before that,
/// `take_fours(square, first)` for eight cells of a row with four points each, unless it says that it cannot.
template <int cells_per_square, class Action, class TakeFours>
SETTLE_INLINE void for_each_cell(const Step& step, const Strip& strip, Action&& action, TakeFours&& take_fours) {
  for (int row = strip.first_row; row < strip.last_row; ++row) {
    std::size_t square = static_cast<std::size_t>(row - strip.first_row) * static_cast<std::size_t>(step.node_columns);
    const std::uint32_t* begin = step.begin + static_cast<std::size_t>(cells_per_square) *
                                                  static_cast<std::size_t>(row) *
                                                  static_cast<std::size_t>(step.columns);
    for (int column = 0; column < step.columns;) {
      if (cells_per_square == 1 && column + n_lanes <= step.columns && are_fours(begin) &&
          take_fours(square, std::size_t{begin[0]})) {
        column += n_lanes, square += n_lanes, begin += n_lanes;
        continue;
      }
      for (int which = 0; which < cells_per_square; ++which, ++begin)
        action(which, square, std::size_t{begin[0]}, std::size_t{begin[1]});
      ++column, ++square;
    }
  }
}
template <int cells_per_square, class Action>
SETTLE_INLINE void for_each_cell(const Step& step, const Strip& strip, Action&& action) {
  for_each_cell<cells_per_square>(step, strip, action, [](std::size_t, std::size_t) { return false; });
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

/// A block of points that has been filled with quantities.
template <class Blocks>
struct Filled {
  std::size_t first = 0, last = 0;

  /// Makes it hold point p, `end` the last one that there is.
  template <class Fill>
  SETTLE_INLINE void reach(std::size_t p, std::size_t end, const PointArrays& points, Fill& fill) {
    if (p < last) return;
    first = p;
    last = end - first < Blocks::size ? end : first + Blocks::size;
    fill(points, first, static_cast<int>(last - first));
  }
};

/// Sums `count` quantities of points over their cells. `fill(points, first, n)` puts those of a block into `block`.
template <int cells_per_square, int count, class Blocks, class Fill>
SETTLE_INLINE void sum_over_cells(const Step& step, int index, double* block, const CellArrays& cells, Fill&& fill) {
  const Strip strip(step, index);
  const auto last_cell = static_cast<std::size_t>(cells_per_square) * static_cast<std::size_t>(strip.last_row) *
                         static_cast<std::size_t>(step.columns);
  const std::size_t end = step.begin[last_cell];
  Filled<Blocks> filled;
  const auto add = [&](const PointArrays& points, std::size_t end_of_points, bool begins) {
    return [&, end_of_points, begins](int which, std::size_t square, std::size_t p, std::size_t last) {
      double* sums = cells.quantity(which * count) + square;
      bool first_part = begins;
      if (p == last)
        for (int k = 0; k < count; ++k)
          sums[static_cast<std::size_t>(k) * cells.stride] = 0.0;
      while (p < last) {
        filled.reach(p, end_of_points, points, fill);
        const std::size_t until = last < filled.last ? last : filled.last;
        add_up_all<count, Blocks::pitch>(block, static_cast<int>(p - filled.first),
                                         static_cast<int>(until - filled.first), sums, cells.stride, first_part);
        first_part = false;
        p = until;
      }
    };
  };
  for_each_cell<cells_per_square>(step, strip, add(step.points, end, true), [&](std::size_t square, std::size_t p) {
    filled.reach(p, end, step.points, fill);
    if (p + 4 * n_lanes > filled.last) return false;
    add_up_fours<count, Blocks::pitch>(block + (p - filled.first), cells.quantity(0) + square, cells.stride);
    return true;
  });
  filled = {};
  const Strays& strays = step.strays[index];
  for_each_cell_of_strays<cells_per_square>(step, index, add(strays.points, strays.count, false));
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
