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

/// Arrays of the nodes of a strip, from the first one of a tile on.
struct TileNodes {
  double* strip; ///< starts a cache line, as every array does
  std::size_t stride, first, n_squares;

  TileNodes(const Step& step, const Tile& tile, double* nodes)
      : strip(nodes), stride(step.n_nodes), first(tile.first_square), n_squares(tile.n_squares) {}

  /// Adds `n` quantities of squares to the nodes that are `offset` from the square's own. A quantity for the node after
  /// that, along x, is given from the square before on.
  template <int n>
  SETTLE_INLINE void add(int array, std::size_t offset, const double* const* terms) const {
    const std::size_t node = first + offset, before = node % n_lanes;
    double* to = strip + static_cast<std::size_t>(array) * stride + (node - before);
    for (std::size_t m = 0; m < n_squares + before; m += n_lanes) {
      Lanes sum = load(to + m);
      for (int k = 0; k < n; ++k)
        sum += load(terms[k] + m - before);
      store(to + m, sum);
    }
  }
  SETTLE_INLINE void add(int array, std::size_t offset, const double* const* terms, int n) const {
    for (; n >= 3; n -= 3, terms += 3)
      add<3>(array, offset, terms);
    if (n == 2) add<2>(array, offset, terms);
    if (n == 1) add<1>(array, offset, terms);
  }
};

/// Sums a strip up to its nodes: `add_tile(tile, slowness)` those of a tile that holds points, where it also makes
/// `slowness` the least one.
template <int dim, int per_square, class AddTile>
SETTLE_INLINE void sum_up(const Step& step, int strip, const Scratch& scratch, AddTile&& add_tile) {
  using Array = NodeArrays<dim>;
  const std::size_t all_nodes = static_cast<std::size_t>(step.n_node_arrays) * step.n_nodes;
  for (std::size_t n = 0; n < all_nodes; ++n)
    scratch.nodes[n] = 0.0;
  double* columns = step.column_volume + static_cast<std::size_t>(strip) * static_cast<std::size_t>(step.columns);
  for (int column = 0; column < step.columns; ++column)
    columns[column] = 0.0;
  Lanes slowness = all(__builtin_inf());
  for (int t = 0; t < step.strip_tiles; ++t) {
    const Tile tile(step, strip, t);
    if (!tile.is_empty(step, per_square)) add_tile(tile, slowness);
  }
  step.sums[strip].slowness_squared = least_of(slowness);
  const StripWeight& weight = step.weight[strip];
  if (weight.kind == Weight::uniform)
    for (std::size_t n = 0; n < step.n_nodes; n += n_lanes)
      store(scratch.nodes + static_cast<std::size_t>(Array::pull) * step.n_nodes + n,
            -weight.gravity * load(scratch.nodes + static_cast<std::size_t>(Array::mass) * step.n_nodes + n));
}

/// Adds the volumes of a tile's squares up over the columns.
SETTLE_INLINE void add_to_columns(const Step& step, int strip, const Tile& tile, const double* volume) {
  double* columns = step.column_volume + static_cast<std::size_t>(strip) * static_cast<std::size_t>(step.columns);
  for_each_line(step, tile, [&](std::size_t first, std::size_t number) {
    double* line = columns + number % static_cast<std::size_t>(step.columns);
    for (int column = 0; column < step.line; ++column)
      line[column] += volume[first + static_cast<std::size_t>(column)];
  });
}

/// Hands the nodes that a strip's cells have been summed to over: the strip's own rows, and those of the next strip.
SETTLE_INLINE void hand_over(const Step& step, int index, const double* nodes) {
  const NodeRange own(step, index);
  const std::size_t n_own = own.last - own.first;
  const auto n_overlap = static_cast<std::size_t>(step.overlap) * static_cast<std::size_t>(step.node_columns);
  for (int k = 0; k < step.n_node_arrays; ++k) {
    if (step.node[k] == nullptr) continue;
    const double* from = nodes + static_cast<std::size_t>(k) * step.n_nodes;
    __builtin_memcpy(step.node[k] + own.first, from, n_own * sizeof(double));
    double* overlap = step.overlap_nodes + static_cast<std::size_t>(index * step.n_node_arrays + k) * n_overlap;
    __builtin_memcpy(overlap, from + n_own, n_overlap * sizeof(double));
  }
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
