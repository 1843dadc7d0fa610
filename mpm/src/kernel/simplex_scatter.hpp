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
  using Block = typename Cells::PointBlock;
  using Array = NodeArrays<dim>;
  static constexpr int count = Cells::sums_of(weight);

  SETTLE_INLINE static void fill(const Step& step, const PointArrays& points, std::size_t p, int some, double* block) {
    const auto put = [&](const Lanes& lanes) { store(block, lanes), block += Block::pitch; };
    const auto of_point = [&](const double* values) { return load(values + p, some); };
    Lanes x[dim], share[n_nodes];
    for (int d = 0; d < dim; ++d)
      x[d] = of_point(points.position[d]);
    const auto at = Cut::locate(step, x);
    const Lanes mass = of_point(points.mass), volume = of_point(points.volume);
    for (int i = 0; i < n_nodes; ++i)
      share[i] = mass * at.value[i];
    for (int i = 0; i < n_nodes; ++i)
      for (int j = i; j < n_nodes; ++j)
        put(share[i] * at.value[j]);
    const auto put_values = [&](const Lanes& what) {
      for (int i = 0; i < n_nodes; ++i)
        put(share[i] * what);
    };
    for (int d = 0; d < dim; ++d)
      put_values(of_point(points.velocity[d]));
    put(volume);
    for (int k = 0; k < n_felt<dim>; ++k)
      put(volume * of_point(points.stress[felt<dim>(k)]));
    if constexpr (weight == Weight::uniform) return;
    Lanes pull = -gravity_on(step, points.layer + p, some);
    if constexpr (weight == Weight::with_force) pull += of_point(points.force[1]);
    put_values(pull);
    if constexpr (weight == Weight::with_force) put_values(of_point(points.force[0]));
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
    sum_up<dim, per_square>(step, strip, scratch, [&](const Tile& tile, Lanes& slowness) {
      sum_over_cells<per_square, count, 1, Block>(
          step, tile, scratch.block, cells, [&](const PointArrays& points, std::size_t first, int size) {
            for (int q = 0; q < size; q += n_lanes)
              fill(step, points, first + static_cast<std::size_t>(q), size - q, scratch.block + q);
          });
      cells.clear_behind(step, tile, Cells::constants);
      if (step.hyperelastic) find_largest_stress<dim, per_square>(step, tile, cells, Cells::largest_stress);
      for (std::size_t s = 0; s < tile.n_squares; s += n_lanes)
        finish(step, s, cells, slowness);
      add_to_columns(step, strip, tile, cells.quantity(Cells::total_volume));
      add_to_nodes(step, cells, TileNodes(step, tile, scratch.nodes));
    });
    hand_over(step, strip, scratch.nodes);
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
