/// \file
/// The law `rate` without rotation, for eight gradients of displacement at a time.
#pragma once

#include "strip.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// d u_x / d x, d u_x / d y, d u_y / d x, d u_y / d y over a step.
struct Gradient {
  Lanes xx, xy, yx, yy;
};

/// What a gradient does to points.
struct Change {
  Lanes volume_ratio, xx, yy, zz, xy;
};

/// Stress increment lambda tr(e) I + 2 mu e, e = sym(G (I + G/2)^-1) the strain half way, and det(I + G).
SETTLE_INLINE Change change_of(const Step& step, const Gradient& g) {
  const Lanes a = 1.0 + 0.5 * g.xx, b = 0.5 * g.xy, c = 0.5 * g.yx, d = 1.0 + 0.5 * g.yy;
  const Lanes inverse = 1.0 / (a * d - b * c);
  const Lanes xx = (g.xx * d - g.xy * c) * inverse, yy = (g.yy * a - g.yx * b) * inverse;
  const Lanes twice_xy = (g.xy * a - g.xx * b + g.yx * d - g.yy * c) * inverse;
  const Lanes volumetric = step.lambda * (xx + yy);
  return {.volume_ratio = (1.0 + g.xx) * (1.0 + g.yy) - g.xy * g.yx,
          .xx = volumetric + 2.0 * step.mu * xx,
          .yy = volumetric + 2.0 * step.mu * yy,
          .zz = volumetric,
          .xy = step.mu * twice_xy};
}

SETTLE_INLINE void deform(const PointArrays& points, std::size_t p, int count, const Change& change) {
  const auto add = [&](double* values, const Lanes& increment) {
    store(values + p, load(values + p, count) + increment, count);
  };
  store(points.volume + p, load(points.volume + p, count) * change.volume_ratio, count);
  add(points.stress[0], change.xx);
  add(points.stress[1], change.yy);
  add(points.stress[2], change.zz);
  add(points.stress[3], change.xy);
}

/// Density over stiffness of cells [s2/m2]: the stiffness is M, or M / J + |sigma| for hyperelastic laws; infinite
/// where there is no volume.
SETTLE_INLINE Lanes slowness_of(const Step& step, const Lanes& mass, const Lanes& volume,
                                const double* largest_stress) {
  const double modulus = step.lambda + 2.0 * step.mu;
  const Mask some = volume > 0.0;
  const Lanes safe = some ? volume : all(1.0);
  const Lanes over = step.full_cells ? (safe > step.cell_volume ? safe : all(step.cell_volume)) : safe;
  Lanes stiffness = all(modulus);
  if (step.hyperelastic) stiffness = modulus * (mass / safe) / step.density + load(largest_stress);
  return some ? (mass / over) / stiffness : all(__builtin_inf());
}

/// Volume that a cell's stress acts over, by the volume of its points; zero where there is none.
SETTLE_INLINE Lanes volume_ratio_of(const Step& step, const Lanes& volume) {
  if (!step.full_cells) return all(1.0);
  return volume > 0.0 ? step.cell_volume / volume : all(0.0);
}

/// Largest normal stress in the plane of every cell's points, for the stable step of hyperelastic laws.
template <int cells_per_square>
SETTLE_INLINE void find_largest_stress(const Step& step, int index, const CellArrays& cells, int quantity) {
  const Strip strip(step, index);
  for_each_cell<cells_per_square>(step, strip, [&](int which, std::size_t square, std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t p = first; p < last; ++p)
      for (int c = 0; c < 2; ++c) {
        const double size = __builtin_fabs(step.points.stress[c][p]);
        largest = size > largest ? size : largest;
      }
    cells.quantity(quantity + which)[square] = largest;
  });
}

/// New positions and velocities of points; whether any has left the square (or, as `part` says, the triangle) that it
/// was in.
struct Motion {
  Lanes move[2], kick[2];
};
SETTLE_INLINE void shift(const Step& step, const PointArrays& points, std::size_t p, int count, const Motion& motion,
                         Lanes new_position[2]) {
  for (int d = 0; d < 2; ++d) {
    new_position[d] = load(points.position[d] + p, count) + motion.move[d];
    store(points.position[d] + p, new_position[d], count);
    store(points.velocity[d] + p, step.kept * (load(points.velocity[d] + p, count) + motion.kick[d]), count);
  }
}

/// Moves the points of a block, eight at a time by `move_some(first, count, q)`, which says which of them have left
/// their cells; these are reported.
template <int size, class MoveSome>
SETTLE_INLINE void move_block(const Step& step, int strip, bool strays, std::size_t first, int count,
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
      step.crossed(step.context, strip, strays, first + static_cast<std::size_t>(q));
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
