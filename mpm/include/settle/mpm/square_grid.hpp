/// \file
/// The structured background grid of squares that every space is built on.
#pragma once

#include <cmath>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Where a grid lies and how fine it is.
struct GridBox {
  int columns = 1, rows = 1;
  double size = 1.0;                    ///< side of a square [m]
  Vector<2> origin = Vector<2>::Zero(); ///< lower left corner [m]
};

/// Thrown when a point is outside the grid.
class PointLost : public exchange::Error {
public:
  PointLost(std::uint64_t id, const Vector<2>& position, const GridBox& box);
};

/// `columns` x `rows` squares of side `size`. Square (i, j) has the index i + columns j. No connectivity in memory:
/// everything follows from indices.
class SquareGrid {
public:
  static constexpr int dim = 2;

  explicit SquareGrid(const GridBox& box) : box_(box), inverse_size_(1.0 / box.size) {}

  [[nodiscard]] const GridBox& box() const { return box_; }
  [[nodiscard]] int columns() const { return box_.columns; }
  [[nodiscard]] int rows() const { return box_.rows; }
  [[nodiscard]] double size() const { return box_.size; } ///< side of a square [m]
  [[nodiscard]] const Vector<2>& origin() const { return box_.origin; }
  [[nodiscard]] double width() const { return columns() * size(); }
  [[nodiscard]] double height() const { return rows() * size(); }
  [[nodiscard]] int n_squares() const { return columns() * rows(); }
  [[nodiscard]] int column_of_square(int square) const { return square % columns(); }
  [[nodiscard]] int row_of_square(int square) const { return square / columns(); }
  /// Lower left corner of square (column, row), inside the grid or not [m].
  [[nodiscard]] Vector<2> corner(int column, int row) const { return origin() + size() * Vector<2>(column, row); }

protected:
  /// A place in a square: its index, -1 outside the grid, and the local coordinates in it, 0 ... 1.
  struct Place {
    int square;
    double xi, eta;
  };
  [[nodiscard]] Place place(const Vector<2>& x) const {
    const double sx = (x[0] - box_.origin[0]) * inverse_size_, sy = (x[1] - box_.origin[1]) * inverse_size_;
    const int i = static_cast<int>(std::floor(sx)), j = static_cast<int>(std::floor(sy));
    const bool inside = i >= 0 && j >= 0 && i < box_.columns && j < box_.rows;
    return {inside ? i + box_.columns * j : -1, sx - i, sy - j};
  }
  /// Local coordinates of x in a square that need not hold it.
  [[nodiscard]] Place place_in(int square, const Vector<2>& x) const {
    return {square, (x[0] - box_.origin[0]) * inverse_size_ - column_of_square(square),
            (x[1] - box_.origin[1]) * inverse_size_ - row_of_square(square)};
  }
  [[nodiscard]] double inverse_size() const { return inverse_size_; }

private:
  GridBox box_;
  double inverse_size_;
};

/// A space whose nodes are the corners of the squares.
class CornerNodes : public SquareGrid {
public:
  using SquareGrid::SquareGrid;

  /// Nodes lie in columns and rows: node = column + node_columns() row. The first and the last of each lie on the
  /// grid's sides.
  [[nodiscard]] int node_columns() const { return columns() + 1; }
  [[nodiscard]] int node_rows() const { return rows() + 1; }
  [[nodiscard]] int n_nodes() const { return node_columns() * node_rows(); }
  [[nodiscard]] Vector<2> node_position(int node) const { return corner(node % node_columns(), node / node_columns()); }

protected:
  /// The node at the lower left corner of a square.
  [[nodiscard]] int first_node(int square) const {
    return column_of_square(square) + node_columns() * row_of_square(square);
  }
};

} // namespace settle::mpm
