/// \file
/// Linear tetrahedra: cubes, each cut into six around one of its diagonals.
#pragma once

#include <array>
#include <cmath>

#include "settle/mpm/square_grid.hpp"
#include "settle/mpm/stencil.hpp"

namespace settle::mpm {

/// A cube is cut along the diagonal that rises along every axis into the six tetrahedra in which its local coordinates
/// have one order (Kuhn 1960); all cubes alike, so that faces match. Cube s holds the cells 6 s ... 6 s + 5. The nodes
/// of a cell lead from the lowest corner of the cube along its edges to the highest one, along the axis of the largest
/// local coordinate first. A space as described in spaces.hpp.
class TetrahedronSpace : public CornerNodes<3> {
public:
  static constexpr int max_nodes = 4;
  static constexpr int cells_per_square = 6;
  static constexpr bool has_constant_gradients = true;
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using Nodes = std::array<int, max_nodes>;
  using Values = std::array<double, max_nodes>;
  using Gradients = Stencil::Gradients;
  /// Axes by falling local coordinate, of each tetrahedron of a cube.
  static constexpr std::array<PerAxis<int, 3>, cells_per_square> orders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

  explicit TetrahedronSpace(const GridBox<3>& box);

  [[nodiscard]] int n_cells() const { return cells_per_square * n_squares(); }
  [[nodiscard]] double cell_volume() const { return square_volume() / cells_per_square; } ///< [m3]
  /// With its mass lumped, a single tetrahedron vibrates with at most sqrt(8 + 4 sqrt 2) c / h, c the wave speed and h
  /// the size, and no grid of them faster than its fastest: 2 c / frequency [m].
  [[nodiscard]] double shortest_length() const { return 2.0 / std::sqrt(8.0 + 4.0 * std::sqrt(2.0)) * size(); }
  [[nodiscard]] int column_of(int cell) const { return column_of_square(cell / cells_per_square); }
  [[nodiscard]] int row_of(int cell) const { return row_of_square(cell / cells_per_square); }

  [[nodiscard]] int locate(const Vector<3>& x) const {
    const auto [square, local] = place(x);
    return square < 0 ? -1 : cells_per_square * square + which(local);
  }
  [[nodiscard]] Stencil stencil(int cell, const Points<3>& points, std::size_t p) const {
    return {nodes(cell), values(cell, points.position_of(p)), gradients(cell)};
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return {nodes(cell), {0.25, 0.25, 0.25, 0.25}, gradients(cell)};
  }

  [[nodiscard]] Nodes nodes(int cell) const {
    const PerAxis<int, 3>& order = order_of(cell);
    Nodes nodes;
    nodes[0] = node_numbering().number(squares().index(cell / cells_per_square));
    for (std::size_t k = 0; k < 3; ++k)
      nodes[k + 1] = nodes[k] + node_numbering().stride(order[k]);
    return nodes;
  }
  /// Values of the cell's shape functions at x.
  [[nodiscard]] Values values(int cell, const Vector<3>& x) const {
    const Vector<3> local = place_in(squares().index(cell / cells_per_square), x);
    const PerAxis<int, 3>& order = order_of(cell);
    const double first = local[order[0]], second = local[order[1]], third = local[order[2]];
    return {1.0 - first, first - second, second - third, third};
  }
  /// Gradients of the cell's shape functions, one column a node [1/m].
  [[nodiscard]] const Gradients& gradients(int cell) const { return gradients_[which(cell)]; }

private:
  static std::size_t which(int cell) { return static_cast<std::size_t>(cell % cells_per_square); }
  static const PerAxis<int, 3>& order_of(int cell) { return orders[which(cell)]; }
  /// The tetrahedron with this order of local coordinates.
  static int which(const Vector<3>& local) {
    const bool xy = local[0] >= local[1], yz = local[1] >= local[2], xz = local[0] >= local[2];
    if (xy) return yz ? 0 : xz ? 1 : 4;
    return xz ? 2 : yz ? 3 : 5;
  }

  std::array<Gradients, cells_per_square> gradients_;
};

} // namespace settle::mpm
