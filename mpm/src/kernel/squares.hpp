/// \file
/// The explicit step on squares with shape functions that are products of those along the axes: bilinear
/// (QuadrilateralSpace) and quadratic B-splines (BSplineSpace).
#pragma once

#include "axis.hpp"
#include "law.hpp"
#include "nodes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <int degree>
struct Squares {
  using Along = Axis<degree>;
  using Points = Block<degree == 1 ? 128 : 64>;
  static constexpr int n = Along::n, n2 = n * n, n_squares = 2 * degree + 1, n_pairs = Along::n_pairs;
  static constexpr int n_slopes = degree * n; ///< products in the derivative along one axis

  /// Sums over the points of a square, by products: mass, momentum, stress with derivatives, volume with derivatives
  /// (or volume alone), external force. Products of the first axis run fastest.
  static constexpr int mass = 0, momentum = n_squares * n_squares, xx_dx = momentum + 2 * n2, xy_dx = xx_dx + n_slopes,
                       yy_dy = xy_dx + n_slopes, xy_dy = yy_dy + n_slopes, volume = xy_dy + n_slopes;
  static constexpr int external(bool full) { return volume + (full ? 2 * n_slopes : 1); }
  static constexpr int sums_of(bool full, Weight weight) {
    return external(full) + (weight == Weight::uniform ? 0 : weight == Weight::by_layer ? n2 : 2 * n2);
  }
  static constexpr int most_sums = sums_of(true, Weight::with_force) + 1; ///< and the largest stress

  /// The same by shape functions: products of two of them with mass, then mass, momentum, internal force, external
  /// force.
  static constexpr int pairs = 0, node_values = n_pairs * n_pairs;
  static constexpr int n_functions = node_values + 7 * n2;

  /// While points move: gained velocity and displacement by products, and what the gradients are off by; behind
  /// `functions`.
  static constexpr int kick = 0, move_ = 2 * n2, offset = 4 * n2;
  static constexpr int constants_of(bool full) { return offset + (full ? 4 : 0); }
  static constexpr int n_quantities = most_sums + n_functions + constants_of(true);
  static constexpr int n_edges = degree == 1 ? 4 : 12;
  static constexpr int n_means = degree == 1 ? 2 : 2 * n_slopes; ///< degree 1: the rest follows

  struct Place {
    Lanes column, row, local[2];
  };
  SETTLE_INLINE static Place place(const Step& step, const Lanes& x, const Lanes& y) {
    const Lanes sx = (x - step.origin[0]) * step.inverse_size, sy = (y - step.origin[1]) * step.inverse_size;
    const Lanes column = floor_of(sx), row = floor_of(sy);
    return {column, row, {sx - column, sy - row}};
  }

  template <bool full, Weight weight>
  SETTLE_INLINE static void products(const Step& step, const PointArrays& points, std::size_t p, int count,
                                     double* block) {
    int k = 0;
    const auto put = [&](const Lanes& lanes) { store(block + static_cast<std::size_t>(k++) * Points::pitch, lanes); };
    const Place at = place(step, load(points.position[0] + p, count), load(points.position[1] + p, count));
    Lanes value[2][n], slope[2][degree], square[2][n_squares];
    for (int d = 0; d < 2; ++d)
      Along::products(at.local[d], value[d], slope[d], square[d]);
    const Lanes m = load(points.mass + p, count);
    for (int j = 0; j < n_squares; ++j) {
      const Lanes share = m * square[1][j];
      for (int i = 0; i < n_squares; ++i)
        put(share * square[0][i]);
    }
    const auto put_values = [&](const Lanes& what) {
      for (int j = 0; j < n; ++j) {
        const Lanes share = what * value[1][j];
        for (int i = 0; i < n; ++i)
          put(share * value[0][i]);
      }
    };
    const auto put_dx = [&](const Lanes& what) {
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < degree; ++i)
          put(degree == 1 ? what * value[1][j] : what * value[1][j] * slope[0][i]);
    };
    const auto put_dy = [&](const Lanes& what) {
      for (int j = 0; j < degree; ++j)
        for (int i = 0; i < n; ++i)
          put(degree == 1 ? what * value[0][i] : what * value[0][i] * slope[1][j]);
    };
    for (int d = 0; d < 2; ++d)
      put_values(m * load(points.velocity[d] + p, count));
    const Lanes v = load(points.volume + p, count);
    const Lanes xy = v * load(points.stress[3] + p, count);
    put_dx(v * load(points.stress[0] + p, count));
    put_dx(xy);
    put_dy(v * load(points.stress[1] + p, count));
    put_dy(xy);
    if constexpr (full)
      put_dx(v), put_dy(v);
    else
      put(v);
    if constexpr (weight == Weight::uniform) return;
    Lanes pull_y = -gravity_on(step, points.layer + p, count);
    if constexpr (weight == Weight::with_force) pull_y += load(points.force[1] + p, count);
    put_values(m * pull_y);
    if constexpr (weight == Weight::with_force) put_values(m * load(points.force[0] + p, count));
  }

  /// Shape functions along both axes of the squares s ... s + 7 of a strip.
  struct Functions {
    Along x, y;
  };
  SETTLE_INLINE static Functions functions_at(const Step& step, const Strip& strip, std::size_t s) {
    Functions at;
    if constexpr (degree == 2) {
      int column = static_cast<int>(s) % step.node_columns,
          row = strip.first_row + static_cast<int>(s) / step.node_columns;
      for (int i = 0; i < n_lanes; ++i, ++column) {
        if (column == step.node_columns) column = 0, ++row;
        at.x.lower[i] = column == 0 ? 1.0 : 0.5, at.x.upper[i] = column == step.columns - 1 ? 1.0 : 0.5;
        at.y.lower[i] = row == 0 ? 1.0 : 0.5, at.y.upper[i] = row == step.rows - 1 ? 1.0 : 0.5;
      }
    }
    return at;
  }

  /// Sum of one of the two sets of volumes, those with derivatives along x.
  template <bool full>
  SETTLE_INLINE static Lanes volume_of(const CellArrays& sums, std::size_t s) {
    if constexpr (!full) return load(sums.quantity(volume) + s);
    Lanes v = all(0.0);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < degree; ++i)
        v += Along::binomial(j) * load(sums.quantity(volume + i + degree * j) + s);
    return v;
  }

  /// Full cells: what the mean gradient of each product is off by, kept for the motion; and the sums of stress with the
  /// derivatives, over the full volume and off by as much.
  SETTLE_INLINE static void correct_stress(const Step& step, const Strip& strip, std::size_t s, const CellArrays& sums,
                                           const Lanes& v, Lanes stress[4][n_slopes]) {
    const std::size_t square = strip.first_node(step) + s, left = strip.n_squares - s;
    const int count = left < n_lanes ? static_cast<int>(left) : n_lanes;
    const Mask some = v > 0.0;
    const Lanes inverse = some ? 1.0 / v : all(0.0), ratio = some ? step.cell_volume / v : all(0.0);
    for (int axis = 0; axis < 2; ++axis) {
      Lanes off[n_slopes];
      for (int k = 0; k < n_slopes; ++k) {
        const int across = axis == 0 ? k / degree : k % n, along = axis == 0 ? k % degree : k / n;
        const double integral = Along::integral(across) * Along::slope_integral(along);
        const Lanes mean = load(sums.quantity(volume + axis * n_slopes + k) + s) * inverse;
        off[k] = some ? integral - mean : all(0.0);
        if (degree == 2 || k == 0)
          store(step.mean + static_cast<std::size_t>(degree == 1 ? axis : axis * n_slopes + k) * step.mean_stride +
                    square,
                off[k], count);
      }
      for (int component = 2 * axis; component < 2 * axis + 2; ++component) {
        Lanes total = all(0.0);
        for (int k = 0; k < n_slopes; ++k)
          total += Along::binomial(axis == 0 ? k / degree : k % n) * stress[component][k];
        for (int k = 0; k < n_slopes; ++k)
          stress[component][k] = ratio * (stress[component][k] + total * off[k]);
      }
    }
  }

  /// Sums by products to sums by shape functions, for the squares s ... s + 7.
  template <bool full, Weight weight>
  SETTLE_INLINE static void to_functions(const Step& step, const Strip& strip, std::size_t s, const CellArrays& sums,
                                         const CellArrays& out, Lanes& slowness) {
    const Functions at = functions_at(step, strip, s);
    Lanes squares[n_squares * n_squares], by_x[n_pairs * n_squares], both[n_pairs * n_pairs];
    for (int k = 0; k < n_squares * n_squares; ++k)
      squares[k] = load(sums.quantity(mass + k) + s);
    for (int j = 0; j < n_squares; ++j)
      at.x.to_pairs(squares + n_squares * j, by_x + n_pairs * j, 1);
    for (int i = 0; i < n_pairs; ++i)
      at.y.to_pairs(by_x + i, both + i, n_pairs);
    for (int k = 0; k < n_pairs * n_pairs; ++k)
      store(out.quantity(pairs + k) + s, both[k]);

    Lanes total_mass = all(0.0);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        Lanes m = all(0.0);
        for (int b = 0; b < n; ++b)
          for (int a = 0; a < n; ++a)
            m += both[pair_of<degree>(i, a) + n_pairs * pair_of<degree>(j, b)];
        store(out.quantity(node_values + i + n * j) + s, m);
        total_mass += m;
      }
    const auto put_values = [&](int from, int to) {
      Lanes values[n2];
      for (int k = 0; k < n2; ++k)
        values[k] = load(sums.quantity(from + k) + s);
      for (int j = 0; j < n; ++j)
        at.x.to_functions(values + n * j, 1);
      for (int i = 0; i < n; ++i)
        at.y.to_functions(values + i, n);
      for (int k = 0; k < n2; ++k)
        store(out.quantity(node_values + to * n2 + k) + s, values[k]);
    };
    put_values(momentum, 1);
    put_values(momentum + n2, 2);
    if constexpr (weight != Weight::uniform) put_values(external(full), 5);
    if constexpr (weight == Weight::with_force) put_values(external(full) + n2, 6);

    const Lanes v = volume_of<full>(sums, s);
    const Lanes own = slowness_of(step, total_mass, v, sums.quantity(sums_of(full, weight)) + s);
    slowness = own < slowness ? own : slowness;
    Lanes stress[4][n_slopes];
    for (int component = 0; component < 4; ++component)
      for (int k = 0; k < n_slopes; ++k)
        stress[component][k] = load(sums.quantity(xx_dx + component * n_slopes + k) + s);
    if constexpr (full) correct_stress(step, strip, s, sums, v, stress);
    for (int d = 0; d < 2; ++d) { // force along d: stress (x, d) with d/dx and (d, y) with d/dy
      Lanes force[n2], other[n2];
      for (int j = 0; j < n; ++j)
        at.x.to_slopes(stress[d] + degree * j, force + n * j, 1);
      for (int i = 0; i < n; ++i)
        at.y.to_functions(force + i, n);
      for (int i = 0; i < n; ++i)
        slopes_along_y(at.y, stress[d == 0 ? 3 : 2] + i, other + i);
      for (int j = 0; j < n; ++j)
        at.x.to_functions(other + n * j, 1);
      for (int k = 0; k < n2; ++k)
        store(out.quantity(node_values + (3 + d) * n2 + k) + s, (force[k] + other[k]) * step.inverse_size);
    }
  }
  SETTLE_INLINE static void slopes_along_y(const Along& y, const Lanes* products, Lanes* slopes) {
    y.to_slopes(products, slopes, n);
  }

  SETTLE_INLINE static void finish_columns(const Step& step, int index, const Strip& strip, const CellArrays& volumes) {
    double* columns = step.column_volume + static_cast<std::size_t>(index * step.columns);
    for (int column = 0; column < step.columns; ++column)
      columns[column] = 0.0;
    for (int row = 0; row < strip.last_row - strip.first_row; ++row)
      for (int column = 0; column < step.columns; ++column)
        columns[column] += volumes.quantity(0)[row * step.node_columns + column];
  }

  /// From the squares around to the nodes m ... m + 7.
  template <Weight weight>
  SETTLE_INLINE static void gather(const Step& step, const CellArrays& cells, std::size_t m, double gravity,
                                   double* nodes) {
    const auto columns = static_cast<std::size_t>(step.node_columns);
    const auto put = [&](int array, const Lanes& lanes) {
      store(nodes + static_cast<std::size_t>(array) * step.n_nodes + m, lanes);
    };
    const auto by_node = [&](int what) {
      Lanes sum = all(0.0);
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          sum += load(cells.quantity(node_values + what * n2 + i + n * j) + m - static_cast<std::size_t>(i) -
                      columns * static_cast<std::size_t>(j));
      return sum;
    };
    const Lanes lumped = by_node(0);
    put(node_mass, lumped);
    for (int d = 0; d < 2; ++d) {
      put(node_momentum + d, by_node(1 + d));
      put(node_force + d, by_node(3 + d));
    }
    if constexpr (weight == Weight::uniform)
      put(node_external, -gravity * lumped);
    else
      put(node_external, by_node(5));
    if constexpr (weight == Weight::with_force) put(node_external + 1, by_node(6));
    // couplings of node (i, j) of a square with node (i + di, j + dj)
    int edge = 0;
    for (int dj = 0; dj < n; ++dj)
      for (int di = dj == 0 ? 0 : 1 - n; di < n; ++di) {
        Lanes sum = all(0.0);
        for (int j = 0; j + dj < n; ++j)
          for (int i = di < 0 ? -di : 0; i < n && i + di < n; ++i)
            sum += load(cells.quantity(pairs + pair_of<degree>(i, i + di) + n_pairs * pair_of<degree>(j, j + dj)) + m -
                        static_cast<std::size_t>(i) - columns * static_cast<std::size_t>(j));
        put(node_matrix + edge++, sum);
      }
  }

  template <bool full, Weight weight>
  SETTLE_INLINE static void scatter_with(const Step& step, int index, const Scratch& scratch) {
    constexpr int count = sums_of(full, weight);
    const CellArrays sums(step, scratch.cells), out = sums.after(most_sums), volumes = out.after(n_functions);
    const Strip strip(step, index);
    sum_over_cells<1, count, Points>(
        step, index, scratch.block, sums, [&](const PointArrays& points, std::size_t first, int size) {
          for (int q = 0; q < size; q += n_lanes)
            products<full, weight>(step, points, first + static_cast<std::size_t>(q), size - q, scratch.block + q);
        });
    clear_behind(step, strip, sums, count);
    clear_behind(step, strip, out, n_functions);
    if (step.hyperelastic) find_largest_stress<1>(step, index, sums, count);
    Lanes slowness = all(__builtin_inf());
    for (std::size_t s = 0; s < strip.n_squares; s += n_lanes) {
      to_functions<full, weight>(step, strip, s, sums, out, slowness);
      store(volumes.quantity(0) + s, volume_of<full>(sums, s));
    }
    step.sums[index].slowness_squared = least_of(slowness);
    finish_columns(step, index, strip, volumes);
    const std::size_t n_nodes = strip.n_squares + static_cast<std::size_t>(degree * step.node_columns);
    for (std::size_t m = 0; m < n_nodes; m += n_lanes)
      gather<weight>(step, out, m, step.weight[index].gravity, scratch.nodes);
    hand_over(step, index, scratch.nodes);
  }
  template <bool full>
  SETTLE_INLINE static void scatter_in(const Step& step, int strip, const Scratch& scratch) {
    switch (step.weight[strip].kind) {
    case Weight::uniform:
      return scatter_with<full, Weight::uniform>(step, strip, scratch);
    case Weight::by_layer:
      return scatter_with<full, Weight::by_layer>(step, strip, scratch);
    case Weight::with_force:
      return scatter_with<full, Weight::with_force>(step, strip, scratch);
    }
  }
  static void scatter(const Step& step, int strip, const Scratch& scratch) {
    return step.full_cells ? scatter_in<true>(step, strip, scratch) : scatter_in<false>(step, strip, scratch);
  }

  SETTLE_INLINE static void set_constants(const Step& step, const Strip& strip, const CellArrays& cells,
                                          std::size_t s) {
    const auto columns = static_cast<std::size_t>(step.node_columns);
    const Functions at = functions_at(step, strip, s);
    const std::size_t node = strip.first_node(step) + s;
    const auto put = [&](const double* from, double factor, int to, Lanes c[n2]) {
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          c[i + n * j] =
              load(from + node + static_cast<std::size_t>(i) + columns * static_cast<std::size_t>(j)) * factor;
      for (int j = 0; j < n; ++j)
        at.x.to_products(c + n * j, 1);
      for (int i = 0; i < n; ++i)
        at.y.to_products(c + i, n);
      for (int k = 0; k < n2; ++k)
        store(cells.quantity(to + k) + s, c[k]);
    };
    for (int d = 0; d < 2; ++d) {
      Lanes c[n2];
      put(step.node[node_force + d], step.kick, kick + d * n2, c);
      put(step.node[node_momentum + d], 1.0, move_ + d * n2, c);
      if (!step.full_cells) continue;
      for (int axis = 0; axis < 2; ++axis) {
        Lanes sum = all(0.0);
        for (int k = 0; k < n_slopes; ++k) {
          const int i = axis == 0 ? k % degree : k % n, j = axis == 0 ? k / degree : k / n;
          const double* mean =
              step.mean + static_cast<std::size_t>(degree == 1 ? axis : axis * n_slopes + k) * step.mean_stride;
          const Lanes off = load(mean + node);
          const Lanes slope = slope_of(c, i, j, axis);
          sum += degree == 1 && k == 1 ? -off * slope : off * slope;
        }
        store(cells.quantity(offset + 2 * d + axis) + s, sum * step.inverse_size);
      }
    }
  }
  /// Coefficient of product (i, j) of the derivative along an axis, by those of the function itself.
  SETTLE_INLINE static Lanes slope_of(const Lanes* c, int i, int j, int axis) {
    const int k = i + n * j, next = k + (axis == 0 ? 1 : n);
    if constexpr (degree == 1) return c[next] - c[k];
    const bool first = (axis == 0 ? i : j) == 0;
    return first ? c[next] - 2.0 * c[k] : 2.0 * c[next] - c[k];
  }

  template <bool full>
  SETTLE_INLINE static Mask move_points(const Step& step, const PointArrays& points, std::size_t p, int count,
                                        double* block) {
    const auto of_cell = [block](int k) { return load(block + static_cast<std::size_t>(k) * Points::pitch); };
    const Place before = place(step, load(points.position[0] + p, count), load(points.position[1] + p, count));
    Lanes value[2][n], slope[2][degree], square[2][n_squares];
    for (int d = 0; d < 2; ++d)
      Along::products(before.local[d], value[d], slope[d], square[d]);
    const auto interpolate = [&](const Lanes* c) {
      Lanes sum = all(0.0);
      for (int j = 0; j < n; ++j) {
        Lanes row = value[0][0] * c[n * j];
        for (int i = 1; i < n; ++i)
          row += value[0][i] * c[i + n * j];
        sum += value[1][j] * row;
      }
      return sum;
    };
    const auto derivative = [&](const Lanes* c, int axis) {
      Lanes sum = all(0.0);
      for (int j = 0; j < (axis == 0 ? n : degree); ++j) {
        Lanes row = all(0.0);
        for (int i = 0; i < (axis == 0 ? degree : n); ++i)
          row += (axis == 0 ? slope[0][i] : value[0][i]) * slope_of(c, i, j, axis);
        sum += (axis == 0 ? value[1][j] : slope[1][j]) * row;
      }
      return sum * step.inverse_size;
    };
    Motion motion;
    Lanes gradient[4];
    for (int d = 0; d < 2; ++d) {
      Lanes c[n2];
      for (int k = 0; k < n2; ++k)
        c[k] = of_cell(kick + d * n2 + k);
      motion.kick[d] = interpolate(c);
      for (int k = 0; k < n2; ++k)
        c[k] = of_cell(move_ + d * n2 + k);
      motion.move[d] = interpolate(c);
      for (int axis = 0; axis < 2; ++axis) {
        gradient[2 * d + axis] = derivative(c, axis);
        if constexpr (full) gradient[2 * d + axis] += of_cell(offset + 2 * d + axis);
      }
    }
    Lanes position[2];
    shift(step, points, p, count, motion, position);
    if (step.rate)
      deform(points, p, count, change_of(step, {gradient[0], gradient[1], gradient[2], gradient[3]}));
    else
      for (int k = 0; k < 4; ++k)
        store(block + static_cast<std::size_t>(k) * Points::pitch, gradient[k]);
    const Place after = place(step, position[0], position[1]);
    return (after.column != before.column) | (after.row != before.row);
  }

  template <bool full>
  SETTLE_INLINE static void move_in(const Step& step, int index, const Scratch& scratch) {
    const CellArrays cells = CellArrays(step, scratch.cells).after(most_sums + n_functions);
    const Strip strip(step, index);
    for (std::size_t s = 0; s < strip.n_squares; s += n_lanes)
      set_constants(step, strip, cells, s);
    spread_over_points<1, constants_of(full), Points>(
        step, index, scratch.block, cells, [&](const PointArrays& points, std::size_t first, int size, bool strays) {
          move_block<Points::size>(step, index, strays, first, size, [&](std::size_t p, int count, int q) {
            return move_points<full>(step, points, p, count, scratch.block + q);
          });
          if (!step.rate) step.deform(step.context, first, size, scratch.block, Points::pitch);
        });
  }
  static void move(const Step& step, int strip, const Scratch& scratch) {
    return step.full_cells ? move_in<true>(step, strip, scratch) : move_in<false>(step, strip, scratch);
  }
  static void displace_nodes(const Step& step, int strip) { displace<n_edges>(step, strip); }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
