/// \file
/// Squares and cubes: from the points to the nodes.
#pragma once

#include "box_products.hpp"
#include "node_sums.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Boxes, bool full, Weight weight>
struct BoxScatter : Boxes {
  using Boxes::dim, Boxes::degree, Boxes::n, Boxes::n_nodes, Boxes::n_lines, Boxes::n_squares;
  using Along = typename Boxes::Along;
  using Array = NodeArrays<dim>;
  static constexpr int count = Boxes::sums_of(full, weight);

  /// As CellSums asks; squares have one cell each, so `first` is 0.
  template <int slots, class Values, class Put>
  SETTLE_INLINE static void products(const Step& step, const Values& points, int, Put&& put) {
    BoxSums<Boxes, slots, Values, Put> sums(step, points, put);
    const Lanes *m = points.of[Values::mass], *v = points.of[Values::volume];
    sums.put_squares(m);
    for (int d = 0; d < dim; ++d)
      sums.put_values(m, Values::velocity + d);
    for (int d = 0; d < dim; ++d)
      sums.put_force(v, d);
    if constexpr (full) {
      sums.put_values(v);
      for (int k = 0; k < n_felt<dim>; ++k)
        put(sum_of_slots<slots>([&](int slot) { return v[slot] * points.of[Values::stress + k][slot]; }));
    } else {
      put(sum_of_slots<slots>([&](int slot) { return v[slot]; }));
    }
    for (int k = 0; k < Values::n_pulls; ++k)
      sums.put_values(m, Values::pull + k);
  }

  SETTLE_INLINE static void load_nodes(const CellArrays& cells, int first, std::size_t s, Lanes values[n_nodes]) {
    for (int k = 0; k < n_nodes; ++k)
      values[k] = load(cells.quantity(first + k) + s);
  }
  SETTLE_INLINE static void store_nodes(const CellArrays& cells, int first, std::size_t s,
                                        const Lanes values[n_nodes]) {
    for (int k = 0; k < n_nodes; ++k)
      store(cells.quantity(first + k) + s, values[k]);
  }
  SETTLE_INLINE static void to_functions(const typename Boxes::Functions& at, Lanes values[n_nodes]) {
    Boxes::along_all_axes(at, values, [](const Along& axis, Lanes* v, int step) { axis.to_functions(v, step); });
  }

  /// Numbers by `n_in` along an axis to numbers by `n_out`, `convert(from, to, step)` those of a line; axes before it
  /// have n_out already.
  template <int n_in, int n_out, class Convert>
  SETTLE_INLINE static void convert_axis(int axis, const Lanes* from, Lanes* to, Convert&& convert) {
    const int step = power(n_out, axis);
    for (int high = 0; high < power(n_in, dim - 1 - axis); ++high)
      for (int low = 0; low < step; ++low)
        convert(from + low + step * n_in * high, to + low + step * n_out * high, step);
  }
  template <int n_in, int n_out, class Convert>
  SETTLE_INLINE static void convert_all_axes(const Lanes* from, Lanes* to, Convert&& convert) {
    Lanes other[power(n_in > n_out ? n_in : n_out, dim)];
    for (int axis = 0; axis < dim; ++axis) { // the last axis goes into `to`
      const Lanes* source = axis == 0 ? from : (dim - axis) % 2 == 0 ? to : other;
      Lanes* target = (dim - axis) % 2 == 0 ? other : to;
      convert_axis<n_in, n_out>(axis, source, target,
                                [&](const Lanes* a, Lanes* b, int step) { convert(axis, a, b, step); });
    }
  }

  /// Mass by shape functions, and by pairs of them; all of it.
  SETTLE_INLINE static Lanes spread_mass(const typename Boxes::Functions& at, const CellArrays& cells, std::size_t s) {
    constexpr int larger = Boxes::all_squares > Boxes::all_pairs ? Boxes::all_squares : Boxes::all_pairs;
    Lanes squares[Boxes::all_squares], values[larger];
    for (int k = 0; k < Boxes::all_squares; ++k)
      squares[k] = load(cells.quantity(Boxes::mass + k) + s);
    if constexpr (degree > 1) {
      convert_all_axes<n_squares, Along::n_pairs>(
          squares, values, [&](int axis, const Lanes* a, Lanes* b, int step) { at.along[axis].to_pairs(a, b, step); });
      for (int k = 0; k < Boxes::all_pairs; ++k)
        store(cells.quantity(Boxes::pairs + k) + s, values[k]);
    }
    convert_all_axes<n_squares, n>(
        squares, values, [](int, const Lanes* a, Lanes* b, int step) { Along::squares_to_products(a, b, step); });
    to_functions(at, values);
    store_nodes(cells, Boxes::lumped, s, values);
    Lanes total = all(0.0);
    for (int k = 0; k < n_nodes; ++k)
      total += values[k];
    return total;
  }

  /// Full cells: force of the average stress by what the mean gradients of the points are off by, added to that of the
  /// points; all over the full volume. The means are kept for the motion.
  SETTLE_INLINE static void correct_force(const Step& step, const Tile& tile, std::size_t s, const CellArrays& cells,
                                          const Lanes& v, const Lanes volumes[n_nodes], Lanes force[dim][n_nodes]) {
    const std::size_t square = tile.first_node(step) + s, left = tile.n_squares - s;
    const int some = left < n_lanes ? static_cast<int>(left) : n_lanes;
    const Mask filled = v > 0.0;
    const Lanes inverse = filled ? 1.0 / v : all(0.0);
    Lanes mean[n_nodes];
    for (int k = 0; k < n_nodes; ++k) {
      mean[k] = volumes[k] * inverse;
      store(step.mean + static_cast<std::size_t>(k) * step.mean_stride + square, mean[k], some);
    }
    const auto off = Boxes::offsets(mean);
    const Lanes ratio = volume_ratio_of(step, v);
    Lanes stress[n_stresses<dim>];
    for (int k = 0; k < n_felt<dim>; ++k)
      stress[felt<dim>(k)] = load(cells.quantity(Boxes::stress + k) + s);
    for (int d = 0; d < dim; ++d) {
      for (int axis = 0; axis < dim; ++axis)
        for (int k = 0; k < n_lines; ++k) {
          Lanes slopes[degree];
          for (int i = 0; i < degree; ++i)
            slopes[i] = stress[component<dim>(d, axis)] * off.by[axis][degree * k + i];
          Along::add_derivatives(slopes, force[d] + Boxes::line(k, axis), power(n, axis));
        }
      for (int k = 0; k < n_nodes; ++k)
        force[d][k] *= ratio;
    }
  }

  /// Sums by products to sums by shape functions, for the squares s ... s + 7.
  SETTLE_INLINE static void finish(const Step& step, const Tile& tile, std::size_t s, const CellArrays& cells,
                                   Lanes& slowness) {
    const auto at = Boxes::functions_at(step, tile, s);
    const Lanes total_mass = spread_mass(at, cells, s);
    Lanes volumes[n_nodes], v = load(cells.quantity(Boxes::volume) + s);
    if constexpr (full) {
      load_nodes(cells, Boxes::volume, s, volumes);
      v = all(0.0);
      for (int k = 0; k < n_nodes; ++k) {
        double times = 1.0;
        for (int d = 0; d < dim; ++d)
          times *= Along::binomial(Boxes::digit(k, d));
        v += times * volumes[k];
      }
    }
    store(cells.quantity(Boxes::total_volume) + s, v);
    const Lanes own = slowness_of(step, total_mass, v, cells.quantity(Boxes::largest_stress) + s);
    slowness = own < slowness ? own : slowness;
    const auto convert = [&](int quantity) {
      Lanes values[n_nodes];
      load_nodes(cells, quantity, s, values);
      to_functions(at, values);
      store_nodes(cells, quantity, s, values);
    };
    if constexpr (degree > 1) {
      for (int d = 0; d < dim; ++d)
        convert(Boxes::momentum + d * n_nodes);
      for (int quantity = Boxes::external(full); quantity < count; quantity += n_nodes)
        convert(quantity);
    }
    Lanes force[dim][n_nodes];
    for (int d = 0; d < dim; ++d)
      load_nodes(cells, Boxes::force + d * n_nodes, s, force[d]);
    if constexpr (full) correct_force(step, tile, s, cells, v, volumes, force);
    for (int d = 0; d < dim; ++d) {
      to_functions(at, force[d]);
      for (int k = 0; k < n_nodes; ++k)
        force[d][k] *= step.inverse_size;
      store_nodes(cells, Boxes::force + d * n_nodes, s, force[d]);
    }
  }

  /// To the nodes from a quantity by nodes.
  SETTLE_INLINE static void add_values(const Step& step, const CellArrays& cells, const TileNodes& nodes, int array,
                                       int quantity) {
    for (int k = 0; k < n_lines; ++k) {
      const double* terms[n];
      for (int i = 0; i < n; ++i)
        terms[i] = cells.quantity(quantity + n * k + i) - i;
      nodes.template add<n>(array, offset_of(step, n * k), terms);
    }
  }
  /// From the lowest node of a square to another one of it.
  SETTLE_INLINE static std::size_t offset_of(const Step& step, int node) {
    int offset = 0;
    for (int d = 0; d < dim; ++d)
      offset += Boxes::digit(node, d) * step.node_step[d];
    return static_cast<std::size_t>(offset);
  }
  /// Couplings of the nodes of a square with those an edge away.
  SETTLE_INLINE static void add_couplings(const Step& step, const CellArrays& cells, const TileNodes& nodes, int array,
                                          const int edge[dim]) {
    for (int k = 0; k < n_lines; ++k) {
      int pair = 0;
      bool inside = true;
      for (int d = 1; d < dim; ++d) {
        const int from = Boxes::digit(n * k, d), to = from + edge[d];
        inside = inside && to >= 0 && to < n;
        if (inside) pair += pair_of<degree>(from, to) * power(Along::n_pairs, d);
      }
      if (!inside) continue;
      const double* terms[n];
      int n_terms = 0;
      for (int i = 0; i < n; ++i)
        if (i + edge[0] >= 0 && i + edge[0] < n)
          terms[n_terms++] = cells.quantity(Boxes::pairs + pair + pair_of<degree>(i, i + edge[0])) - i;
      nodes.add(array, offset_of(step, n * k), terms, n_terms);
    }
  }

  SETTLE_INLINE static void add_to_nodes(const Step& step, const CellArrays& cells, const TileNodes& nodes) {
    static constexpr Edges edges = Boxes::edges();
    static constexpr int itself[3] = {0, 0, 0};
    add_values(step, cells, nodes, Array::mass, Boxes::lumped);
    for (int d = 0; d < dim; ++d) {
      add_values(step, cells, nodes, Array::momentum + d, Boxes::momentum + d * n_nodes);
      add_values(step, cells, nodes, Array::force + d, Boxes::force + d * n_nodes);
    }
    for (int k = 0; k * n_nodes < count - Boxes::external(full); ++k)
      add_values(step, cells, nodes, Array::pull + k, Boxes::external(full) + k * n_nodes);
    add_couplings(step, cells, nodes, Array::matrix, itself);
    for (int e = 0; e < edges.count; ++e)
      add_couplings(step, cells, nodes, Array::matrix + 1 + e, edges.by_axis[e]);
  }

  static void run(const Step& step, int strip, const Scratch& scratch) {
    const CellArrays cells(step, scratch.cells);
    sum_up<dim, 1>(step, strip, [&](const Tile& tile, const TileNodes& nodes, Lanes& slowness) {
      CellSums<BoxScatter, dim, weight>::add_tile(step, tile, scratch.block, cells);
      cells.clear_behind(step, tile, Boxes::constants);
      if (step.hyperelastic) find_largest_stress<dim, 1>(step, tile, cells, Boxes::largest_stress);
      for (std::size_t s = 0; s < tile.n_squares; s += n_lanes)
        finish(step, tile, s, cells, slowness);
      add_to_columns(step, strip, tile, cells.quantity(Boxes::total_volume));
      add_to_nodes(step, cells, nodes);
    });
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
