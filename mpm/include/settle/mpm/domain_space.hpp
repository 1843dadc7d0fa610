/// \file
/// Generalised interpolation: products of functions of one coordinate, averaged over the domain that each point
/// carries.
#pragma once

#include <algorithm>
#include <cmath>

#include "settle/mpm/product_space.hpp"

namespace settle::mpm {

/// Contiguous-particle GIMP (Bardenhagen & Kober 2004), with hat functions as there or with quadratic B-splines: a
/// point fills a rectangle (in 3-D a cuboid) along the axes, its domain, and feels the averages over it of the
/// functions of the nodes and of their gradients. A domain reaches as far as its half-lengths, but never beyond a side
/// of the grid or the squares next to the point's own: it is made shorter on both ends alike there, so that linear
/// fields keep their value at the point. Every square is a cell and holds the points whose centres lie in it. A space
/// as described in spaces.hpp.
template <int space_dim, class Functions>
class DomainSpace : public SquareCells<space_dim, Functions> {
public:
  static constexpr int dim = space_dim;
  /// Domains reach into the squares around: lines of nodes along each axis.
  static constexpr int max_lines = Functions::degree + 3;
  static constexpr int max_nodes = power<dim>(max_lines);
  static constexpr bool has_domains = true;
  using Stencil = mpm::Stencil<dim, max_nodes, StencilNodes::of_the_point>;
  using SquareCells<dim, Functions>::SquareCells;

  [[nodiscard]] Stencil stencil(int cell, const Points<dim>& points, std::size_t p) const {
    return stencil_of_box(cell, points.position_of(p), points.half_lengths_of(p));
  }
  /// Of a domain around x, which lies in the cell.
  [[nodiscard]] Stencil stencil_of_box(int cell, const Vector<dim>& x, const Vector<dim>& half_lengths) const {
    const PerAxis<int, dim> square = this->squares().index(cell);
    const Vector<dim> local = this->place_in(square, x), half = this->inverse_size() * half_lengths;
    PerAxis<Line, dim> lines;
    for (std::size_t d = 0; d < dim; ++d) {
      const auto axis = static_cast<int>(d);
      lines[d] = line(square[d], local[axis], half[axis], this->squares().counts[d]);
    }
    Stencil stencil;
    stencil.count = multiply(lines, this->node_numbering(), this->inverse_size(), stencil);
    return stencil;
  }
  [[nodiscard]] Stencil cell_average(int cell) const { return this->template average_of_cell<Stencil>(cell); }

private:
  /// Averages along one axis: of the functions of `n` lines of nodes from `first` on, and of their derivatives by the
  /// local coordinate.
  struct Line {
    int first, n;
    std::array<double, static_cast<std::size_t>(max_lines)> values, slopes;

    [[nodiscard]] int count() const { return n; }
  };
  /// Of a square's length: a domain that reaches less far into the next square does not, but for round-off.
  static constexpr double round_off = 1e-10;

  /// Of a domain around the local coordinate s of square k of n, `half` its half-length in squares.
  static Line line(int k, double s, double half, int n) {
    const double reach = std::min({half, 1.0, k + s, n - k - s});
    const double lower = s - reach, upper = s + reach;
    const int first = lower < -round_off ? -1 : 0, last = upper > 1 + round_off ? 1 : 0;
    Line line{k + first, last - first + Functions::degree + 1, {}, {}};
    for (int j = first; j <= last; ++j) {
      const double from = j == first ? lower : j, to = j == last ? upper : j + 1;
      const double share = first == last ? 1.0 : (to - from) / (upper - lower);
      const auto part = Functions::average(k + j, n, from - j, to - j);
      for (std::size_t i = 0; i < part.values.size(); ++i) {
        const auto at = i + static_cast<std::size_t>(j - first);
        line.values[at] += share * part.values[i];
        line.slopes[at] += share * part.slopes[i];
      }
    }
    return line;
  }
};

template <int dim>
using GimpSpace = DomainSpace<dim, HatFunctions>;
template <int dim>
using BSplineGimpSpace = DomainSpace<dim, QuadraticSplines>;

} // namespace settle::mpm
