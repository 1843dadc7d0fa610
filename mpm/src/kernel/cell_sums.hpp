/// \file
/// Points in blocks, and their sums over cells.
#pragma once

#include "tile.hpp"

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

/// Sums of eight cells with `each` points, a power of two, from the point of the block on that `block` is at: of
/// neighbours, then of the sums of neighbours.
template <int each, int count, std::size_t pitch>
SETTLE_INLINE void add_up_even(const double* block, double* cells, std::size_t stride) {
  for (int k = 0; k < count; ++k, block += pitch, cells += stride) {
#ifdef __AVX512F__
    typedef std::int64_t Order __attribute__((vector_size(64)));
    Lanes sums[each];
    for (int i = 0; i < each; ++i)
      sums[i] = load(block + n_lanes * i);
#pragma GCC unroll 4
    for (int left = each / 2; left > 0; left /= 2)
#pragma GCC unroll 8
      for (int i = 0; i < left; ++i)
        sums[i] = __builtin_shuffle(sums[2 * i], sums[2 * i + 1], Order{0, 2, 4, 6, 8, 10, 12, 14}) +
                  __builtin_shuffle(sums[2 * i], sums[2 * i + 1], Order{1, 3, 5, 7, 9, 11, 13, 15});
    store(cells, sums[0]);
#else
    for (int i = 0; i < n_lanes; ++i) {
      double sums[each];
      for (int q = 0; q < each; ++q)
        sums[q] = block[each * i + q];
      for (int left = each / 2; left > 0; left /= 2)
        for (int q = 0; q < left; ++q)
          sums[q] = sums[2 * q] + sums[2 * q + 1];
      cells[i] = sums[0];
    }
#endif
  }
}
/// Do eight cells have so many points each?
SETTLE_INLINE bool are_even(const std::uint32_t* begin, int each) {
  bool even = true;
  for (int i = 0; i < n_lanes; ++i)
    even = even && begin[i + 1] - begin[i] == static_cast<std::uint32_t>(each);
  return even;
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

/// Sums `count` quantities of points over the cells of a tile, `each` the number of points that most squares of one
/// cell hold. `fill(points, first, n)` puts the quantities of a block of points into `block`.
template <int per_square, int count, int each, class Blocks, class Fill>
SETTLE_INLINE void sum_over_cells(const Step& step, const Tile& tile, double* block, const CellArrays& cells,
                                  Fill&& fill) {
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
  const std::size_t end = tile.end_of_points(step, per_square);
  const auto add_cell = add(step.points, end, true);
  const auto add_eight = [&](std::size_t square, std::size_t p) {
    filled.reach(p, end, step.points, fill);
    if (p + each * n_lanes > filled.last) return false;
    add_up_even<each, count, Blocks::pitch>(block + (p - filled.first), cells.quantity(0) + square, cells.stride);
    return true;
  };
  for_each_line(
      step, tile,
      [&](std::size_t square, std::size_t number) {
        const std::uint32_t* begin = step.begin + static_cast<std::size_t>(per_square) * number;
        for (int column = 0; column < step.line;) {
          if (per_square == 1 && column + n_lanes <= step.line && are_even(begin, each) &&
              add_eight(square, std::size_t{begin[0]})) {
            column += n_lanes, square += n_lanes, begin += n_lanes;
            continue;
          }
          for (int which = 0; which < per_square; ++which, ++begin)
            add_cell(which, square, std::size_t{begin[0]}, std::size_t{begin[1]});
          ++column, ++square;
        }
      },
      [&](std::size_t first) {
        cells.clear(per_square * count, first, first + static_cast<std::size_t>(step.node_line));
      });
  filled = {};
  const Strays& strays = step.strays[tile.index];
  for_each_cell_of_strays<per_square>(step, tile, add(strays.points, strays.count, false));
}

/// Gravity on points q ... of a block, all of them [m/s2].
SETTLE_INLINE Lanes gravity_on(const Step& step, const std::int32_t* layer, int count) {
  Lanes gravity = all(0.0);
  for (int i = 0; i < least(count, n_lanes); ++i)
    gravity[i] = layer[i] == step.ramped_layer ? step.ramped_gravity : step.gravity;
  return gravity;
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
