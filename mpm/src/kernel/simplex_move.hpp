/// \file
/// Linear triangles and tetrahedra: from the nodes to the points.
#pragma once

#include "cell_spread.hpp"
#include "simplices.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Cut>
struct SimplexMove : Simplices<Cut> {
  using Cells = Simplices<Cut>;
  using Cells::dim, Cells::per_square, Cells::n_nodes, Cells::n_constants;
  using Block = typename Cells::PointBlock;
  using Array = NodeArrays<dim>;

  /// Constants of the cells of the squares s ... s + 7 of a tile.
  SETTLE_INLINE static void set_constants(const Step& step, const Tile& tile, const CellArrays& cells, std::size_t s) {
    const std::size_t node = tile.first_node(step) + s;
    for (int which = 0; which < per_square; ++which) {
      const auto put = [&](int k, const Lanes& lanes) { store(cells.quantity(which * n_constants + k) + s, lanes); };
      const auto put_differences = [&](int first, const Lanes values[n_nodes]) {
        put(first, values[0]);
        for (int i = 1; i < n_nodes; ++i)
          put(first + i, values[i] - values[0]);
      };
      Gradient<dim> gradient;
      for (int d = 0; d < dim; ++d) {
        Lanes kick[n_nodes], move[n_nodes];
        for (int i = 0; i < n_nodes; ++i) {
          const std::size_t at = node + Cells::offset_of(step, Cut::corner[which][i]);
          kick[i] = step.kick * load(step.node[Array::force + d] + at);
          move[i] = load(step.node[Array::momentum + d] + at);
        }
        put_differences(Cells::kick + d * n_nodes, kick);
        put_differences(Cells::move + d * n_nodes, move);
        for (int axis = 0; axis < dim; ++axis) {
          const auto edge = Cells::edge_along(which, axis);
          gradient.by[d][axis] = (move[edge.to] - move[edge.from]) * step.inverse_size;
        }
      }
      for (int k = 0; k < Cells::n_changes; ++k)
        put(Cells::change + k, all(0.0));
      if (step.rate) {
        const Change<dim> by = change_of(step, gradient);
        put(Cells::change, by.volume_ratio);
        for (int c = 0; c < n_stresses<dim>; ++c)
          put(Cells::change + 1 + c, by.stress[c]);
      } else {
        for (int k = 0; k < dim * dim; ++k)
          put(Cells::change + k, gradient.by[k / dim][k % dim]);
      }
    }
  }

  SETTLE_INLINE static Mask move_some(const Step& step, const PointArrays& points, std::size_t p, int some,
                                      const double* block) {
    const auto of_cell = [block](int k) { return load(block + static_cast<std::size_t>(k) * Block::pitch); };
    Lanes x[dim];
    for (int d = 0; d < dim; ++d)
      x[d] = load(points.position[d] + p, some);
    const auto before = Cut::locate(step, x);
    const auto interpolate = [&](int k) {
      Lanes sum = of_cell(k);
      for (int i = 1; i < n_nodes; ++i)
        sum += before.value[i] * of_cell(k + i);
      return sum;
    };
    Motion<dim> motion;
    for (int d = 0; d < dim; ++d) {
      motion.move[d] = interpolate(Cells::move + d * n_nodes);
      motion.kick[d] = interpolate(Cells::kick + d * n_nodes);
    }
    shift(step, points, p, some, motion, x);
    if (step.rate) {
      Change<dim> change;
      change.volume_ratio = of_cell(Cells::change);
      for (int c = 0; c < n_stresses<dim>; ++c)
        change.stress[c] = of_cell(Cells::change + 1 + c);
      deform(points, p, some, change);
    }
    return Cut::in_other_cells(before, Cut::locate(step, x));
  }

  static void run(const Step& step, int strip, const Scratch& scratch) {
    const CellArrays cells = CellArrays(step, scratch.cells).after(Cells::constants);
    for (int t = 0; t < step.strip_tiles; ++t) {
      const Tile tile(step, strip, t);
      if (tile.is_empty(step, per_square)) continue;
      for (std::size_t s = 0; s < tile.n_squares; s += n_lanes)
        set_constants(step, tile, cells, s);
      spread_over_points<per_square, n_constants, Block>(
          step, tile, scratch.block, cells, [&](const PointArrays& points, std::size_t first, int size, bool strays) {
            if (!step.rate)
              step.deform(step.context, first, size, scratch.block + Cells::change * Block::pitch, Block::pitch);
            move_block<Block::size>(step, tile, strays, first, size, [&](std::size_t p, int some, int q) {
              return move_some(step, points, p, some, scratch.block + q);
            });
          });
    }
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
