/// \file
/// Points in blocks, and their sums over cells.
#pragma once

#include "point_values.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

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

/// Do `n` cells have so many points each?
SETTLE_INLINE bool are_even(const std::uint32_t* begin, int n, int each) {
  bool even = true;
  for (int i = 0; i < n; ++i)
    even = even && begin[i + 1] - begin[i] == static_cast<std::uint32_t>(each);
  return even;
}

/// What the points of cells have to say, summed over each cell. `Kind` knows what that is:
/// - `per_square` cells of a square, `points` that most of them hold, `count` quantities of a point,
/// - `products<n>(step, values, first, put)` puts the quantities of points, one after the other, each summed over the
///   slots first ... first + n - 1.
template <class Kind, int dim, Weight weight>
struct CellSums {
  using Block = typename Kind::SumBlock;
  static constexpr int per_square = Kind::per_square, count = Kind::count, each = Kind::points;

  /// The points first ... last - 1 are in the block.
  struct Filled {
    std::size_t first = 0, last = 0;

    /// Makes it hold point p, `end` the last one that is wanted.
    SETTLE_INLINE void reach(const Step& step, std::size_t p, std::size_t end, const PointArrays& points,
                             double* block) {
      if (p < last) return;
      first = p;
      last = end - first < Block::size ? end : first + Block::size;
      for (std::size_t q = 0; q < last - first; q += n_lanes) {
        PointValues<dim, weight, 1> values;
        values.read(step, points, first + q, static_cast<int>(last - first - q));
        double* to = block + q;
        Kind::template products<1>(step, values, 0, [&](const Lanes& lanes) { store(to, lanes), to += Block::pitch; });
      }
    }
  };

  /// Sums of the eight squares from `square` on, whose points begin with p: `each` in every cell.
  SETTLE_INLINE static void add_eight(const Step& step, const CellArrays& cells, std::size_t square, std::size_t p) {
    PointValues<dim, weight, per_square * each> values;
    values.read_squares(step, step.points, p);
    for (int which = 0; which < per_square; ++which) {
      double* to = cells.quantity(which * count) + square;
      Kind::template products<each>(step, values, each * which,
                                    [&](const Lanes& sum) { store(to, sum), to += cells.stride; });
    }
  }

  /// Adds the points p ... last - 1 of a cell of a square, `end` the last one that is wanted for the block.
  SETTLE_INLINE static void add_cell(const Step& step, const PointArrays& points, Filled& filled, double* block,
                                     const CellArrays& cells, int which, std::size_t square, std::size_t p,
                                     std::size_t last, std::size_t end, bool begins) {
    double* sums = cells.quantity(which * count) + square;
    if (begins && p == last)
      for (int k = 0; k < count; ++k)
        sums[static_cast<std::size_t>(k) * cells.stride] = 0.0;
    while (p < last) {
      filled.reach(step, p, end, points, block);
      const std::size_t until = last < filled.last ? last : filled.last;
      add_up_all<count, Block::pitch>(block, static_cast<int>(p - filled.first), static_cast<int>(until - filled.first),
                                      sums, cells.stride, begins);
      begins = false;
      p = until;
    }
  }

  /// The squares of a line, `number` that of the first in the grid: eight at a time where they are as most are.
  SETTLE_INLINE static void add_line(const Step& step, Filled& filled, double* block, const CellArrays& cells,
                                     std::size_t square, std::size_t number, int columns, std::size_t end_of_tile) {
    const std::uint32_t* begin = step.begin + static_cast<std::size_t>(per_square) * number;
    for (int column = 0; column < columns;) {
      const int some = least(n_lanes, columns - column), some_cells = per_square * some;
      if (some == n_lanes && are_even(begin, some_cells, each)) {
        add_eight(step, cells, square, std::size_t{begin[0]});
        begin += some_cells;
      } else {
        const std::size_t end = columns < n_lanes ? end_of_tile : std::size_t{begin[some_cells]};
        for (int i = 0; i < some_cells; ++i, ++begin)
          add_cell(step, step.points, filled, block, cells, i % per_square,
                   square + static_cast<std::size_t>(i / per_square), std::size_t{begin[0]}, std::size_t{begin[1]}, end,
                   true);
      }
      column += some, square += static_cast<std::size_t>(some);
    }
  }

  /// Over all cells of a tile; squares that do not exist are cleared.
  SETTLE_INLINE static void add_tile(const Step& step, const Tile& tile, double* block, const CellArrays& cells) {
    const std::size_t end = tile.end_of_points(step, per_square);
    Filled filled;
    for_each_line(
        step, tile,
        [&](std::size_t square, std::size_t number) {
          add_line(step, filled, block, cells, square, number, tile.columns, end);
        },
        [&](std::size_t first) {
          cells.clear(per_square * count, first, first + static_cast<std::size_t>(tile.width));
        });
    filled = {};
    const Strays& strays = step.strays[tile.index];
    for_each_cell_of_strays<per_square>(
        step, tile, [&](int which, std::size_t square, std::size_t first, std::size_t last) {
          add_cell(step, strays.points, filled, block, cells, which, square, first, last, strays.count, false);
        });
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
