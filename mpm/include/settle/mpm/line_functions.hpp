/// \file
/// Functions of one coordinate on a line of squares, of which shape functions are products, and their averages.
#pragma once

#include <array>

namespace settle::mpm {

/// Functions of one coordinate at a place: values and derivatives by the local coordinate. They belong to `capacity`
/// lines of nodes, one after the other from `first` on.
template <int capacity>
struct LineFunctions {
  int first = 0;
  std::array<double, static_cast<std::size_t>(capacity)> values, slopes;

  [[nodiscard]] static constexpr int count() { return capacity; }
};

/// Hat functions: 1 at a knot between the squares, 0 at all others.
struct HatFunctions {
  static constexpr int degree = 1;
  /// 2 c / (h times the fastest frequency of a line of squares with lumped mass), c the wave speed, h their size.
  static constexpr double shortest_length = 1.0;

  /// Where line i of nodes lies, in squares from the first one's lower end.
  static double node(int i, int /*squares*/) { return i; }
  /// Averages over the local coordinates from ... to of square k; at a place where both are the same.
  static LineFunctions<2> average(int k, int /*squares*/, double from, double to) {
    const double s = 0.5 * (from + to);
    return {k, {1 - s, s}, {-1, 1}};
  }
};

/// Quadratic B-splines on the knots between the squares, the first and the last of which count three times (open knot
/// vector; de Boor 1978). A line of n squares carries n + 2 functions, three in each square; on its ends only the
/// function of the node there differs from zero.
struct QuadraticSplines {
  static constexpr int degree = 2;
  /// The fastest frequency is at most sqrt(6) c / h (one square with free ends; sqrt(3/2) c / h far from the ends).
  static constexpr double shortest_length = 0.81649658092772603; // 2 / sqrt(6)

  /// Greville's abscissae: linear fields of them are reproduced.
  static double node(int i, int squares) { return i == 0 ? 0.0 : i == squares + 1 ? squares : i - 0.5; }
  /// A quadratic function's average is its value in the middle and length^2 / 24 times its second derivative.
  static LineFunctions<3> average(int k, int squares, double from, double to) {
    // Lengths of the outer two functions' supports up to the square's far side: 2, but 1 at an end of the line.
    const double lower = k == 0 ? 1.0 : 2.0, upper = k == squares - 1 ? 1.0 : 2.0;
    const double s = 0.5 * (from + to), spread = (to - from) * (to - from) / 12.0;
    const double first = ((1 - s) * (1 - s) + spread) / lower, last = (s * s + spread) / upper;
    const double first_slope = -2 * (1 - s) / lower, last_slope = 2 * s / upper;
    return {k, {first, 1 - first - last, last}, {first_slope, -first_slope - last_slope, last_slope}};
  }
};

} // namespace settle::mpm
