/// \file
/// Shape functions that are products of functions of one coordinate each.
#pragma once

#include <array>

#include "settle/mpm/square_grid.hpp"

namespace settle::mpm {

/// base^exponent.
template <int exponent>
constexpr int power(int base) {
  int product = 1;
  for (int i = 0; i < exponent; ++i)
    product *= base;
  return product;
}

/// A product in progress: of functions along the last axes.
template <std::size_t dim>
struct PartialProduct {
  int node = 0;
  double value = 1.0;
  std::array<double, dim> gradient; ///< by the local coordinates
};

/// All products of `outer` with functions along the axes up to `axis`, the functions along x running fastest.
template <std::size_t axis, class Stencil, class Line, std::size_t dim>
void multiply_along(const std::array<Line, dim>& lines, const BoxNumbering<static_cast<int>(dim)>& nodes,
                    const PartialProduct<dim>& outer, double inverse_size, int& size, Stencil& stencil) {
  const Line& line = lines[axis];
  for (int j = 0; j < line.count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    PartialProduct<dim> product = outer;
    product.node = line.first + j + nodes.counts[axis] * outer.node;
    product.value *= line.values[k];
    for (std::size_t d = 0; d < dim; ++d)
      product.gradient[d] *= d == axis ? line.slopes[k] : line.values[k];
    if constexpr (axis > 0) {
      multiply_along<axis - 1>(lines, nodes, product, inverse_size, size, stencil);
    } else {
      stencil.nodes[static_cast<std::size_t>(size)] = product.node;
      stencil.values[static_cast<std::size_t>(size)] = product.value;
      for (std::size_t d = 0; d < dim; ++d)
        stencil.gradients(static_cast<int>(d), size) = inverse_size * product.gradient[d];
      ++size;
    }
  }
}

/// The products of one function for each axis as the first entries of a stencil, the number of which is returned; the
/// functions along x run fastest. `nodes` numbers the nodes, `inverse_size` [1/m] is that of a square.
template <class Stencil, class Line, std::size_t dim>
int multiply(const std::array<Line, dim>& lines, const BoxNumbering<static_cast<int>(dim)>& nodes, double inverse_size,
             Stencil& stencil) {
  PartialProduct<dim> one;
  one.gradient.fill(1.0);
  int size = 0;
  multiply_along<dim - 1>(lines, nodes, one, inverse_size, size, stencil);
  return size;
}

} // namespace settle::mpm
