/// \file
/// Quadratic B-splines on squares or cubes, clamped at the grid's sides.
#pragma once

#include <array>

#include "settle/mpm/stencil.hpp"
#include "settle/mpm/tensor_product.hpp"

namespace settle::mpm {

/// Tensor products of quadratic B-splines on the lines between the squares, the first and the last of which are knots
/// three times over (open knot vector; de Boor 1978). A line of n squares carries n + 2 functions, three in each
/// square. They sum to one and reproduce linear fields of the node positions (Greville's); on a side of the grid only
/// the functions of the nodes on that side differ from zero, so that what a support fixes there is fixed exactly. Every
/// square is a cell; its nodes are numbered along x first, from below. A space as described in spaces.hpp.
template <int space_dim>
class BSplineSpace : public GridWithNodes<space_dim, 2> {
public:
  static constexpr int dim = space_dim;
  static constexpr int max_nodes = dim == 2 ? 9 : 27;
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using GridWithNodes<dim, 2>::GridWithNodes;

  [[nodiscard]] int n_cells() const { return this->n_squares(); }
  [[nodiscard]] double cell_volume() const { return this->square_volume(); } ///< area [m2] in 2-D
  /// With mass lumped, the fastest vibration of a line of squares filled evenly is at most sqrt(6) c / h (one square
  /// with free ends; sqrt(3/2) c / h far from the ends), c the wave speed and h the size: 2 c / frequency [m].
  [[nodiscard]] double shortest_length() const { return 2.0 / std::sqrt(6.0) * this->size(); }
  [[nodiscard]] int column_of(int cell) const { return this->column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return this->row_of_square(cell); }

  /// The corners and middles of the outer squares' sides, and the centres of the squares.
  [[nodiscard]] Vector<dim> node_position(int node) const {
    const PerAxis<int, dim> index = this->node_numbering().index(node);
    Vector<dim> local;
    for (std::size_t d = 0; d < dim; ++d)
      local[static_cast<int>(d)] = greville(index[d], this->squares().counts[d]);
    return this->origin() + this->size() * local;
  }

  [[nodiscard]] int locate(const Vector<dim>& x) const { return this->place(x).square; }
  [[nodiscard]] Stencil stencil(int cell, const Points<dim>& points, std::size_t p) const {
    return stencil_at(cell, points.position_of(p));
  }
  /// At x in the cell.
  [[nodiscard]] Stencil stencil_at(int cell, const Vector<dim>& x) const {
    const PerAxis<int, dim> square = this->squares().index(cell);
    const Vector<dim> local = this->place_in(square, x);
    return product(square, [&](std::size_t d, const Ends& ends) { return at(local[static_cast<int>(d)], ends); });
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return product(this->squares().index(cell), [](std::size_t, const Ends& ends) { return average(ends); });
  }

private:
  using Line = LineFunctions<3>; ///< the functions of a square along one axis
  /// Lengths of the outer two functions' supports up to the far side of a square, in squares: 2, but 1 at a side of the
  /// grid.
  struct Ends {
    double lower, upper;
  };

  static double greville(int i, int n) { return i == 0 ? 0.0 : i == n + 1 ? n : i - 0.5; }
  static Ends ends(int square, int n) { return {square == 0 ? 1.0 : 2.0, square == n - 1 ? 1.0 : 2.0}; }
  static Line line(double lower, double upper, double lower_slope, double upper_slope) {
    return {0, {lower, 1.0 - lower - upper, upper}, {lower_slope, -lower_slope - upper_slope, upper_slope}};
  }
  static Line at(double s, const Ends& e) {
    return line((1 - s) * (1 - s) / e.lower, s * s / e.upper, -2 * (1 - s) / e.lower, 2 * s / e.upper);
  }
  static Line average(const Ends& e) { return line(1 / (3 * e.lower), 1 / (3 * e.upper), -1 / e.lower, 1 / e.upper); }

  /// `line_along(axis, ends)`: the functions along one axis.
  template <class LineAlong>
  [[nodiscard]] Stencil product(const PerAxis<int, dim>& square, LineAlong&& line_along) const {
    PerAxis<Line, dim> lines;
    for (std::size_t d = 0; d < dim; ++d) {
      lines[d] = line_along(d, ends(square[d], this->squares().counts[d]));
      lines[d].first = square[d];
    }
    Stencil stencil;
    multiply(lines, this->node_numbering(), this->inverse_size(), stencil);
    return stencil;
  }
};

} // namespace settle::mpm
