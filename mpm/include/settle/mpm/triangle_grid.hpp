/// \file
/// The structured background grid of linear triangles: squares, each cut along the diagonal that falls to the right.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Thrown when a point is outside the grid.
class PointLost : public exchange::Error {
public:
  PointLost(std::uint64_t id, double x, double y, double width, double height);
};

/// `columns` x `rows` squares of side `size` from the origin. Square (i, j) holds cell 2(i + columns j), its lower left
/// triangle, and the cell after it, its upper right one. No connectivity in memory: everything follows from indices.
class TriangleGrid {
public:
  static constexpr int dim = 2;
  static constexpr int nodes_per_cell = 3;
  using Nodes = std::array<int, nodes_per_cell>;
  using Values = std::array<double, nodes_per_cell>;
  using Gradients = Eigen::Matrix<double, dim, nodes_per_cell>;

  TriangleGrid(int columns, int rows, double size);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double size() const { return size_; } ///< side of a square [m]
  [[nodiscard]] double width() const { return columns_ * size_; }
  [[nodiscard]] int n_nodes() const { return (columns_ + 1) * (rows_ + 1); }
  [[nodiscard]] int n_cells() const { return 2 * columns_ * rows_; }
  [[nodiscard]] double cell_volume() const { return 0.5 * size_ * size_; }          ///< area of a triangle [m2]
  [[nodiscard]] double shortest_altitude() const { return size_ / std::sqrt(2.0); } ///< [m]

  [[nodiscard]] int column_of(int cell) const { return (cell / 2) % columns_; }
  [[nodiscard]] int row_of(int cell) const { return (cell / 2) / columns_; }
  /// The cell that holds x, or -1 outside the grid.
  [[nodiscard]] int locate(const Vector<2>& x) const {
    const double sx = x[0] * inverse_size_, sy = x[1] * inverse_size_;
    const int i = static_cast<int>(std::floor(sx)), j = static_cast<int>(std::floor(sy));
    if (i < 0 || j < 0 || i >= columns_ || j >= rows_) return -1;
    return 2 * (i + columns_ * j) + ((sx - i) + (sy - j) > 1.0 ? 1 : 0);
  }
  [[nodiscard]] Nodes nodes(int cell) const {
    const int corner = column_of(cell) + (columns_ + 1) * row_of(cell);
    if (is_upper(cell)) return {corner + columns_ + 2, corner + columns_ + 1, corner + 1};
    return {corner, corner + 1, corner + columns_ + 1};
  }
  /// Values of the cell's shape functions at x.
  [[nodiscard]] Values values(int cell, const Vector<2>& x) const {
    const double sx = x[0] * inverse_size_ - column_of(cell), sy = x[1] * inverse_size_ - row_of(cell);
    const double xi = is_upper(cell) ? 1.0 - sx : sx, eta = is_upper(cell) ? 1.0 - sy : sy;
    return {1.0 - xi - eta, xi, eta};
  }
  /// Gradients of the cell's shape functions, one column a node [1/m].
  [[nodiscard]] const Gradients& gradients(int cell) const { return gradients_[is_upper(cell) ? 1 : 0]; }
  [[nodiscard]] Vector<2> node_position(int node) const {
    return {(node % (columns_ + 1)) * size_, (node / (columns_ + 1)) * size_};
  }

private:
  static bool is_upper(int cell) { return (cell & 1) != 0; }

  int columns_, rows_;
  double size_, inverse_size_;
  std::array<Gradients, 2> gradients_;
};

} // namespace settle::mpm
