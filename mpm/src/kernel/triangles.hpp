/// \file
/// The explicit step on linear triangles (TriangleSpace).
#pragma once

#include "law.hpp"
#include "nodes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT::triangles {

using Points = Block<128>;
constexpr int per_square = 2;

/// Sums of a triangle: mass by pairs of shape functions, momentum by shape function, volume and stress.
enum Sum {
  mass_00,
  mass_01,
  mass_02,
  mass_11,
  mass_12,
  mass_22,
  momentum_x,
  momentum_y = 9,
  volume = 12,
  stress_xx,
  stress_yy,
  stress_xy,
  external_y,
  external_x = 19
};
/// How many there are.
constexpr int sums_of(Weight weight) {
  return weight == Weight::uniform ? 16 : weight == Weight::by_layer ? 19 : 22;
}

/// Constants of a triangle while its points move: velocities gained and displacements, at the first node and the
/// differences of the others; then a Change, or a Gradient where the law is none of the kernel's.
enum Constant { kick_x, kick_y = 3, move_x = 6, move_y = 9, change = 12, n_constants = 17 };

/// Sums and largest stresses come first in the memory of the squares, constants behind them.
constexpr int most_sums = per_square * (sums_of(Weight::with_force) + 1);
constexpr int n_quantities = most_sums + per_square * n_constants;

/// Values of the shape functions, and which of the square's triangles it is.
struct Place {
  Lanes column, row;
  Mask upper;
  Lanes value[3];
};

SETTLE_INLINE Place place(const Step& step, const Lanes& x, const Lanes& y) {
  const Lanes sx = (x - step.origin[0]) * step.inverse_size, sy = (y - step.origin[1]) * step.inverse_size;
  Place at;
  at.column = floor_of(sx), at.row = floor_of(sy);
  const Lanes xi = sx - at.column, eta = sy - at.row;
  at.upper = xi + eta > 1.0;
  at.value[1] = at.upper ? 1.0 - xi : xi;
  at.value[2] = at.upper ? 1.0 - eta : eta;
  at.value[0] = 1.0 - at.value[1] - at.value[2];
  return at;
}

template <Weight weight>
SETTLE_INLINE void products(const Step& step, const PointArrays& points, std::size_t p, int count, double* block) {
  const auto put = [block](int k, const Lanes& lanes) {
    store(block + static_cast<std::size_t>(k) * Points::pitch, lanes);
  };
  const Lanes mass = load(points.mass + p, count);
  const Place at = place(step, load(points.position[0] + p, count), load(points.position[1] + p, count));
  const Lanes share[3] = {mass * at.value[0], mass * at.value[1], mass * at.value[2]};
  for (int i = 0, k = mass_00; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      put(k++, share[i] * at.value[j]);
  for (int d = 0; d < 2; ++d) {
    const Lanes velocity = load(points.velocity[d] + p, count);
    for (int i = 0; i < 3; ++i)
      put(momentum_x + 3 * d + i, share[i] * velocity);
  }
  const Lanes v = load(points.volume + p, count);
  put(volume, v);
  put(stress_xx, v * load(points.stress[0] + p, count));
  put(stress_yy, v * load(points.stress[1] + p, count));
  put(stress_xy, v * load(points.stress[3] + p, count));
  if constexpr (weight == Weight::uniform) return;
  Lanes pull_y = -gravity_on(step, points.layer + p, count);
  if constexpr (weight == Weight::with_force) {
    pull_y += load(points.force[1] + p, count);
    for (int i = 0; i < 3; ++i)
      put(external_x + i, share[i] * load(points.force[0] + p, count));
  }
  for (int i = 0; i < 3; ++i)
    put(external_y + i, share[i] * pull_y);
}

/// Stress times the volume it acts over, in place; the strip's least slowness and the volumes of its columns.
template <int count>
SETTLE_INLINE void finish_cells(const Step& step, int index, const CellArrays& cells) {
  const Strip strip(step, index);
  Lanes slowness = all(__builtin_inf());
  for (int which = 0; which < per_square; ++which) {
    const auto sum = [&](int k) { return cells.quantity(which * count + k); };
    for (std::size_t s = 0; s < strip.n_squares; s += n_lanes) {
      const auto at = [&](int k) { return load(sum(k) + s); };
      const Lanes mass = at(mass_00) + at(mass_11) + at(mass_22) + 2.0 * (at(mass_01) + at(mass_02) + at(mass_12));
      const Lanes v = at(volume);
      const Lanes own = slowness_of(step, mass, v, cells.quantity(per_square * count + which) + s);
      slowness = own < slowness ? own : slowness;
      const Lanes ratio = volume_ratio_of(step, v);
      for (int k = stress_xx; k <= stress_xy; ++k)
        store(sum(k) + s, ratio * at(k));
    }
  }
  step.sums[index].slowness_squared = least_of(slowness);
  double* columns = step.column_volume + static_cast<std::size_t>(index * step.columns);
  for (int column = 0; column < step.columns; ++column)
    columns[column] = 0.0;
  for (int row = 0; row < strip.last_row - strip.first_row; ++row)
    for (int which = 0; which < per_square; ++which) {
      const double* v = cells.quantity(which * count + volume) + row * step.node_columns;
      for (int column = 0; column < step.columns; ++column)
        columns[column] += v[column];
    }
}

/// From the cells around to the nodes n ... n + 7. The corners of the lower triangle of square s are the nodes s, s + 1
/// and s + c, c the columns of nodes; those of the upper one s + c + 1, s + c and s + 1.
template <Weight weight>
SETTLE_INLINE void gather(const Step& step, const CellArrays& cells, std::size_t n, double gravity, double* nodes) {
  constexpr int count = sums_of(weight);
  const auto c = static_cast<std::size_t>(step.node_columns);
  const auto lower = [&](int k, std::size_t back) { return load(cells.quantity(k) + n - back); };
  const auto upper = [&](int k, std::size_t back) { return load(cells.quantity(count + k) + n - back); };
  const auto put = [&](int array, const Lanes& lanes) {
    store(nodes + static_cast<std::size_t>(array) * step.n_nodes + n, lanes);
  };
  const auto by_corner = [&](int k0, int k1, int k2) {
    return lower(k0, 0) + lower(k1, 1) + upper(k2, 1) + lower(k2, c) + upper(k1, c) + upper(k0, c + 1);
  };
  const Lanes diagonal = by_corner(mass_00, mass_11, mass_22);
  const Lanes mass = diagonal + by_corner(mass_01, mass_01, mass_02) + by_corner(mass_02, mass_12, mass_12);
  put(node_mass, mass);
  put(node_matrix, diagonal);
  put(node_matrix + 1, lower(mass_01, 0) + upper(mass_01, c)); // with node + 1
  put(node_matrix + 2, lower(mass_12, 1) + upper(mass_12, 1)); // with node + c - 1
  put(node_matrix + 3, lower(mass_02, 0) + upper(mass_02, 1)); // with node + c
  for (int d = 0; d < 2; ++d) {
    const int k = momentum_x + 3 * d;
    put(node_momentum + d, by_corner(k, k + 1, k + 2));
    const int x = d == 0 ? stress_xx : stress_xy, y = d == 0 ? stress_xy : stress_yy; // gradients are -1, 0 or 1 over h
    const Lanes right = lower(x, 1) - upper(x, c) + upper(x, c + 1) - lower(x, 0);
    const Lanes up = lower(y, c) - upper(y, 1) + upper(y, c + 1) - lower(y, 0);
    put(node_force + d, (right + up) * step.inverse_size);
  }
  if constexpr (weight == Weight::uniform)
    put(node_external, -gravity * mass);
  else
    put(node_external, by_corner(external_y, external_y + 1, external_y + 2));
  if constexpr (weight == Weight::with_force)
    put(node_external + 1, by_corner(external_x, external_x + 1, external_x + 2));
}

template <Weight weight>
SETTLE_INLINE void scatter_with(const Step& step, int index, const Scratch& scratch) {
  constexpr int count = sums_of(weight);
  const CellArrays cells(step, scratch.cells);
  const Strip strip(step, index);
  sum_over_cells<per_square, count, Points>(
      step, index, scratch.block, cells, [&](const PointArrays& points, std::size_t first, int n) {
        for (int q = 0; q < n; q += n_lanes)
          products<weight>(step, points, first + static_cast<std::size_t>(q), n - q, scratch.block + q);
      });
  clear_behind(step, strip, cells, per_square * count);
  if (step.hyperelastic) find_largest_stress<per_square>(step, index, cells, per_square * count);
  finish_cells<count>(step, index, cells);
  const std::size_t n_nodes = strip.n_squares + static_cast<std::size_t>(step.node_columns);
  for (std::size_t n = 0; n < n_nodes; n += n_lanes)
    gather<weight>(step, cells, n, step.weight[index].gravity, scratch.nodes);
  hand_over(step, index, scratch.nodes);
}

inline void scatter(const Step& step, int strip, const Scratch& scratch) {
  switch (step.weight[strip].kind) {
  case Weight::uniform:
    return scatter_with<Weight::uniform>(step, strip, scratch);
  case Weight::by_layer:
    return scatter_with<Weight::by_layer>(step, strip, scratch);
  case Weight::with_force:
    return scatter_with<Weight::with_force>(step, strip, scratch);
  }
}

/// Constants of the triangles of eight squares.
SETTLE_INLINE void set_constants(const Step& step, const CellArrays& cells, std::size_t node, std::size_t s) {
  const auto c = static_cast<std::size_t>(step.node_columns);
  for (int which = 0; which < per_square; ++which) {
    const std::size_t corner[3] = {which == 0 ? 0 : c + 1, which == 0 ? 1 : c, which == 0 ? c : 1};
    const auto put = [&](int k, const Lanes& lanes) { store(cells.quantity(which * n_constants + k) + s, lanes); };
    const double inverse = which == 0 ? step.inverse_size : -step.inverse_size;
    Lanes slope[2][2];
    for (int d = 0; d < 2; ++d) {
      const double *a = step.node[node_force + d] + node, *u = step.node[node_momentum + d] + node;
      const Lanes a0 = load(a + corner[0]), u0 = load(u + corner[0]);
      put(kick_x + 3 * d, step.kick * a0);
      put(move_x + 3 * d, u0);
      for (int i = 1; i < 3; ++i) {
        const Lanes du = load(u + corner[i]) - u0;
        put(kick_x + 3 * d + i, step.kick * (load(a + corner[i]) - a0));
        put(move_x + 3 * d + i, du);
        slope[d][i - 1] = du * inverse;
      }
    }
    const Gradient gradient{slope[0][0], slope[0][1], slope[1][0], slope[1][1]};
    if (step.rate) {
      const Change by = change_of(step, gradient);
      put(change, by.volume_ratio), put(change + 1, by.xx), put(change + 2, by.yy), put(change + 3, by.zz);
      put(change + 4, by.xy);
    } else {
      put(change, gradient.xx), put(change + 1, gradient.xy), put(change + 2, gradient.yx),
          put(change + 3, gradient.yy);
      put(change + 4, all(0.0));
    }
  }
}

SETTLE_INLINE Mask move_points(const Step& step, const PointArrays& points, std::size_t p, int count,
                               const double* block) {
  const auto of_cell = [block](int k) { return load(block + static_cast<std::size_t>(k) * Points::pitch); };
  const Place before = place(step, load(points.position[0] + p, count), load(points.position[1] + p, count));
  const auto interpolate = [&](int k) {
    return of_cell(k) + before.value[1] * of_cell(k + 1) + before.value[2] * of_cell(k + 2);
  };
  const Motion motion{{interpolate(move_x), interpolate(move_y)}, {interpolate(kick_x), interpolate(kick_y)}};
  Lanes position[2];
  shift(step, points, p, count, motion, position);
  if (step.rate)
    deform(points, p, count,
           {of_cell(change), of_cell(change + 1), of_cell(change + 2), of_cell(change + 3), of_cell(change + 4)});
  const Place after = place(step, position[0], position[1]);
  return (after.column != before.column) | (after.row != before.row) | (after.upper != before.upper);
}

inline void move(const Step& step, int index, const Scratch& scratch) {
  const CellArrays cells = CellArrays(step, scratch.cells).after(most_sums);
  const Strip strip(step, index);
  for (std::size_t s = 0; s < strip.n_squares; s += n_lanes)
    set_constants(step, cells, strip.first_node(step) + s, s);
  spread_over_points<per_square, n_constants, Points>(
      step, index, scratch.block, cells, [&](const PointArrays& points, std::size_t first, int n, bool strays) {
        if (!step.rate) step.deform(step.context, first, n, scratch.block + change * Points::pitch, Points::pitch);
        move_block<Points::size>(step, index, strays, first, n, [&](std::size_t p, int count, int q) {
          return move_points(step, points, p, count, scratch.block + q);
        });
      });
}

inline void displace_nodes(const Step& step, int strip) {
  displace<3>(step, strip);
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT::triangles
