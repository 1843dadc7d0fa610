/// \file
/// Bilinear quadrilaterals and trilinear hexahedra: every square (or cube) is a cell.
#pragma once

#include "settle/mpm/stencil.hpp"
#include "settle/mpm/tensor_product.hpp"

namespace settle::mpm {

/// Cell s is square s; its nodes are numbered along x first, from below. A space as described in spaces.hpp.
template <int space_dim>
class BoxSpace : public CornerNodes<space_dim> {
public:
  static constexpr int dim = space_dim;
  static constexpr int max_nodes = 1 << dim;
  static constexpr int cells_per_square = 1;
  static constexpr bool has_constant_gradients = false;
  static constexpr bool has_domains = false;
  using Stencil = mpm::Stencil<dim, max_nodes>;
  using CornerNodes<dim>::CornerNodes;

  [[nodiscard]] int n_cells() const { return this->n_squares(); }
  [[nodiscard]] double cell_volume() const { return this->square_volume(); } ///< area [m2] in 2-D
  [[nodiscard]] double shortest_length() const { return this->size(); }      ///< [m]
  [[nodiscard]] int column_of(int cell) const { return this->column_of_square(cell); }
  [[nodiscard]] int row_of(int cell) const { return this->row_of_square(cell); }

  [[nodiscard]] int locate(const Vector<dim>& x) const { return this->place(x).square; }
  [[nodiscard]] Stencil stencil(int cell, const Points<dim>& points, std::size_t p) const {
    return stencil_at(cell, points.position_of(p));
  }
  [[nodiscard]] Stencil cell_average(int cell) const {
    return product(this->squares().index(cell), Vector<dim>::Constant(0.5));
  }
  /// At x, which need not lie in the cell.
  [[nodiscard]] Stencil stencil_at(int cell, const Vector<dim>& x) const {
    const PerAxis<int, dim> square = this->squares().index(cell);
    return product(square, this->place_in(square, x));
  }

private:
  [[nodiscard]] Stencil product(const PerAxis<int, dim>& square, const Vector<dim>& local) const {
    PerAxis<LineFunctions<2>, dim> lines;
    for (std::size_t d = 0; d < dim; ++d) {
      const double s = local[static_cast<int>(d)];
      lines[d] = {square[d], {1 - s, s}, {-1, 1}};
    }
    Stencil stencil;
    multiply(lines, this->node_numbering(), this->inverse_size(), stencil);
    return stencil;
  }
};

using QuadrilateralSpace = BoxSpace<2>;
using HexahedronSpace = BoxSpace<3>;

} // namespace settle::mpm
