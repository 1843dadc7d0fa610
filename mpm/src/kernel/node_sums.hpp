/// \file
/// From the cells of tiles to the nodes of their strip.
#pragma once

#include "cell_sums.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Nodes of a strip: the last one has those above all squares.
struct NodeRange {
  std::size_t first, last;

  NodeRange(const Step& step, int strip) {
    const auto columns = static_cast<std::size_t>(step.node_columns);
    const int end = strip == step.n_strips ? step.rows + step.overlap : Strip(step, strip).last_row;
    first = static_cast<std::size_t>(strip == step.n_strips ? step.rows : strip * step.strip_rows) * columns;
    last = static_cast<std::size_t>(end) * columns;
  }
};

/// What a strip's cells have for the nodes that the next one owns.
[[nodiscard]] SETTLE_INLINE double* overlap_of(const Step& step, int strip) {
  return step.overlap_nodes + static_cast<std::size_t>(strip * step.n_node_arrays) * step.overlap_stride;
}

/// Where the cells of a strip are summed: the nodes of its own rows in the arrays of all nodes, those above them, which
/// the next strip owns, in memory of its own. No other strip writes to either.
struct StripNodes {
  const Step& step;
  NodeRange own;
  double* overlap;            ///< starts a cache line, as every array does
  std::size_t overlap_stride; ///< from one array to the next
  std::size_t summed = 0;     ///< nodes below this one hold sums or zeros

  StripNodes(const Step& step_, int strip)
      : step(step_), own(step_, strip), overlap(overlap_of(step_, strip)), overlap_stride(step_.overlap_stride),
        summed(own.first) {}

  [[nodiscard]] std::size_t end() const { return own.last + overlap_stride; }
  /// Of an array, the numbers of nodes above the strip's own.
  [[nodiscard]] double* above(int array) const { return overlap + static_cast<std::size_t>(array) * overlap_stride; }

  /// Makes the nodes before `last` hold at least zeros.
  SETTLE_INLINE void reach(std::size_t last) {
    if (last <= summed) return;
    const std::size_t last_own = last < own.last ? last : own.last;
    const std::size_t first_above = summed < own.last ? 0 : summed - own.last;
    for (int k = 0; k < step.n_node_arrays; ++k) {
      if (step.node[k] == nullptr) continue;
      for (std::size_t n = summed; n < last_own; ++n)
        step.node[k][n] = 0.0;
      for (std::size_t n = first_above; n + own.last < last; ++n)
        above(k)[n] = 0.0;
    }
    summed = last;
  }
};

/// The nodes of a tile, from the one at its first square on.
struct TileNodes {
  const StripNodes& strip;
  std::size_t first, count;

  TileNodes(const StripNodes& strip_, const Tile& tile)
      : strip(strip_), first(tile.first_node(strip_.step)), count(tile.n_nodes) {}

  /// Adds `n` quantities of squares to the nodes that are `offset` from the square's own. A quantity for the node after
  /// that, along x, is given from the square before on.
  template <int n>
  SETTLE_INLINE void add(int array, std::size_t offset, const double* const* terms) const {
    const std::size_t from = first + offset, to = from + count, edge = strip.own.last;
    if (from < edge) add_to<n>(strip.step.node[array], from, to < edge ? to : edge, strip.own.first, edge, terms, 0);
    if (to <= edge) return;
    const std::size_t begin = from < edge ? edge : from;
    add_to<n>(strip.above(array), begin - edge, to - edge, 0, strip.overlap_stride, terms, begin - from);
  }
  SETTLE_INLINE void add(int array, std::size_t offset, const double* const* terms, int n) const {
    for (; n >= 3; n -= 3, terms += 3)
      add<3>(array, offset, terms);
    if (n == 2) add<2>(array, offset, terms);
    if (n == 1) add<1>(array, offset, terms);
  }

private:
  /// Adds the terms from number `skipped` on to the nodes from ... to - 1 of an array that starts a cache line. Eight
  /// numbers of a line that the terms do not fill get zeros besides, if all are among first ... last - 1.
  template <int n>
  SETTLE_INLINE static void add_to(double* array, std::size_t from, std::size_t to, std::size_t first, std::size_t last,
                                   const double* const* terms, std::size_t skipped) {
    const auto add_some = [&](std::size_t node, int count) {
      Lanes sum = load(array + node, count);
      for (int k = 0; k < n; ++k)
        sum += load(terms[k] + skipped + node - from);
      store(array + node, sum, count);
    };
    std::size_t node = from - from % n_lanes;
    if (node < first) {
      const std::size_t until = to < node + n_lanes ? to : node + n_lanes;
      add_some(from, static_cast<int>(until - from));
      node += n_lanes;
    }
    for (; node < to && node + n_lanes <= last; node += n_lanes)
      add_some(node, n_lanes);
    if (node >= to) return;
    const std::size_t rest = node < from ? from : node;
    add_some(rest, static_cast<int>(to - rest));
  }
};

/// External forces of nodes whose mass feels one gravity.
template <int dim>
SETTLE_INLINE void pull_down(const StripNodes& strip, double gravity) {
  using Array = NodeArrays<dim>;
  for (std::size_t n = strip.own.first; n < strip.own.last; ++n)
    strip.step.node[Array::pull][n] = -gravity * strip.step.node[Array::mass][n];
  for (std::size_t n = 0; n < strip.overlap_stride; ++n)
    strip.above(Array::pull)[n] = -gravity * strip.above(Array::mass)[n];
}

/// Sums a strip up to its nodes: `add_tile(tile, nodes, slowness)` those of a tile that holds points, where it also
/// makes `slowness` the least one.
template <int dim, int per_square, class AddTile>
SETTLE_INLINE void sum_up(const Step& step, int index, AddTile&& add_tile) {
  StripNodes strip(step, index);
  double* columns = step.column_volume + static_cast<std::size_t>(index) * static_cast<std::size_t>(step.columns);
  for (int column = 0; column < step.columns; ++column)
    columns[column] = 0.0;
  Lanes slowness = all(__builtin_inf());
  for (int t = 0; t < step.strip_tiles; ++t) {
    const Tile tile(step, index, t);
    if (tile.is_empty(step, per_square)) continue;
    const TileNodes nodes(strip, tile);
    strip.reach(nodes.first + tile.n_squares + step.last_touched);
    add_tile(tile, nodes, slowness);
  }
  strip.reach(strip.end());
  step.sums[index].slowness_squared = least_of(slowness);
  if (step.weight[index].kind == Weight::uniform) pull_down<dim>(strip, step.weight[index].gravity);
}

/// Adds the volumes of a tile's squares up over the columns.
SETTLE_INLINE void add_to_columns(const Step& step, int strip, const Tile& tile, const double* volume) {
  double* columns = step.column_volume + static_cast<std::size_t>(strip) * static_cast<std::size_t>(step.columns);
  for_each_line(step, tile, [&](std::size_t first, std::size_t number) {
    double* line = columns + number % static_cast<std::size_t>(step.columns);
    for (int column = 0; column < tile.columns; ++column)
      line[column] += volume[first + static_cast<std::size_t>(column)];
  });
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
