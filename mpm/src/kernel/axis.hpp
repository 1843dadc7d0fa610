/// \file
/// Shape functions of one axis of a square in the products (1 - s)^(degree - k) s^k of its local coordinate s, which
/// are the same for every square (Bezier extraction; Borden et al. 2011). All are positive, and so is what they are
/// combined with, so that sums of mass keep their relative precision wherever the points lie.
#pragma once

#include "lanes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// degree 1: the two hat functions; degree 2: the three quadratic B-splines. Numbers that belong to the functions or
/// products of an axis are `step` apart.
template <int degree>
struct Axis;

template <>
struct Axis<1> {
  static constexpr int n = 2;       ///< shape functions
  static constexpr int n_pairs = 3; ///< products of two of them

  /// The products, and the derivative of product k by s.
  SETTLE_INLINE static void products(const Lanes& s, Lanes value[2]) { value[0] = 1.0 - s, value[1] = s; }
  SETTLE_INLINE static Lanes slope(int k, const Lanes&) { return all(k == 0 ? -1.0 : 1.0); }
  /// What products of two products differ in.
  SETTLE_INLINE static void squares(const Lanes value[2], Lanes square[3]) {
    square[0] = value[0] * value[0], square[1] = value[0] * value[1], square[2] = value[1] * value[1];
  }
  /// Sums over points by squares to those by products: as the functions, the products sum up to one.
  SETTLE_INLINE static void squares_to_products(const Lanes* squares, Lanes* products, int step) {
    products[0] = squares[0] + squares[step], products[step] = squares[step] + squares[2 * step];
  }
  /// Products summed over points to shape functions summed over points, in place; the same for products of two, 00 01
  /// 11.
  SETTLE_INLINE void to_functions(Lanes*, int) const {}
  SETTLE_INLINE void to_pairs(const Lanes* squares, Lanes* pairs, int step) const {
    for (int k = 0; k < 3; ++k)
      pairs[k * step] = squares[k * step];
  }
  /// Coefficients of shape functions to those of products, in place.
  SETTLE_INLINE void to_products(Lanes*, int) const {}
  /// The derivative of a function with these coefficients: at a place; and by products of degree - 1.
  SETTLE_INLINE static Lanes derivative(const Lanes* c, int step, const Lanes*) { return c[step] - c[0]; }
  SETTLE_INLINE static void derivative_products(const Lanes* c, int step, Lanes slopes[1]) {
    slopes[0] = c[step] - c[0];
  }
  /// Sums of derivatives of the products, by sums of products of degree - 1, are added.
  SETTLE_INLINE static void add_derivatives(const Lanes slopes[1], Lanes* sums, int step) {
    sums[0] -= slopes[0], sums[step] += slopes[0];
  }
  /// Integral over the square of product k; of a product of degree - 1; how often product k adds up to one.
  static constexpr double integral(int) { return 0.5; }
  static constexpr double slope_integral = 1.0;
  static constexpr double binomial(int) { return 1.0; }
};

template <>
struct Axis<2> {
  static constexpr int n = 3;
  static constexpr int n_pairs = 6;
  Lanes lower, upper; ///< inverse lengths of the outer functions' supports up to the far side, in squares

  SETTLE_INLINE static void products(const Lanes& s, Lanes value[3]) {
    const Lanes falling = 1.0 - s;
    value[0] = falling * falling, value[1] = falling * s, value[2] = s * s;
  }
  SETTLE_INLINE static Lanes slope(int k, const Lanes& s) {
    const Lanes falling = 1.0 - s;
    return k == 0 ? -2.0 * falling : k == 1 ? falling - s : 2.0 * s;
  }
  SETTLE_INLINE static void squares(const Lanes value[3], Lanes square[5]) {
    square[0] = value[0] * value[0], square[1] = value[0] * value[1], square[2] = value[1] * value[1];
    square[3] = value[1] * value[2], square[4] = value[2] * value[2];
  }
  SETTLE_INLINE static void squares_to_products(const Lanes* squares, Lanes* products, int step) {
    for (int k = 0; k < 3; ++k)
      products[k * step] = squares[k * step] + 2.0 * squares[(k + 1) * step] + squares[(k + 2) * step];
  }
  SETTLE_INLINE void to_functions(Lanes* v, int step) const {
    const Lanes p0 = v[0], p1 = v[step], p2 = v[2 * step];
    v[0] = lower * p0;
    v[step] = (1.0 - lower) * p0 + 2.0 * p1 + (1.0 - upper) * p2;
    v[2 * step] = upper * p2;
  }
  /// 00 01 02 11 12 22.
  SETTLE_INLINE void to_pairs(const Lanes* squares, Lanes* pairs, int step) const {
    const Lanes q0 = squares[0], q1 = squares[step], q2 = squares[2 * step], q3 = squares[3 * step],
                q4 = squares[4 * step];
    const Lanes a = 1.0 - lower, b = 1.0 - upper;
    pairs[0] = lower * lower * q0;
    pairs[step] = lower * (a * q0 + 2.0 * q1 + b * q2);
    pairs[2 * step] = lower * upper * q2;
    pairs[3 * step] = a * a * q0 + 4.0 * a * q1 + (4.0 + 2.0 * a * b) * q2 + 4.0 * b * q3 + b * b * q4;
    pairs[4 * step] = upper * (a * q2 + 2.0 * q3 + b * q4);
    pairs[5 * step] = upper * upper * q4;
  }
  SETTLE_INLINE void to_products(Lanes* c, int step) const {
    const Lanes c0 = c[0], c1 = c[step], c2 = c[2 * step];
    c[0] = lower * c0 + (1.0 - lower) * c1;
    c[step] = 2.0 * c1;
    c[2 * step] = (1.0 - upper) * c1 + upper * c2;
  }
  SETTLE_INLINE static Lanes derivative(const Lanes* c, int step, const Lanes slope[3]) {
    return slope[0] * c[0] + slope[1] * c[step] + slope[2] * c[2 * step];
  }
  SETTLE_INLINE static void derivative_products(const Lanes* c, int step, Lanes slopes[2]) {
    slopes[0] = c[step] - 2.0 * c[0], slopes[1] = 2.0 * c[2 * step] - c[step];
  }
  SETTLE_INLINE static void add_derivatives(const Lanes slopes[2], Lanes* sums, int step) {
    sums[0] -= 2.0 * slopes[0], sums[step] += slopes[0] - slopes[1], sums[2 * step] += 2.0 * slopes[1];
  }
  static constexpr double integral(int k) { return k == 1 ? 1.0 / 6.0 : 1.0 / 3.0; }
  static constexpr double slope_integral = 0.5;
  static constexpr double binomial(int k) { return k == 1 ? 2.0 : 1.0; }
};

/// Which pair the functions a and b make.
template <int degree>
constexpr int pair_of(int a, int b) {
  const int low = a < b ? a : b, high = a < b ? b : a;
  return low * (2 * Axis<degree>::n - low + 1) / 2 + high - low;
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
