/// \file
/// Linear triangles: squares, each cut along the diagonal that falls to the right.
#pragma once

#include <array>
#include <cmath>

#include "settle/mpm/square_grid.hpp"
#include "settle/mpm/stencil.hpp"

namespace settle::mpm {

/// Square s holds cell 2 s, its lower left triangle, and the cell after it, its upper right one. A space as described
/// in spaces.hpp.
class TriangleSpace : public CornerNodes<2> {
public:
  static constexpr int max_nodes = 3;
  static constexpr int cells_per_square = 2;
  static constexpr bool has_constant_gradients = true;
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using Nodes = std::array<int, max_nodes>;
  using Values = std::array<double, max_nodes>;
  using Gradients = Stencil::Gradients;

  explicit TriangleSpace(const GridBox<2>& box);

  [[nodiscard]] int n_cells() const { return cells_per_square * n_squares(); }
  [[nodiscard]] double cell_volume() const { return 0.5 * size() * size(); }       ///< area [m2]
  [[nodiscard]] double shortest_length() const { return size() / std::sqrt(2.0); } ///< the shortest altitude [m]
  [[nodiscard]] int column_of(int cell) const { return column_of_square(cell / cells_per_square); }
  [[nodiscard]] int row_of(int cell) const { return row_of_square(cell / cells_per_square); }

  [[nodiscard]] int locate(const Vector<2>& x) const {
    const auto [square, local] = place(x);
    if (square < 0) return -1;
    return cells_per_square * square + (local[0] + local[1] > 1.0 ? 1 : 0);
  }
  [[nodiscard]] Stencil stencil(int cell, const Points<2>& points, std::size_t p) const {
    return {nodes(cell), values(cell, points.position_of(p)), gradients(cell)};
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return {nodes(cell), {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, gradients(cell)};
  }

  [[nodiscard]] Nodes nodes(int cell) const {
    const int lower_left = node_numbering().number(squares().index(cell / cells_per_square));
    const int upper_left = lower_left + node_columns();
    if (is_upper(cell)) return {upper_left + 1, upper_left, lower_left + 1};
    return {lower_left, lower_left + 1, upper_left};
  }
  /// Values of the cell's shape functions at x.
  [[nodiscard]] Values values(int cell, const Vector<2>& x) const {
    const Vector<2> local = place_in(squares().index(cell / cells_per_square), x);
    const double xi = is_upper(cell) ? 1.0 - local[0] : local[0], eta = is_upper(cell) ? 1.0 - local[1] : local[1];
    return {1.0 - xi - eta, xi, eta};
  }
  /// Gradients of the cell's shape functions, one column a node [1/m].
  [[nodiscard]] const Gradients& gradients(int cell) const { return gradients_[is_upper(cell) ? 1 : 0]; }

private:
  static bool is_upper(int cell) { return (cell & 1) != 0; }

  std::array<Gradients, 2> gradients_;
};

} // namespace settle::mpm
