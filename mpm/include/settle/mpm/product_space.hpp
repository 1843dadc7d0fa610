/// \file
/// Shape functions that are products of functions of one coordinate, where every square (or cube) is a cell: taken at
/// the point.
#pragma once

#include "settle/mpm/line_functions.hpp"
#include "settle/mpm/stencil.hpp"
#include "settle/mpm/tensor_product.hpp"

namespace settle::mpm {

/// The cells and nodes of products of `Functions`: cell s is square s; its nodes are numbered along x first, from
/// below.
template <int space_dim, class Functions>
class SquareCells : public GridWithNodes<space_dim, Functions::degree> {
public:
  static constexpr int dim = space_dim;
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  using GridWithNodes<dim, Functions::degree>::GridWithNodes;

  [[nodiscard]] int n_cells() const { return this->n_squares(); }
  [[nodiscard]] double cell_volume() const { return this->square_volume(); } ///< area [m2] in 2-D
  [[nodiscard]] double shortest_length() const { return Functions::shortest_length * this->size(); } ///< [m]
  [[nodiscard]] int column_of(int cell) const { return this->column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return this->row_of_square(cell); }
  [[nodiscard]] int locate(const Vector<dim>& x) const { return this->place(x).square; }
  [[nodiscard]] Vector<dim> node_position(int node) const {
    const PerAxis<int, dim> index = this->node_numbering().index(node);
    Vector<dim> local;
    for (std::size_t d = 0; d < dim; ++d)
      local[static_cast<int>(d)] = Functions::node(index[d], this->squares().counts[d]);
    return this->origin() + this->size() * local;
  }

protected:
  /// Products of the averages over the local coordinates from ... to of a square.
  template <class Stencil>
  [[nodiscard]] Stencil average(const PerAxis<int, dim>& square, const Vector<dim>& from, const Vector<dim>& to) const {
    PerAxis<LineFunctions<Functions::degree + 1>, dim> lines;
    for (std::size_t d = 0; d < dim; ++d) {
      const auto axis = static_cast<int>(d);
      lines[d] = Functions::average(square[d], this->squares().counts[d], from[axis], to[axis]);
    }
    Stencil stencil;
    stencil.count = multiply(lines, this->node_numbering(), this->inverse_size(), stencil);
    return stencil;
  }
  template <class Stencil>
  [[nodiscard]] Stencil average_of_cell(int cell) const {
    return average<Stencil>(this->squares().index(cell), Vector<dim>::Zero(), Vector<dim>::Ones());
  }
};

/// Bilinear or trilinear functions, or products of quadratic B-splines. They sum to one and reproduce linear fields of
/// the node positions; on a side of the grid only the functions of the nodes on that side differ from zero, so that
/// what a support fixes there is fixed exactly. A space as described in spaces.hpp.
template <int space_dim, class Functions>
class ProductSpace : public SquareCells<space_dim, Functions> {
public:
  static constexpr int dim = space_dim;
  static constexpr int max_nodes = power<dim>(Functions::degree + 1);
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using SquareCells<dim, Functions>::SquareCells;

  [[nodiscard]] Stencil stencil(int cell, const Points<dim>& points, std::size_t p) const {
    return stencil_at(cell, points.position_of(p));
  }
  /// At x; bilinear and trilinear functions may be asked for outside the cell.
  [[nodiscard]] Stencil stencil_at(int cell, const Vector<dim>& x) const {
    const PerAxis<int, dim> square = this->squares().index(cell);
    const Vector<dim> local = this->place_in(square, x);
    return this->template average<Stencil>(square, local, local);
  }
  [[nodiscard]] Stencil cell_average(int cell) const { return this->template average_of_cell<Stencil>(cell); }
};

template <int dim>
using BoxSpace = ProductSpace<dim, HatFunctions>;
using QuadrilateralSpace = BoxSpace<2>;
using HexahedronSpace = BoxSpace<3>;
template <int dim>
using BSplineSpace = ProductSpace<dim, QuadraticSplines>;

} // namespace settle::mpm
