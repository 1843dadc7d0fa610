// What the kernels of the explicit step know of grid, material and memory.

#include "kernel_step.hpp"

#include <algorithm>

namespace settle::mpm {

namespace {

constexpr std::size_t lanes = 8;                  ///< kernels read and write so many numbers at a time
constexpr int strip_squares = 256;                ///< at least, so that loops over a strip are long
constexpr int least_strip_rows = 4;               ///< so that the rows that two strips have in common are few
constexpr int most_strip_rows = 16;               ///< more of them hold little less
constexpr int strips_wanted = 16;                 ///< so that there is enough to share
constexpr std::size_t points_per_thread = 10'000; ///< below this a thread costs more than it brings

int quotient_up(int a, int b) {
  return (a + b - 1) / b;
}
std::size_t rounded_up(std::size_t n, std::size_t to) {
  return (n + to - 1) / to * to;
}

/// The first number of a vector that starts a cache line.
double* aligned(std::vector<double>& values) {
  const auto address = reinterpret_cast<std::uintptr_t>(values.data());
  return values.data() + (rounded_up(address, 64) - address) / sizeof(double);
}

} // namespace

template <class Space>
void KernelStep<Space>::set_grid() {
  const Space& space = body_.space;
  const auto& squares = space.squares();
  const auto& nodes = space.node_numbering();
  step_.line = squares.counts.front(), step_.node_line = nodes.counts.front();
  step_.columns = space.columns(), step_.node_columns = space.node_columns(), step_.rows = space.rows();
  step_.lines = step_.columns / step_.line, step_.node_lines = step_.node_columns / step_.node_line;
  step_.overlap = step_.node_line - step_.line;
  for (int d = 0; d < dim; ++d) {
    step_.node_step[d] = nodes.stride(d);
    step_.origin[d] = space.origin()[d];
  }
  divide_rows();
  step_.inverse_size = 1.0 / space.size();
  step_.cell_volume = space.cell_volume();
  step_.full_cells = body_.integration == StressIntegration::full_cells;
  for (int e = 0; e < phases_.edges.count; ++e)
    for (int d = 0; d < dim; ++d)
      step_.edge[e] += phases_.edges.by_axis[e][d] * step_.node_step[d];
}

/// Into strips, and these into tiles.
template <class Space>
void KernelStep<Space>::divide_rows() {
  const int least = std::max(least_strip_rows, quotient_up(strip_squares, step_.node_columns));
  const int shared = std::min(most_strip_rows, step_.rows / strips_wanted);
  step_.strip_rows = std::min(step_.rows, std::max(least, shared));
  while (step_.rows % step_.strip_rows != 0 && step_.rows % step_.strip_rows < step_.overlap)
    ++step_.strip_rows; // also the last strip owns all nodes that the one below adds to
  step_.n_strips = quotient_up(step_.rows, step_.strip_rows);
  const int strip_lines = step_.strip_rows * step_.node_lines;
  step_.tile_lines = std::clamp(phases_.tile / step_.node_line, 1, strip_lines);
  const int parts = (step_.node_line + phases_.tile / 2) / phases_.tile;
  step_.tile_width =
      parts < 2 ? step_.node_line : static_cast<int>(rounded_up(size_of(quotient_up(step_.node_line, parts)), lanes));
  while (step_.node_line % step_.tile_width > 0 && step_.node_line % step_.tile_width <= step_.overlap)
    step_.tile_width += static_cast<int>(lanes); // also the last part of a line has squares that exist
  step_.line_parts = quotient_up(step_.node_line, step_.tile_width);
  step_.tile_squares = size_of(step_.tile_lines) * size_of(step_.tile_width);
  step_.strip_tiles = quotient_up(strip_lines, step_.tile_lines) * step_.line_parts;
}

template <class Space>
void KernelStep<Space>::set_material() {
  step_.lambda = body_.lame.lambda, step_.mu = body_.lame.mu, step_.density = body_.density;
  step_.rate = body_.law == exchange::Law::rate && !body_.jaumann;
  step_.hyperelastic = body_.law != exchange::Law::rate;
}

template <class Space>
void KernelStep<Space>::allocate_nodes() {
  const Size columns = size_of(step_.node_columns);
  for (int d = 0; d < dim; ++d)
    step_.last_touched += size_of(step_.overlap * step_.node_step[d]);
  step_.n_node_arrays = Array::matrix + 1 + phases_.edges.count;
  for (int k = 0; k < step_.n_node_arrays; ++k)
    if (k <= Array::pull || k >= Array::matrix) allocate_nodes(k); // others: once points have a force
  zeros_.assign(columns, 0.0);
  step_.overlap_stride = rounded_up(step_.last_touched, lanes);
  overlap_nodes_.assign(size_of(step_.n_strips * step_.n_node_arrays) * step_.overlap_stride + lanes, 0.0);
  step_.overlap_nodes = aligned(overlap_nodes_);
  const Size n = body_.fixed.size();
  if (step_.full_cells && phases_.n_means > 0) {
    step_.mean_stride = n + 2 * lanes;
    mean_.assign(size_of(phases_.n_means) * step_.mean_stride, 0.0);
    step_.mean = mean_.data() + lanes;
  }
  held_.assign(n, 0);
  for (Size i = 0; i < n; ++i)
    for (Size d = 0; d < dim; ++d)
      held_[i] |= static_cast<std::uint8_t>(body_.fixed[i][d] ? 1U << d : 0U);
  step_.held = held_.data();
  column_volume_.assign(size_of(step_.n_strips * step_.columns), 0.0);
  step_.column_volume = column_volume_.data();
}

/// One array, of zeros, with margins as far as edges reach. Large arrays start pages: each one begins some lines
/// further in, so that the numbers of a node are not all in one set of a cache.
template <class Space>
void KernelStep<Space>::allocate_nodes(int array) {
  constexpr Size lines_of_a_page = 64, lines_apart = 9;
  const Size shift = lanes * (lines_apart * size_of(array) % lines_of_a_page);
  const Size margin = rounded_up(step_.last_touched + lanes, lanes);
  const Size n = size_of((step_.rows + step_.overlap) * step_.node_columns);
  auto& numbers = nodes_[size_of(array)];
  numbers.assign(n + 2 * margin + lanes + shift, 0.0);
  step_.node[array] = aligned(numbers) + shift + margin;
}

template <class Space>
void KernelStep<Space>::allocate_scratch() {
  constexpr Size apart = 64; // and a line: no two quantities in one set of a cache
  step_.stride = rounded_up(step_.tile_squares + 2 * kernel::cell_margin, apart) + lanes;
  const Size block = rounded_up(size_of(phases_.block), lanes), cells = size_of(phases_.quantities) * step_.stride;
  for (Size thread = scratch_.size(); thread < size_of(shares_.threads()); ++thread) {
    scratch_.emplace_back(block + cells + lanes, 0.0);
    double* first = aligned(scratch_.back());
    scratch_of_.push_back({.block = first, .cells = first + block});
  }
}

/// What follows from where the points are; to be called after they have been sorted.
template <class Space>
void KernelStep<Space>::take_stock() {
  sorts_ = body_.cells.sorts;
  const auto row_begin = [&](int row) {
    return body_.cells.begin[size_of(Space::cells_per_square) * size_of(step_.columns) * size_of(row)];
  };
  std::vector<Size> weights(size_of(step_.n_strips) + 1, 0);
  for (int strip = 0; strip < step_.n_strips; ++strip) {
    const Size s = size_of(strip), first = row_begin(strip * step_.strip_rows),
               last = row_begin(std::min(step_.rows, (strip + 1) * step_.strip_rows));
    weights[s] = last - first;
    touched_[s] = 0;
    for (Size p = first; p < last; ++p)
      note(s, body_.points.layer[p]);
  }
  const auto useful = static_cast<int>(std::max<Size>(1, body_.points.size() / points_per_thread));
  shares_ = shares_by_weight(weights, std::min(threads_, useful));
  allocate_scratch();
  point_to_points();
}

/// A point of this layer is in the strip.
template <class Space>
void KernelStep<Space>::note(Size strip, std::int32_t layer) {
  Layers& layers = layers_[strip];
  if (touched_[strip] == 0) layers = {layer, layer};
  touched_[strip] = 1;
  layers = {std::min(layers.lowest, layer), std::max(layers.highest, layer)};
}

template <class Space>
void KernelStep<Space>::point_to_points() {
  auto& points = body_.points;
  step_.points = {};
  step_.points.mass = points.mass.data(), step_.points.volume = points.volume.data();
  step_.points.layer = points.layer.data();
  for (Size d = 0; d < dim; ++d)
    step_.points.position[d] = points.position[d].data(), step_.points.velocity[d] = points.velocity[d].data();
  for (Size c = 0; c < points.stress.size(); ++c)
    step_.points.stress[c] = points.stress[c].data();
  step_.begin = body_.cells.begin.data();
}

#define SETTLE_INSTANTIATE(Space) template class KernelStep<Space>;
SETTLE_FOR_EVERY_SPACE_WITH_KERNELS(SETTLE_INSTANTIATE)

} // namespace settle::mpm
