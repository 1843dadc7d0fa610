/// \file
/// Quadratic B-splines on squares, clamped at the grid's sides.
#pragma once

#include <array>

#include "settle/mpm/square_grid.hpp"
#include "settle/mpm/stencil.hpp"

namespace settle::mpm {

/// Tensor products of quadratic B-splines on the lines between the squares, the first and the last of which are knots
/// three times over (open knot vector; de Boor 1978). A line of n squares carries n + 2 functions, three in each
/// square. They sum to one and reproduce linear fields of the node positions (Greville's); on a side of the grid only
/// the functions of the nodes on that side differ from zero, so that what a support fixes there is fixed exactly. Every
/// square is a cell; its nodes are numbered row by row, from the lower left. A space as described in spaces.hpp.
class BSplineSpace : public SquareGrid {
public:
  static constexpr int max_nodes = 9;
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using SquareGrid::SquareGrid;

  [[nodiscard]] int n_cells() const { return n_squares(); }
  [[nodiscard]] double cell_volume() const { return size() * size(); } ///< area [m2]
  /// With mass lumped, the fastest vibration of a line of squares filled evenly is at most sqrt(6) c / h (one square
  /// with free ends; sqrt(3/2) c / h far from the ends), c the wave speed and h the size: 2 c / frequency [m].
  [[nodiscard]] double shortest_length() const { return 2.0 / std::sqrt(6.0) * size(); }
  [[nodiscard]] int column_of(int cell) const { return column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return row_of_square(cell); }

  [[nodiscard]] int node_columns() const { return columns() + 2; }
  [[nodiscard]] int node_rows() const { return rows() + 2; }
  [[nodiscard]] int n_nodes() const { return node_columns() * node_rows(); }
  /// The corners and middles of the outer squares' sides, and the centres of the squares.
  [[nodiscard]] Vector<2> node_position(int node) const {
    return origin() +
           size() * Vector<2>(greville(node % node_columns(), columns()), greville(node / node_columns(), rows()));
  }

  [[nodiscard]] int locate(const Vector<2>& x) const { return place(x).square; }
  [[nodiscard]] Stencil stencil(int cell, const Points<2>& points, std::size_t p) const {
    return stencil_at(cell, points.position_of(p));
  }
  /// At x in the cell.
  [[nodiscard]] Stencil stencil_at(int cell, const Vector<2>& x) const {
    const auto [square, xi, eta] = place_in(cell, x);
    return product(cell, at(xi, ends(column_of(cell), columns())), at(eta, ends(row_of(cell), rows())));
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return product(cell, average(ends(column_of(cell), columns())), average(ends(row_of(cell), rows())));
  }

private:
  /// The three functions of a square along one axis: values and derivatives by the local coordinate.
  struct Line {
    std::array<double, 3> values, slopes;
  };
  /// Lengths of the outer two functions' supports up to the far side of a square, in squares: 2, but 1 at a side of the
  /// grid.
  struct Ends {
    double lower, upper;
  };

  static double greville(int i, int n) { return i == 0 ? 0.0 : i == n + 1 ? n : i - 0.5; }
  static Ends ends(int square, int n) { return {square == 0 ? 1.0 : 2.0, square == n - 1 ? 1.0 : 2.0}; }
  static Line line(double lower, double upper, double lower_slope, double upper_slope) {
    return {{lower, 1.0 - lower - upper, upper}, {lower_slope, -lower_slope - upper_slope, upper_slope}};
  }
  static Line at(double s, const Ends& e) {
    return line((1 - s) * (1 - s) / e.lower, s * s / e.upper, -2 * (1 - s) / e.lower, 2 * s / e.upper);
  }
  static Line average(const Ends& e) { return line(1 / (3 * e.lower), 1 / (3 * e.upper), -1 / e.lower, 1 / e.upper); }

  [[nodiscard]] Stencil product(int cell, const Line& x, const Line& y) const {
    const int first = column_of(cell) + node_columns() * row_of(cell);
    Stencil s;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = i + 3 * j;
        s.nodes[k] = first + static_cast<int>(i) + node_columns() * static_cast<int>(j);
        s.values[k] = x.values[i] * y.values[j];
        s.gradients.col(static_cast<int>(k)) =
            inverse_size() * Vector<2>(x.slopes[i] * y.values[j], x.values[i] * y.slopes[j]);
      }
    return s;
  }
};

} // namespace settle::mpm
