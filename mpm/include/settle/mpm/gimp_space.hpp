/// \file
/// Generalised interpolation: bilinear or trilinear shape functions averaged over the domain that each point carries.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "settle/mpm/stencil.hpp"
#include "settle/mpm/tensor_product.hpp"

namespace settle::mpm {

/// Contiguous-particle GIMP (Bardenhagen & Kober 2004): a point fills a rectangle (in 3-D a cuboid) along the axes, its
/// domain, and feels the averages over it of the functions of the corners and of their gradients. A domain reaches as
/// far as its half-lengths, but never beyond a side of the grid or the squares next to the point's own: it is made
/// shorter on both ends alike there, so that linear fields keep their value at the point. Every square is a cell and
/// holds the points whose centres lie in it. A space as described in spaces.hpp.
template <int space_dim>
class GimpSpace : public CornerNodes<space_dim> {
public:
  static constexpr int dim = space_dim;
  /// Domains reach into the squares around: four lines of nodes along each axis.
  static constexpr int max_nodes = dim == 2 ? 16 : 64;
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  static constexpr bool has_domains = true;
  using Stencil = mpm::Stencil<dim, max_nodes, StencilNodes::of_the_point>;
  using CornerNodes<dim>::CornerNodes;

  [[nodiscard]] int n_cells() const { return this->n_squares(); }
  [[nodiscard]] double cell_volume() const { return this->square_volume(); } ///< area [m2] in 2-D
  [[nodiscard]] double shortest_length() const { return this->size(); }      ///< [m], as without averaging
  [[nodiscard]] int column_of(int cell) const { return this->column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return this->row_of_square(cell); }

  [[nodiscard]] int locate(const Vector<dim>& x) const { return this->place(x).square; }
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
    return product(lines);
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    PerAxis<Line, dim> lines;
    for (std::size_t d = 0; d < dim; ++d)
      lines[d] = {this->squares().index(cell)[d], 2, {0.5, 0.5}, {-1, 1}};
    return product(lines);
  }

private:
  /// Averages along one axis: of the hat functions of `n` lines of nodes from `first` on, and of their derivatives by
  /// the local coordinate.
  struct Line {
    int first, n;
    std::array<double, 4> values, slopes;

    [[nodiscard]] int count() const { return n; }
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

  [[nodiscard]] Stencil product(const PerAxis<Line, dim>& lines) const {
    Stencil stencil;
    stencil.count = multiply(lines, this->node_numbering(), this->inverse_size(), stencil);
    return stencil;
  }
};

} // namespace settle::mpm
