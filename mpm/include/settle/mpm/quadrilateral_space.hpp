/// \file
/// Bilinear quadrilaterals: every square is a cell.
#pragma once

#include <array>

#include "settle/mpm/square_grid.hpp"
#include "settle/mpm/stencil.hpp"

namespace settle::mpm {

/// Cell s is square s; its nodes are numbered row by row, from the lower left. A space as described in spaces.hpp.
class QuadrilateralSpace : public CornerNodes {
public:
  static constexpr int max_nodes = 4;
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using Nodes = std::array<int, max_nodes>;
  using CornerNodes::CornerNodes;

  [[nodiscard]] int n_cells() const { return n_squares(); }
  [[nodiscard]] double cell_volume() const { return size() * size(); } ///< area [m2]
  [[nodiscard]] double shortest_length() const { return size(); }      ///< [m]
  [[nodiscard]] int column_of(int cell) const { return column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return row_of_square(cell); }

  [[nodiscard]] int locate(const Vector<2>& x) const { return place(x).square; }
  [[nodiscard]] Stencil stencil(int cell, const Points<2>& points, std::size_t p) const {
    return stencil_at(cell, points.position_of(p));
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return stencil_at(cell, corner(column_of(cell), row_of(cell)) + Vector<2>::Constant(0.5 * size()));
  }

  [[nodiscard]] Nodes nodes(int cell) const {
    const int lower_left = first_node(cell), upper_left = lower_left + node_columns();
    return {lower_left, lower_left + 1, upper_left, upper_left + 1};
  }
  /// At x, which need not lie in the cell.
  [[nodiscard]] Stencil stencil_at(int cell, const Vector<2>& x) const {
    const auto [square, xi, eta] = place_in(cell, x);
    const double g = inverse_size();
    Stencil s{nodes(cell), {(1 - xi) * (1 - eta), xi * (1 - eta), (1 - xi) * eta, xi * eta}, {}};
    s.gradients << -g * (1 - eta), g * (1 - eta), -g * eta, g * eta, //
        -g * (1 - xi), -g * xi, g * (1 - xi), g * xi;
    return s;
  }
};

} // namespace settle::mpm
