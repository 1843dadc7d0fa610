/// \file
/// The law `rate` without rotation, for eight gradients of displacement at a time.
#pragma once

#include "tile.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Components of the stress: all that points have, and those that nodes feel; where the one between the axes a and b
/// is.
template <int dim>
constexpr int n_stresses = dim == 2 ? 4 : 6;
template <int dim>
constexpr int n_felt = dim == 2 ? 3 : 6;
template <int dim>
constexpr int component(int a, int b) {
  if (a == b) return a;
  return dim == 2 || a + b == 1 ? 3 : a + b == 3 ? 4 : 5;
}
/// Component k of those that nodes feel.
template <int dim>
constexpr int felt(int k) {
  return dim == 2 && k == 2 ? 3 : k;
}

/// Gradient of the displacement over a step, d u_i / d x_j at [i][j].
template <int dim>
struct Gradient {
  Lanes by[dim][dim];
};

/// What a gradient does to points.
template <int dim>
struct Change {
  Lanes volume_ratio, stress[n_stresses<dim>];
};

SETTLE_INLINE Lanes determinant_of(const Gradient<2>& a) {
  return a.by[0][0] * a.by[1][1] - a.by[0][1] * a.by[1][0];
}
SETTLE_INLINE Gradient<2> adjugate_of(const Gradient<2>& a) {
  return {{{a.by[1][1], -a.by[0][1]}, {-a.by[1][0], a.by[0][0]}}};
}
SETTLE_INLINE Gradient<3> adjugate_of(const Gradient<3>& a) {
  Gradient<3> adjugate;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3, m = (i + 1) % 3, n = (i + 2) % 3;
      adjugate.by[i][j] = a.by[k][m] * a.by[l][n] - a.by[k][n] * a.by[l][m];
    }
  return adjugate;
}
SETTLE_INLINE Lanes determinant_of(const Gradient<3>& a) {
  const Gradient<3> adjugate = adjugate_of(a);
  return a.by[0][0] * adjugate.by[0][0] + a.by[0][1] * adjugate.by[1][0] + a.by[0][2] * adjugate.by[2][0];
}
template <int dim>
SETTLE_INLINE Gradient<dim> one_and(const Gradient<dim>& g, double share) {
  Gradient<dim> sum;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j)
      sum.by[i][j] = i == j ? 1.0 + share * g.by[i][j] : share * g.by[i][j];
  return sum;
}

/// Stress increment lambda tr(e) I + 2 mu e, e = sym(G (I + G/2)^-1) the strain half way, and det(I + G).
template <int dim>
SETTLE_INLINE Change<dim> change_of(const Step& step, const Gradient<dim>& g) {
  const Gradient<dim> half_way = one_and(g, 0.5), adjugate = adjugate_of(half_way);
  Lanes determinant = half_way.by[0][0] * adjugate.by[0][0];
  for (int k = 1; k < dim; ++k)
    determinant += half_way.by[0][k] * adjugate.by[k][0];
  const Lanes inverse = 1.0 / determinant;
  Lanes strain[dim][dim]; // G (I + G/2)^-1
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      Lanes sum = g.by[i][0] * adjugate.by[0][j];
      for (int k = 1; k < dim; ++k)
        sum += g.by[i][k] * adjugate.by[k][j];
      strain[i][j] = sum * inverse;
    }
  Lanes trace = strain[0][0];
  for (int d = 1; d < dim; ++d)
    trace += strain[d][d];
  Change<dim> change;
  change.volume_ratio = determinant_of(one_and(g, 1.0));
  change.stress[2] = step.lambda * trace; // across the plane
  for (int i = 0; i < dim; ++i)
    for (int j = i; j < dim; ++j)
      change.stress[component<dim>(i, j)] =
          i == j ? step.lambda * trace + 2.0 * step.mu * strain[i][i] : step.mu * (strain[i][j] + strain[j][i]);
  return change;
}

template <int dim>
SETTLE_INLINE void deform(const PointArrays& points, std::size_t p, int count, const Change<dim>& change) {
  store(points.volume + p, load(points.volume + p, count) * change.volume_ratio, count);
  for (int c = 0; c < n_stresses<dim>; ++c)
    store(points.stress[c] + p, load(points.stress[c] + p, count) + change.stress[c], count);
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

/// Largest normal stress along any axis of every cell's points, for the stable step of hyperelastic laws.
template <int dim, int per_square>
SETTLE_INLINE void find_largest_stress(const Step& step, const Tile& tile, const CellArrays& cells, int quantity) {
  for_each_cell<per_square>(step, tile, [&](int which, std::size_t square, std::size_t first, std::size_t last) {
    double largest = 0;
    for (std::size_t p = first; p < last; ++p)
      for (int c = 0; c < dim; ++c) {
        const double size = __builtin_fabs(step.points.stress[c][p]);
        largest = size > largest ? size : largest;
      }
    cells.quantity(quantity + which)[square] = largest;
  });
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
