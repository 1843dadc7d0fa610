/// \file
/// Squares and cubes: from the nodes to the points.
#pragma once

#include "boxes.hpp"
#include "cell_spread.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Boxes, bool full>
struct BoxMove : Boxes {
  using Boxes::dim, Boxes::degree, Boxes::n, Boxes::n_nodes, Boxes::n_lines;
  using Along = typename Boxes::Along;
  using Block = typename Boxes::MoveBlock;
  using Array = NodeArrays<dim>;
  static constexpr int count = Boxes::constants_of(full);

  /// Constants of the squares s ... s + 7 of a tile.
  SETTLE_INLINE static void set_constants(const Step& step, const Tile& tile, const CellArrays& cells, std::size_t s) {
    const auto at = Boxes::functions_at(step, tile, s);
    const std::size_t node = tile.first_node(step) + s;
    const auto put = [&](const double* from, double factor, int to, Lanes c[n_nodes]) {
      for (int k = 0; k < n_nodes; ++k) {
        std::size_t offset = 0;
        for (int d = 0; d < dim; ++d)
          offset += static_cast<std::size_t>(Boxes::digit(k, d) * step.node_step[d]);
        c[k] = load(from + node + offset) * factor;
      }
      Boxes::along_all_axes(at, c, [](const Along& axis, Lanes* v, int apart) { axis.to_products(v, apart); });
      for (int k = 0; k < n_nodes; ++k)
        store(cells.quantity(to + k) + s, c[k]);
    };
    Lanes mean[n_nodes], c[n_nodes];
    for (int k = 0; full && k < n_nodes; ++k)
      mean[k] = load(step.mean + static_cast<std::size_t>(k) * step.mean_stride + node);
    for (int d = 0; d < dim; ++d) {
      put(step.node[Array::force + d], step.kick, Boxes::kick + d * n_nodes, c);
      put(step.node[Array::momentum + d], 1.0, Boxes::move + d * n_nodes, c);
      if constexpr (full) set_offsets(step, cells, s, Boxes::offsets(mean), c, Boxes::offset + d * dim);
    }
  }
  /// What the gradient of a component of the displacement, c by products, is off by.
  SETTLE_INLINE static void set_offsets(const Step& step, const CellArrays& cells, std::size_t s,
                                        const typename Boxes::Offsets& off, const Lanes c[n_nodes], int to) {
    for (int axis = 0; axis < dim; ++axis) {
      Lanes sum = all(0.0);
      for (int k = 0; k < n_lines; ++k) {
        Lanes slopes[degree];
        Along::derivative_products(c + Boxes::line(k, axis), power(n, axis), slopes);
        for (int i = 0; i < degree; ++i)
          sum += off.by[axis][degree * k + i] * slopes[i];
      }
      store(cells.quantity(to + axis) + s, sum * step.inverse_size);
    }
  }

  /// Numbers by product to their sum with the values of the products along the axes up to `axis`, in place; the
  /// derivatives along the axes behind it, by products along those up to it, go the same way.
  template <int axis>
  SETTLE_INLINE static void contract(Lanes (*value)[n], Lanes* c) {
    constexpr int left = power(n, axis);
    for (int i = 0; i < left; ++i) {
      Lanes sum = value[axis][0] * c[i];
      for (int k = 1; k < n; ++k)
        sum += value[axis][k] * c[i + k * left];
      c[i] = sum;
    }
    if constexpr (axis > 0) contract<axis - 1>(value, c);
  }
  /// The same with the derivatives along all axes up to this one.
  template <int axis>
  SETTLE_INLINE static void contract(Lanes (*value)[n], Lanes (*slope)[n], Lanes* c, Lanes* gradient) {
    constexpr int left = power(n, axis);
    Lanes derivative[left];
    for (int i = 0; i < left; ++i)
      derivative[i] = Along::derivative(c + i, left, slope[axis]);
    if constexpr (axis > 0) contract<axis - 1>(value, derivative);
    gradient[axis] = derivative[0];
    for (int i = 0; i < left; ++i) {
      Lanes sum = value[axis][0] * c[i];
      for (int k = 1; k < n; ++k)
        sum += value[axis][k] * c[i + k * left];
      c[i] = sum;
    }
    if constexpr (axis > 0) contract<axis - 1>(value, slope, c, gradient);
  }

  SETTLE_INLINE static Mask move_some(const Step& step, const PointArrays& points, std::size_t p, int some,
                                      double* block) {
    const auto of_cell = [block](int k) { return load(block + static_cast<std::size_t>(k) * Block::pitch); };
    Lanes x[dim], value[dim][n], slope[dim][n], c[n_nodes];
    for (int d = 0; d < dim; ++d)
      x[d] = load(points.position[d] + p, some);
    const Place<dim> before = place<dim>(step, x);
    for (int d = 0; d < dim; ++d) {
      Along::products(before.local[d], value[d]);
      for (int i = 0; i < n; ++i)
        slope[d][i] = Along::slope(i, before.local[d]);
    }
    const auto take = [&](int first) {
      for (int k = 0; k < n_nodes; ++k)
        c[k] = of_cell(first + k);
    };
    Motion<dim> motion;
    Gradient<dim> gradient;
    for (int d = 0; d < dim; ++d) {
      take(Boxes::kick + d * n_nodes);
      contract<dim - 1>(value, c);
      motion.kick[d] = c[0];
      take(Boxes::move + d * n_nodes);
      contract<dim - 1>(value, slope, c, gradient.by[d]);
      motion.move[d] = c[0];
      for (int axis = 0; axis < dim; ++axis) {
        gradient.by[d][axis] *= step.inverse_size;
        if constexpr (full) gradient.by[d][axis] += of_cell(Boxes::offset + dim * d + axis);
      }
    }
    shift(step, points, p, some, motion, x);
    if (step.rate)
      deform(points, p, some, change_of(step, gradient));
    else
      for (int k = 0; k < dim * dim; ++k)
        store(block + static_cast<std::size_t>(k) * Block::pitch, gradient.by[k / dim][k % dim]);
    return in_other_squares(before, place<dim>(step, x));
  }

  static void run(const Step& step, int strip, const Scratch& scratch) {
    const CellArrays cells = CellArrays(step, scratch.cells).after(Boxes::constants);
    for (int t = 0; t < step.strip_tiles; ++t) {
      const Tile tile(step, strip, t);
      if (tile.is_empty(step, 1)) continue;
      for (std::size_t s = 0; s < tile.n_squares; s += n_lanes)
        set_constants(step, tile, cells, s);
      spread_over_points<1, count, Block>(
          step, tile, scratch.block, cells, [&](const PointArrays& points, std::size_t first, int size, bool strays) {
            move_block<Block::size>(step, tile, strays, first, size, [&](std::size_t p, int some, int q) {
              return move_some(step, points, p, some, scratch.block + q);
            });
            if (!step.rate) step.deform(step.context, first, size, scratch.block, Block::pitch);
          });
    }
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
