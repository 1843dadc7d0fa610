/// \file
/// Linear triangles and tetrahedra: from the points to the nodes.
#pragma once

#include "node_sums.hpp"
#include "simplices.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Cut, Weight weight>
struct SimplexScatter : Simplices<Cut> {
  using Cells = Simplices<Cut>;
  using Cells::dim, Cells::per_square, Cells::n_nodes;
  using SumBlock = typename Cells::PointBlock;
  using Array = NodeArrays<dim>;
  static constexpr int count = Cells::sums_of(weight);

  template <int n, class Values, class Put>
  SETTLE_INLINE static void products(const Step& step, const Values& points, int first, Put&& put) {
    Lanes value[n_nodes][n], share[n_nodes][n];
    const auto of = [&](int k, int slot) -> const Lanes& { return points.of[k][first + slot]; };
    for (int slot = 0; slot < n; ++slot) {
      Lanes x[dim];
      for (int d = 0; d < dim; ++d)
        x[d] = of(Values::position + d, slot);
      const auto at = Cut::locate(step, x);
      for (int i = 0; i < n_nodes; ++i)
        value[i][slot] = at.value[i], share[i][slot] = of(Values::mass, slot) * at.value[i];
    }
    for (int i = 0; i < n_nodes; ++i)
      for (int j = i; j < n_nodes; ++j)
        put(sum_of_slots<n>([&](int slot) { return share[i][slot] * value[j][slot]; }));
    const auto put_values = [&](int k) {
      for (int i = 0; i < n_nodes; ++i)
        put(sum_of_slots<n>([&](int slot) { return share[i][slot] * of(k, slot); }));
    };
    for (int d = 0; d < dim; ++d)
      put_values(Values::velocity + d);
    put(sum_of_slots<n>([&](int slot) { return of(Values::volume, slot); }));
    for (int k = 0; k < n_felt<dim>; ++k)
      put(sum_of_slots<n>([&](int slot) { return of(Values::volume, slot) * of(Values::stress + k, slot); }));
    for (int k = 0; k < Values::n_pulls; ++k)
      put_values(Values::pull + k);
  }

  /// Results of the cells of the squares s ... s + 7.
  SETTLE_INLINE static void finish(const Step& step, std::size_t s, const CellArrays& cells, Lanes& slowness) {
    Lanes total_volume = all(0.0);
    for (int which = 0; which < per_square; ++which) {
      const auto sum = [&](int k) { return load(cells.quantity(which * count + k) + s); };
      const auto put = [&](int k, const Lanes& lanes) {
        store(cells.quantity(Cells::results + which * Cells::n_results + k) + s, lanes);
      };
      Lanes total_mass = all(0.0);
      for (int i = 0; i < n_nodes; ++i) {
        Lanes lumped = sum(Cells::pair(i, 0));
        for (int j = 1; j < n_nodes; ++j)
          lumped += sum(Cells::pair(i, j));
        put(Cells::lumped + i, lumped);
        total_mass += lumped;
      }
      const Lanes v = sum(Cells::volume);
      total_volume += v;
      const Lanes own = slowness_of(step, total_mass, v, cells.quantity(Cells::largest_stress + which) + s);
      slowness = own < slowness ? own : slowness;
      const Lanes factor = volume_ratio_of(step, v) * step.inverse_size;
      Lanes stress[n_stresses<dim>];
      for (int k = 0; k < n_felt<dim>; ++k)
        stress[felt<dim>(k)] = factor * sum(Cells::stress + k);
      for (int d = 0; d < dim; ++d) {
        Lanes force[n_nodes];
        for (int i = 0; i < n_nodes; ++i)
          force[i] = all(0.0);
        for (int axis = 0; axis < dim; ++axis) {
          const auto edge = Cells::edge_along(which, axis);
          force[edge.to] += stress[component<dim>(d, axis)], force[edge.from] -= stress[component<dim>(d, axis)];
        }
        for (int i = 0; i < n_nodes; ++i)
          put(Cells::force + d * n_nodes + i, force[i]);
      }
    }
    store(cells.quantity(Cells::total_volume) + s, total_volume);
  }

  /// To the nodes what cells have for them: `quantity(which, i)` for node i of a square's cell, if it is there (else
  /// -1).
  template <class Quantity>
  SETTLE_INLINE static void add(const Step& step, const CellArrays& cells, const TileNodes& nodes, int array,
                                Quantity&& quantity) {
    for (int line = 0; line < 1 << dim; line += 2) { // of corners along x
      const double* terms[per_square * n_nodes];
      int n_terms = 0;
      for (int which = 0; which < per_square; ++which)
        for (int i = 0; i < n_nodes; ++i) {
          const int corner = Cut::corner[which][i], k = (corner & ~1) == line ? quantity(which, i) : -1;
          if (k >= 0) terms[n_terms++] = cells.quantity(k) - (corner & 1);
        }
      nodes.add(array, Cells::offset_of(step, line), terms, n_terms);
    }
  }

  SETTLE_INLINE static void add_to_nodes(const Step& step, const CellArrays& cells, const TileNodes& nodes) {
    static constexpr Edges edges = Cells::edges();
    const auto add_sums = [&](int array, int first) {
      add(step, cells, nodes, array, [first](int which, int i) { return which * count + first + i; });
    };
    const auto add_results = [&](int array, int first) {
      add(step, cells, nodes, array,
          [first](int which, int i) { return Cells::results + which * Cells::n_results + first + i; });
    };
    add_results(Array::mass, Cells::lumped);
    for (int d = 0; d < dim; ++d) {
      add_sums(Array::momentum + d, Cells::momentum + d * n_nodes);
      add_results(Array::force + d, Cells::force + d * n_nodes);
    }
    for (int k = 0; k * n_nodes < count - Cells::external; ++k)
      add_sums(Array::pull + k, Cells::external + k * n_nodes);
    add(step, cells, nodes, Array::matrix, [](int which, int i) { return which * count + Cells::pair(i, i); });
    for (int e = 0; e < edges.count; ++e)
      add(step, cells, nodes, Array::matrix + 1 + e, [e](int which, int i) {
        for (int j = 0; j < n_nodes; ++j)
          if (Cells::leads(edges.by_axis[e], which, i, j)) return which * count + Cells::pair(i, j);
        return -1;
      });
  }

  static void run(const Step& step, int strip, const Scratch& scratch) {
    const CellArrays cells(step, scratch.cells);
    sum_up<dim, per_square>(step, strip, [&](const Tile& tile, const TileNodes& nodes, Lanes& slowness) {
      CellSums<SimplexScatter, dim, weight>::add_tile(step, tile, scratch.block, cells);
      cells.clear_behind(step, tile, Cells::constants);
      if (step.hyperelastic) find_largest_stress<dim, per_square>(step, tile, cells, Cells::largest_stress);
      for (std::size_t s = 0; s < tile.n_squares; s += n_lanes)
        finish(step, s, cells, slowness);
      add_to_columns(step, strip, tile, cells.quantity(Cells::total_volume));
      add_to_nodes(step, cells, nodes);
    });
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
