/// \file
/// Generalised interpolation: bilinear shape functions averaged over the domain that each point carries.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "settle/mpm/square_grid.hpp"
#include "settle/mpm/stencil.hpp"

namespace settle::mpm {

/// Contiguous-particle GIMP (Bardenhagen & Kober 2004): a point fills a rectangle along the axes, its domain, and feels
/// the averages over it of the bilinear functions and of their gradients. A domain reaches as far as its half-lengths,
/// but never beyond a side of the grid or the squares next to the point's own: it is made shorter on both ends alike
/// there, so that linear fields keep their value at the point. Every square is a cell and holds the points whose
/// centres lie in it. A space as described in spaces.hpp.
class GimpSpace : public CornerNodes {
public:
  static constexpr int max_nodes = 16; ///< domains reach into the squares around: four lines of nodes along each axis
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  static constexpr bool has_domains = true;
  using Stencil = mpm::Stencil<dim, max_nodes, StencilNodes::of_the_point>;
  using CornerNodes::CornerNodes;

  [[nodiscard]] int n_cells() const { return n_squares(); }
  [[nodiscard]] double cell_volume() const { return size() * size(); } ///< area [m2]
  [[nodiscard]] double shortest_length() const { return size(); }      ///< [m], as without averaging
  [[nodiscard]] int column_of(int cell) const { return column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return row_of_square(cell); }

  [[nodiscard]] int locate(const Vector<2>& x) const { return place(x).square; }
  [[nodiscard]] Stencil stencil(int cell, const Points<2>& points, std::size_t p) const {
    return stencil_of_box(cell, points.position_of(p), points.half_lengths_of(p));
  }
  /// Of a domain around x, which lies in the cell.
  [[nodiscard]] Stencil stencil_of_box(int cell, const Vector<2>& x, const Vector<2>& half_lengths) const {
    const auto [square, xi, eta] = place_in(cell, x);
    const Vector<2> half = inverse_size() * half_lengths;
    return product(line(column_of(cell), xi, half[0], columns()), line(row_of(cell), eta, half[1], rows()));
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return product({column_of(cell), 2, {0.5, 0.5}, {-1, 1}}, {row_of(cell), 2, {0.5, 0.5}, {-1, 1}});
  }

private:
  /// Averages along one axis: of the hat functions of `count` lines of nodes from `first` on, and of their derivatives
  /// by the local coordinate.
  struct Line {
    int first, count;
    std::array<double, 4> values, slopes;
  };
  /// Of a square's length: a domain that reaches less far into the next square does not, but for round-off.
  static constexpr double round_off = 1e-10;

  /// Of a domain around the local coordinate s of square k of n, `half` its half-length in squares.
  static Line line(int k, double s, double half, int n) {
    const double reach = std::min({half, 1.0, k + s, n - k - s});
    const double lower = s - reach, upper = s + reach;
    const int first = lower < -round_off ? -1 : 0, last = upper > 1 + round_off ? 1 : 0;
    Line line{k + first, last - first + 2, {}, {}};
    for (int j = first; j <= last; ++j) {
      const double from = j == first ? lower : j, to = j == last ? upper : j + 1;
      const double share = first == last ? 1.0 : (to - from) / (upper - lower), middle = 0.5 * (from + to) - j;
      const auto i = static_cast<std::size_t>(j - first);
      line.values[i] += share * (1 - middle), line.values[i + 1] += share * middle;
      line.slopes[i] -= share, line.slopes[i + 1] += share;
    }
    return line;
  }

  [[nodiscard]] Stencil product(const Line& x, const Line& y) const {
    Stencil s;
    s.count = x.count * y.count;
    std::size_t k = 0;
    for (int j = 0; j < y.count; ++j)
      for (int i = 0; i < x.count; ++i, ++k) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        s.nodes[k] = x.first + i + node_columns() * (y.first + j);
        s.values[k] = x.values[a] * y.values[b];
        s.gradients.col(static_cast<int>(k)) =
            inverse_size() * Vector<2>(x.slopes[a] * y.values[b], x.values[a] * y.slopes[b]);
      }
    return s;
  }
};

} // namespace settle::mpm
