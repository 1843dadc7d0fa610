/// \file
/// What a space gives at a point: the nodes there, the values of their shape functions and the gradients.
#pragma once

#include <array>
#include <cstddef>

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Which nodes the stencils of one cell's points name.
enum class StencilNodes {
  of_the_cell, ///< all the same, in the same order, as many as the capacity
  of_the_point ///< each its own, as many as it has: how many, and which, changes as the point moves
};

/// Up to `capacity` nodes with values [-] and gradients [1/m], one column a node. Entries beyond `size()` are unused.
template <int dim, int capacity, StencilNodes kind = StencilNodes::of_the_cell>
struct Stencil {
  static constexpr bool is_shared = kind == StencilNodes::of_the_cell;
  using Gradients = Eigen::Matrix<double, dim, capacity>;

  std::array<int, static_cast<std::size_t>(capacity)> nodes;
  std::array<double, static_cast<std::size_t>(capacity)> values;
  Gradients gradients;
  int count = capacity; ///< only looked at where stencils are the points' own

  [[nodiscard]] constexpr int size() const {
    if constexpr (is_shared) return capacity;
    return count;
  }
  [[nodiscard]] int node(int i) const { return nodes[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double value(int i) const { return values[static_cast<std::size_t>(i)]; }
};

} // namespace settle::mpm
