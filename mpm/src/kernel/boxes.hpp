/// \file
/// Squares and cubes with shape functions that are products of those along the axes: linear (BoxSpace) and quadratic
/// B-splines (BSplineSpace). What their kernels keep of a square, and how it is numbered.
#pragma once

#include "axis.hpp"
#include "cell_sums.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// Shape functions, products and pairs of a square are numbered along x first.
template <int space_dim, int shape_degree>
struct Boxes {
  static constexpr int dim = space_dim, degree = shape_degree;
  using Along = Axis<degree>;
  static constexpr int n = Along::n, n_squares = 2 * degree + 1;
  static constexpr int n_nodes = power(n, dim),
                       n_lines = power(n, dim - 1); ///< of a square; lines of them along an axis
  static constexpr int all_squares = power(n_squares, dim), all_pairs = power(Along::n_pairs, dim);
  static constexpr int per_square = 1, points = power(2, dim); ///< cells of a square; points that most hold
  using SumBlock = Block<dim == 2 && degree == 1 ? 128 : 64>;
  using MoveBlock = Block<dim == 2 && degree == 1 ? 128 : dim == 3 && degree == 2 ? 32 : 64>;

  /// Sums over the points of a square: mass by squares; by products momentum, internal force and volume (or volume
  /// alone); over full cells the stress that nodes feel; external force by products, along the last axis first.
  static constexpr int mass = 0, momentum = all_squares, force = momentum + dim * n_nodes,
                       volume = force + dim * n_nodes;
  static constexpr int stress = volume + n_nodes;
  static constexpr int external(bool full) { return full ? stress + n_felt<dim> : volume + 1; }
  static constexpr int sums_of(bool full, Weight weight) {
    return external(full) + (weight == Weight::uniform ? 0 : weight == Weight::by_layer ? 1 : 2) * n_nodes;
  }
  static constexpr int largest_stress = sums_of(true, dim == 2 ? Weight::with_force : Weight::by_layer);

  /// From these: mass by shape functions, volume, and mass by pairs of shape functions.
  static constexpr int lumped = largest_stress + 1, total_volume = lumped + n_nodes;
  static constexpr int pairs = degree == 1 ? mass : total_volume + 1; ///< degree 1: squares are pairs
  static constexpr int constants = total_volume + 1 + (degree == 1 ? 0 : all_pairs);

  /// While points move, behind the others: gained velocity and displacement by products, and what gradients are off by.
  static constexpr int kick = 0, move = dim * n_nodes, offset = 2 * dim * n_nodes;
  static constexpr int constants_of(bool full) { return offset + (full ? dim * dim : 0); }
  static constexpr int n_quantities = constants + constants_of(true);

  /// Digit of a number in the base n: index along an axis.
  static constexpr int digit(int number, int axis) { return number / power(n, axis) % n; }
  /// First number of the k-th line along an axis; from one number of it to the next are n^axis.
  static constexpr int line(int k, int axis) { return k % power(n, axis) + k / power(n, axis) * power(n, axis + 1); }

  static constexpr Edges edges() {
    Edges edges{};
    constexpr int reach = 2 * n - 1, all = power(reach, dim);
    for (int k = all / 2 + 1; k < all; ++k) {
      for (int d = 0; d < dim; ++d)
        edges.by_axis[edges.count][d] = k / power(reach, d) % reach - (n - 1);
      ++edges.count;
    }
    return edges;
  }
  static constexpr int n_edges = edges().count;

  /// Shape functions along each axis of the squares s ... s + 7 of a tile.
  struct Functions {
    Along along[dim];
  };
  SETTLE_INLINE static Functions functions_at(const Step& step, const Tile& tile, std::size_t s) {
    Functions at;
    if constexpr (degree == 2) {
      int x = static_cast<int>(s) % tile.width, line = tile.first_line + static_cast<int>(s) / tile.width;
      for (int i = 0; i < n_lanes; ++i, ++x) {
        if (x == tile.width) x = 0, ++line;
        const auto set = [&](Along& axis, int index, int count) {
          axis.lower[i] = index == 0 ? 1.0 : 0.5, axis.upper[i] = index == count - 1 ? 1.0 : 0.5;
        };
        set(at.along[0], tile.first_column + x, step.line);
        if constexpr (dim == 3) set(at.along[1], line % step.node_lines, step.lines);
        set(at.along[dim - 1], tile.first_row + line / step.node_lines, step.rows);
      }
    }
    return at;
  }

  /// Calls `action(axis's functions, numbers, step)` for every line of numbers along every axis, x first.
  template <class Action>
  SETTLE_INLINE static void along_all_axes(const Functions& at, Lanes* numbers, Action&& action) {
    for (int axis = 0; axis < dim; ++axis)
      for (int k = 0; k < n_lines; ++k)
        action(at.along[axis], numbers + line(k, axis), power(n, axis));
  }

  /// Of products of degree - 1 along an axis, and of degree along the others: integral over the square less mean over
  /// the points, the means of all products given. They are numbered by line, along the axis first.
  struct Offsets {
    Lanes by[dim][n_lines * degree];
  };
  SETTLE_INLINE static Offsets offsets(const Lanes mean[n_nodes]) {
    Offsets off;
    for (int axis = 0; axis < dim; ++axis)
      for (int k = 0; k < n_lines; ++k) {
        const int first = line(k, axis), step = power(n, axis);
        double integral = Along::slope_integral;
        for (int d = 0; d < dim; ++d)
          if (d != axis) integral *= Along::integral(digit(first, d));
        for (int i = 0; i < degree; ++i) // such a product is the sum of two of the next degree
          off.by[axis][degree * k + i] = integral - (mean[first + i * step] + mean[first + (i + 1) * step]);
      }
    return off;
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
