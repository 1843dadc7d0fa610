/// \file
/// Linear triangles and tetrahedra: what their kernels keep of a cell, and how it is numbered.
#pragma once

#include "cell_sums.hpp"
#include "cuts.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Cut>
struct Simplices : Cut {
  using Cut::dim, Cut::per_square;
  static constexpr int points = dim == 2 ? 3 : 4; ///< that most cells hold
  static constexpr int n_nodes = dim + 1, n_pairs = n_nodes * (n_nodes + 1) / 2;
  using PointBlock = Block<128>;

  /// Sums of a cell: mass by pairs of shape functions, momentum by shape function, volume and the stress that nodes
  /// feel; external force by shape function, along the last axis first.
  static constexpr int mass = 0, momentum = n_pairs, volume = momentum + dim * n_nodes, stress = volume + 1,
                       external = stress + n_felt<dim>;
  static constexpr int sums_of(Weight weight) {
    return external + (weight == Weight::uniform ? 0 : weight == Weight::by_layer ? 1 : 2) * n_nodes;
  }
  static constexpr int most_sums = sums_of(dim == 2 ? Weight::with_force : Weight::by_layer);
  static constexpr int pair(int i, int j) {
    const int low = i < j ? i : j, high = i < j ? j : i;
    return mass + low * (2 * n_nodes - low + 1) / 2 + high - low;
  }

  /// From these, for each cell: mass and internal force by node. For each square: its volume.
  static constexpr int lumped = 0, force = n_nodes, n_results = n_nodes + dim * n_nodes;

  /// Constants of a cell while its points move: velocities gained and displacements, at the first node and the
  /// differences of the others; then a Change, or a Gradient where the law is none of the kernel's.
  static constexpr int kick = 0, move = dim * n_nodes, change = 2 * dim * n_nodes;
  static constexpr int n_changes = dim == 2 ? 1 + n_stresses<2> : dim * dim;
  static constexpr int n_constants = change + n_changes;

  /// In the memory of the squares come: sums, largest stresses, results, volume, constants.
  static constexpr int largest_stress = per_square * most_sums, results = largest_stress + per_square,
                       total_volume = results + per_square * n_results, constants = total_volume + 1,
                       n_quantities = constants + per_square * n_constants;

  /// Is corner k at the upper end along an axis?
  static constexpr int bit(int corner, int axis) { return corner >> axis & 1; }
  /// Nodes of a cell on the edge along an axis: there is one, and the gradient is the difference of its ends.
  struct Edge {
    int from, to;
  };
  static constexpr Edge edge_along(int which, int axis) {
    for (int i = 0; i < n_nodes; ++i)
      for (int j = 0; j < n_nodes; ++j)
        if (Cut::corner[which][j] == Cut::corner[which][i] + (1 << axis) && bit(Cut::corner[which][i], axis) == 0)
          return {i, j};
    return {};
  }
  /// Does an edge lead from node i of a cell to node j?
  static constexpr bool leads(const int edge[3], int which, int i, int j) {
    bool same = true;
    for (int d = 0; d < dim; ++d)
      same = same && bit(Cut::corner[which][j], d) - bit(Cut::corner[which][i], d) == edge[d];
    return same;
  }
  static constexpr Edges edges() {
    Edges edges{};
    for (int which = 0; which < per_square; ++which)
      for (int i = 0; i < n_nodes; ++i)
        for (int j = 0; j < n_nodes; ++j) {
          if (Cut::corner[which][j] <= Cut::corner[which][i]) continue;
          bool known = false;
          for (int e = 0; e < edges.count; ++e)
            known = known || leads(edges.by_axis[e], which, i, j);
          if (known) continue;
          for (int d = 0; d < dim; ++d)
            edges.by_axis[edges.count][d] = bit(Cut::corner[which][j], d) - bit(Cut::corner[which][i], d);
          ++edges.count;
        }
    return edges;
  }
  static constexpr int n_edges = edges().count;

  /// From the lowest corner of a square to another one.
  SETTLE_INLINE static std::size_t offset_of(const Step& step, int corner) {
    int offset = 0;
    for (int d = 0; d < dim; ++d)
      offset += bit(corner, d) * step.node_step[d];
    return static_cast<std::size_t>(offset);
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
