/// \file
/// The structured background grid of squares, in 3-D of cubes, that every space is built on.
#pragma once

#include <cmath>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Numbers of things that lie in a box, counts[d] of them along axis d: along x first, the vertical axis last. What
/// stands above each other is a column; a row is all that lies at one height.
template <int dim>
struct BoxNumbering {
  PerAxis<int, dim> counts;

  [[nodiscard]] int size() const { return stride(dim); }
  [[nodiscard]] int columns() const { return stride(dim - 1); }
  [[nodiscard]] int rows() const { return counts.back(); }
  /// From one to the next along an axis.
  [[nodiscard]] int stride(int axis) const {
    int stride = 1;
    for (int d = 0; d < axis; ++d)
      stride *= counts[static_cast<std::size_t>(d)];
    return stride;
  }
  [[nodiscard]] int number(const PerAxis<int, dim>& index) const {
    int number = index.back();
    for (std::size_t d = dim - 1; d-- > 0;)
      number = index[d] + counts[d] * number;
    return number;
  }
  [[nodiscard]] PerAxis<int, dim> index(int number) const {
    PerAxis<int, dim> index;
    for (std::size_t d = 0; d + 1 < dim; ++d) {
      index[d] = number % counts[d];
      number /= counts[d];
    }
    index.back() = number;
    return index;
  }
};

/// Where a grid lies and how fine it is.
template <int dim>
struct GridBox {
  PerAxis<int, dim> counts;                 ///< of squares along each axis
  double size = 1.0;                        ///< side of a square [m]
  Vector<dim> origin = Vector<dim>::Zero(); ///< its corner with the smallest coordinates [m]
};

/// Thrown when a point is outside the grid.
class PointLost : public exchange::Error {
public:
  template <int dim>
  PointLost(std::uint64_t id, const Vector<dim>& position, const GridBox<dim>& box);
};

/// Squares of side `size` in the plane, cubes in space; both are called squares here and in what is built on it. They
/// are numbered along x first, from below. No connectivity in memory: everything follows from indices.
template <int space_dim>
class SquareGrid {
public:
  static constexpr int dim = space_dim;

  explicit SquareGrid(const GridBox<dim>& box) : box_(box), squares_{box.counts}, inverse_size_(1.0 / box.size) {}

  [[nodiscard]] const GridBox<dim>& box() const { return box_; }
  [[nodiscard]] const BoxNumbering<dim>& squares() const { return squares_; }
  [[nodiscard]] int columns() const { return squares_.columns(); } ///< side by side, in 3-D over the whole plan
  [[nodiscard]] int rows() const { return squares_.rows(); }
  [[nodiscard]] double size() const { return box_.size; } ///< side of a square [m]
  [[nodiscard]] const Vector<dim>& origin() const { return box_.origin; }
  [[nodiscard]] double extent(int axis) const { return box_.counts[static_cast<std::size_t>(axis)] * size(); } ///< [m]
  [[nodiscard]] double width() const { return extent(0); }
  [[nodiscard]] double height() const { return extent(dim - 1); }
  /// Of one column of squares in plan: its width [m] in 2-D, its area [m2] in 3-D.
  [[nodiscard]] double column_area() const { return dim == 2 ? size() : size() * size(); }
  [[nodiscard]] double plan_area() const { return columns() * column_area(); }  ///< of the whole grid
  [[nodiscard]] double square_volume() const { return column_area() * size(); } ///< area [m2] in 2-D
  [[nodiscard]] int n_squares() const { return squares_.size(); }
  [[nodiscard]] int column_of_square(int square) const { return square % columns(); }
  [[nodiscard]] int row_of_square(int square) const { return square / columns(); }
  /// The corner with the smallest coordinates of square (column, row), which may lie above the grid [m].
  [[nodiscard]] Vector<dim> corner(int column, int row) const {
    return corner(squares_.index(column + columns() * row));
  }
  [[nodiscard]] Vector<dim> corner(const PerAxis<int, dim>& index) const {
    Vector<dim> corner;
    for (int d = 0; d < dim; ++d)
      corner[d] = box_.origin[d] + size() * index[static_cast<std::size_t>(d)];
    return corner;
  }

protected:
  /// A place in a square: its number, -1 outside the grid, and the local coordinates in it, 0 ... 1.
  struct Place {
    int square;
    Vector<dim> local;
  };
  [[nodiscard]] Place place(const Vector<dim>& x) const {
    Place place;
    PerAxis<int, dim> index;
    bool inside = true;
    for (int d = 0; d < dim; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      const double scaled = (x[d] - box_.origin[d]) * inverse_size_;
      index[axis] = static_cast<int>(std::floor(scaled));
      inside = inside && index[axis] >= 0 && index[axis] < box_.counts[axis];
      place.local[d] = scaled - index[axis];
    }
    place.square = inside ? squares_.number(index) : -1;
    return place;
  }
  /// Local coordinates of x in a square that need not hold it.
  [[nodiscard]] Vector<dim> place_in(const PerAxis<int, dim>& square, const Vector<dim>& x) const {
    Vector<dim> local;
    for (int d = 0; d < dim; ++d)
      local[d] = (x[d] - box_.origin[d]) * inverse_size_ - square[static_cast<std::size_t>(d)];
    return local;
  }
  [[nodiscard]] double inverse_size() const { return inverse_size_; }

private:
  GridBox<dim> box_;
  BoxNumbering<dim> squares_;
  double inverse_size_;
};

/// A grid with its nodes on lines, from side to side, as many along an axis as there are squares and `extra_nodes`
/// more: those with the first and last indices lie on the grid's sides.
template <int dim, int extra_nodes>
class GridWithNodes : public SquareGrid<dim> {
public:
  explicit GridWithNodes(const GridBox<dim>& box) : SquareGrid<dim>(box), nodes_{box.counts} {
    for (int& count : nodes_.counts)
      count += extra_nodes;
  }

  [[nodiscard]] const BoxNumbering<dim>& node_numbering() const { return nodes_; }
  [[nodiscard]] int node_columns() const { return nodes_.columns(); }
  [[nodiscard]] int node_rows() const { return nodes_.rows(); }
  [[nodiscard]] int n_nodes() const { return nodes_.size(); }

private:
  BoxNumbering<dim> nodes_;
};

/// A grid whose nodes are the corners of the squares.
template <int dim>
class CornerNodes : public GridWithNodes<dim, 1> {
public:
  using GridWithNodes<dim, 1>::GridWithNodes;

  [[nodiscard]] Vector<dim> node_position(int node) const { return this->corner(this->node_numbering().index(node)); }
};

} // namespace settle::mpm
