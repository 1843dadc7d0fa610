/// \file
/// Squares and cubes: what the points have to say, in products of the axes.
#pragma once

#include "boxes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Eight times n numbers, `count` of them for every axis.
template <int dim, int count, int n>
using AlongAxes = Lanes[dim][count][n];

/// Products of `n` slots of points: values and slopes along the axes, and those along all axes but the first: of
/// values, and with the slope along one of them; what products of two products differ in.
template <class Boxes, int n>
struct BoxProducts {
  static constexpr int dim = Boxes::dim, n_functions = Boxes::n, n_lines = Boxes::n_lines;
  using Along = typename Boxes::Along;
  Lanes first_local[n]; ///< coordinate along the first axis
  AlongAxes<dim, n_functions, n> value;
  AlongAxes<dim, Boxes::n_squares, n> square;
  Lanes across[n_lines][n], across_slope[dim - 1][n_lines][n];

  SETTLE_INLINE void set(int slot, const Lanes local[dim]) {
    first_local[slot] = local[0];
    for (int d = 0; d < dim; ++d) {
      Lanes values[n_functions], squares[Boxes::n_squares];
      Along::products(local[d], values);
      Along::squares(values, squares);
      for (int i = 0; i < n_functions; ++i)
        value[d][i][slot] = values[i];
      for (int i = 0; i < Boxes::n_squares; ++i)
        square[d][i][slot] = squares[i];
    }
    for (int k = 0; k < n_lines; ++k) {
      const int j = k % n_functions, l = k / n_functions;
      const Lanes y = value[1][j][slot], dy = Along::slope(j, local[1]);
      if constexpr (dim == 2) {
        across[k][slot] = y, across_slope[0][k][slot] = dy;
      } else {
        const Lanes z = value[2][l][slot], dz = Along::slope(l, local[2]);
        across[k][slot] = z * y, across_slope[0][k][slot] = z * dy, across_slope[1][k][slot] = dz * y;
      }
    }
  }
};

/// What points have to say, each quantity summed over `n` slots and handed to `put`.
template <class Boxes, int n, class Values, class Put>
struct BoxSums {
  static constexpr int dim = Boxes::dim, n_functions = Boxes::n, n_lines = Boxes::n_lines;
  using Along = typename Boxes::Along;
  const Values& points;
  Put& put;
  BoxProducts<Boxes, n> at;

  SETTLE_INLINE BoxSums(const Step& step, const Values& values, Put& target) : points(values), put(target) {
    for (int slot = 0; slot < n; ++slot) {
      Lanes x[dim];
      for (int d = 0; d < dim; ++d)
        x[d] = points.of[Values::position + d][slot];
      at.set(slot, place<dim>(step, x).local);
    }
  }

  /// `factor` times every product of one square of a product for each axis, those of the first axis fastest.
  template <int axis = dim - 1>
  SETTLE_INLINE void put_squares(const Lanes* factor) {
    for (int i = 0; i < Boxes::n_squares; ++i)
      if constexpr (axis == 0) {
        put(sum_of_slots<n>([&](int slot) { return factor[slot] * at.square[0][i][slot]; }));
      } else {
        Lanes product[n];
        for (int slot = 0; slot < n; ++slot)
          product[slot] = factor[slot] * at.square[axis][i][slot];
        put_squares<axis - 1>(product);
      }
  }
  /// `what` times every product.
  SETTLE_INLINE void put_values(const Lanes* what) {
    for (int k = 0; k < n_lines; ++k) {
      Lanes share[n];
      for (int slot = 0; slot < n; ++slot)
        share[slot] = what[slot] * at.across[k][slot];
      for (int i = 0; i < n_functions; ++i)
        put(sum_of_slots<n>([&](int slot) { return share[slot] * at.value[0][i][slot]; }));
    }
  }
  /// The same for `what` times value k of the points.
  SETTLE_INLINE void put_values(const Lanes* what, int k) {
    Lanes product[n];
    for (int slot = 0; slot < n; ++slot)
      product[slot] = what[slot] * points.of[k][slot];
    put_values(product);
  }
  /// Internal force along an axis, in units of the length of a square, by products; v: volume.
  SETTLE_INLINE void put_force(const Lanes* v, int d) {
    for (int k = 0; k < n_lines; ++k) {
      Lanes along[n], across[n];
      for (int slot = 0; slot < n; ++slot) {
        const auto tension = [&](int axis) { return v[slot] * points.tension(component<dim>(d, axis))[slot]; };
        along[slot] = tension(0) * at.across[k][slot];
        across[slot] = tension(1) * at.across_slope[0][k][slot];
        if constexpr (dim == 3) across[slot] += tension(2) * at.across_slope[1][k][slot];
      }
      for (int i = 0; i < n_functions; ++i)
        put(sum_of_slots<n>([&](int slot) {
          return along[slot] * Along::slope(i, at.first_local[slot]) + across[slot] * at.value[0][i][slot];
        }));
    }
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
