/// \file
/// What the cells say to their points, and how these move.
#pragma once

#include "cell_sums.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

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

/// Gives `count` quantities of the cells of a tile to their points; `use(points, first, n, strays)` takes those of a
/// block.
template <int per_square, int count, class Blocks, class Use>
SETTLE_INLINE void spread_over_points(const Step& step, const Tile& tile, double* block, const CellArrays& cells,
                                      Use&& use) {
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
  const PointArrays& strays = step.strays[tile.index].points;
  for_each_cell<per_square>(step, tile, spread_cell(step.points, false));
  if (filled > 0) use(step.points, block_first, filled, false);
  filled = 0;
  for_each_cell_of_strays<per_square>(step, tile, spread_cell(strays, true));
  if (filled > 0) use(strays, block_first, filled, true);
}

/// What moves points.
template <int dim>
struct Motion {
  Lanes move[dim], kick[dim];
};
/// New positions and velocities of points.
template <int dim>
SETTLE_INLINE void shift(const Step& step, const PointArrays& points, std::size_t p, int count,
                         const Motion<dim>& motion, Lanes new_position[dim]) {
  for (int d = 0; d < dim; ++d) {
    new_position[d] = load(points.position[d] + p, count) + motion.move[d];
    store(points.position[d] + p, new_position[d], count);
    store(points.velocity[d] + p, step.kept * (load(points.velocity[d] + p, count) + motion.kick[d]), count);
  }
}

/// Moves the points of a block, eight at a time by `move_some(first, count, q)`, which says which of them have left
/// their cells; these are reported.
template <int size, class MoveSome>
SETTLE_INLINE void move_block(const Step& step, const Tile& tile, bool strays, std::size_t first, int count,
                              MoveSome&& move_some) {
  Mask crossed[size / n_lanes], some{};
  for (int q = 0; q < count; q += n_lanes) {
    const Mask now = move_some(first + static_cast<std::size_t>(q), least(count - q, n_lanes), q);
    crossed[q / n_lanes] = now;
    some |= now;
  }
  if (!any(some)) return; // what lies behind the last point stays where it is
  for (int q = 0; q < count; ++q)
    if (crossed[q / n_lanes][q % n_lanes] != 0)
      step.crossed(step.context, tile.index, strays, first + static_cast<std::size_t>(q));
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
