/// \file
/// Squares and cubes: what the points have to say, in products of the axes.
#pragma once

#include "boxes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Boxes, bool full, Weight weight>
struct BoxProducts : Boxes {
  using Boxes::dim, Boxes::n, Boxes::n_nodes, Boxes::n_lines, Boxes::n_squares;
  using Along = typename Boxes::Along;
  using Block = typename Boxes::ScatterBlock;

  /// Values and slopes of products along the axes, and the products of those along all axes but the first: of values,
  /// and with the slope along one of them.
  struct Products {
    Lanes value[dim][n], slope[dim][n], across[n_lines], across_slope[dim - 1][n_lines];

    SETTLE_INLINE explicit Products(const Lanes local[dim]) {
      for (int d = 0; d < dim; ++d)
        Along::products(local[d], value[d], slope[d]);
      for (int k = 0; k < n_lines; ++k) {
        const int j = k % n, l = k / n;
        if constexpr (dim == 2) {
          across[k] = value[1][j], across_slope[0][k] = slope[1][j];
        } else {
          across[k] = value[2][l] * value[1][j];
          across_slope[0][k] = value[2][l] * slope[1][j], across_slope[1][k] = slope[2][l] * value[1][j];
        }
      }
    }
  };

  SETTLE_INLINE static void fill(const Step& step, const PointArrays& points, std::size_t p, int some, double* block) {
    auto put = [&](const Lanes& lanes) { store(block, lanes), block += Block::pitch; };
    const auto of_point = [&](const double* values) { return load(values + p, some); };
    Lanes x[dim];
    for (int d = 0; d < dim; ++d)
      x[d] = of_point(points.position[d]);
    const Products at(place<dim>(step, x).local);
    Lanes square[dim][n_squares];
    for (int d = 0; d < dim; ++d)
      Along::squares(at.value[d], square[d]);
    const Lanes m = of_point(points.mass), v = of_point(points.volume);
    for_each_product<dim>(square, m, put);
    const auto put_values = [&](const Lanes& what) {
      for (int k = 0; k < n_lines; ++k) {
        const Lanes share = what * at.across[k];
        for (int i = 0; i < n; ++i)
          put(share * at.value[0][i]);
      }
    };
    for (int d = 0; d < dim; ++d)
      put_values(m * of_point(points.velocity[d]));
    Lanes tension[n_stresses<dim>];
    for (int c = 0; c < n_stresses<dim>; ++c)
      if (dim == 3 || c != 2) tension[c] = v * of_point(points.stress[c]);
    for (int d = 0; d < dim; ++d)
      for (int k = 0; k < n_lines; ++k) {
        const Lanes along = tension[component<dim>(d, 0)] * at.across[k];
        Lanes across = tension[component<dim>(d, 1)] * at.across_slope[0][k];
        if constexpr (dim == 3) across += tension[component<dim>(d, 2)] * at.across_slope[1][k];
        for (int i = 0; i < n; ++i)
          put(along * at.slope[0][i] + across * at.value[0][i]);
      }
    if constexpr (full) {
      put_values(v);
      for (int k = 0; k < n_felt<dim>; ++k)
        put(tension[felt<dim>(k)]);
    } else {
      put(v);
    }
    if constexpr (weight == Weight::uniform) return;
    Lanes pull = -gravity_on(step, points.layer + p, some);
    if constexpr (weight == Weight::with_force) pull += of_point(points.force[1]);
    put_values(m * pull);
    if constexpr (weight == Weight::with_force) put_values(m * of_point(points.force[0]));
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
