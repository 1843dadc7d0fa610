/// \file
/// The phases at the nodes: the same for every space but for the number of couplings.
#pragma once

#include "strip.hpp"

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

/// Completes the sums at the strip's nodes by what the strip below adds.
SETTLE_INLINE void complete(const Step& step, int strip, const NodeRange& own) {
  const auto n_overlap = static_cast<std::size_t>(step.overlap) * static_cast<std::size_t>(step.node_columns);
  for (int k = 0; k < step.n_node_arrays; ++k) {
    if (step.node[k] == nullptr) continue;
    double* node = step.node[k] + own.first;
    if (strip == step.n_strips || step.touched[strip] == 0)
      for (std::size_t n = 0; n < own.last - own.first; ++n)
        node[n] = 0.0;
    if (strip == 0 || step.touched[strip - 1] == 0) continue;
    const double* overlap =
        step.overlap_nodes + static_cast<std::size_t>((strip - 1) * step.n_node_arrays + k) * n_overlap;
    for (std::size_t n = 0; n < n_overlap; ++n)
      node[n] += overlap[n];
  }
}

/// -1 where a support holds in the direction of `bit`.
SETTLE_INLINE Mask held_in(const Step& step, std::size_t node, int count, int bit) {
  Bytes bytes{};
  for (int i = 0; i < count; ++i)
    bytes[i] = step.held[node + static_cast<std::size_t>(i)];
  return (__builtin_convertvector(bytes, Mask) & bit) != 0;
}

/// Accelerations: (unbalanced force + local damping) / mass, zero where a support holds.
SETTLE_INLINE void accelerate(const Step& step, int strip) {
  const NodeRange own(step, strip);
  complete(step, strip, own);
  Lanes unbalanced_sum = all(0.0), external_sum = all(0.0), reaction = all(0.0);
  for (std::size_t n = own.first; n < own.last; n += n_lanes) {
    const int count = own.last - n < n_lanes ? static_cast<int>(own.last - n) : n_lanes;
    const Lanes mass = load(step.node[node_mass] + n, count);
    const Mask empty = mass == 0.0;
    const Lanes inverse_mass = empty ? all(0.0) : 1.0 / mass;
    for (int d = 0; d < 2; ++d) {
      double* force = step.node[node_force + d] + n;
      const double* given = step.node[node_external + 1 - d];
      const Lanes external = given == nullptr ? all(0.0) : load(given + n, count);
      const Lanes unbalanced = external - load(force, count);
      const Lanes momentum = load(step.node[node_momentum + d] + n, count);
      const Lanes size = absolute(unbalanced);
      const Lanes against = momentum > 0.0 ? size : momentum < 0.0 ? -size : all(0.0);
      const Mask held = held_in(step, n, count, 1 << d);
      store(force, held ? all(0.0) : (unbalanced - step.damping * against) * inverse_mass, count);
      external_sum += absolute(external);
      unbalanced_sum += held ? all(0.0) : size;
      if (d == 1) reaction -= held ? unbalanced : all(0.0);
    }
  }
  StripSums& sums = step.sums[strip];
  sums.unbalanced = sum_of(unbalanced_sum);
  sums.external = sum_of(external_sum);
  sums.base_reaction = sum_of(reaction);
}

/// Displacements from the momentum of the updated points, p_i + kick sum_j M_ij a_j with the consistent mass M: what
/// mapping the points' new momenta back to the nodes gives. No row of nodes needs the momentum of another.
template <int n_edges>
SETTLE_INLINE void displace(const Step& step, int strip) {
  const NodeRange own(step, strip);
  Lanes kinetic = all(0.0), work = all(0.0);
  for (std::size_t n = own.first; n < own.last; n += n_lanes) {
    const int count = own.last - n < n_lanes ? static_cast<int>(own.last - n) : n_lanes;
    const Lanes mass = load(step.node[node_mass] + n, count);
    const Mask moves = mass > 0.0;
    const Lanes inverse_mass = moves ? 1.0 / mass : all(0.0);
    Lanes diagonal = load(step.node[node_matrix] + n, count);
    Lanes change[2] = {diagonal * load(step.node[node_force] + n, count),
                       diagonal * load(step.node[node_force + 1] + n, count)};
    for (int e = 0; e < n_edges; ++e) {
      const double* matrix = step.node[node_matrix + 1 + e];
      const std::ptrdiff_t edge = step.edge[e], here = static_cast<std::ptrdiff_t>(n);
      const Lanes ahead = load(matrix + here, count), behind = load(matrix + here - edge, count);
      for (int d = 0; d < 2; ++d)
        change[d] += ahead * load(step.node[node_force + d] + here + edge, count) +
                     behind * load(step.node[node_force + d] + here - edge, count);
    }
    for (int d = 0; d < 2; ++d) {
      double* momentum = step.node[node_momentum + d] + n;
      const Lanes moved = (load(momentum, count) + step.kick * change[d]) * inverse_mass;
      const Lanes velocity = held_in(step, n, count, 1 << d) ? all(0.0) : moved;
      const Lanes displacement = step.dt * velocity;
      store(momentum, displacement, count);
      kinetic += 0.5 * mass * velocity * velocity;
      const double* external = step.node[node_external + 1 - d];
      if (external != nullptr) work += load(external + n, count) * displacement;
    }
  }
  step.sums[strip].kinetic = sum_of(kinetic);
  step.sums[strip].external_work = sum_of(work);
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
