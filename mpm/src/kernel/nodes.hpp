/// \file
/// The phases at the nodes: the same for every space but for the number of axes and of couplings.
#pragma once

#include "node_sums.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

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
    const double* overlap = overlap_of(step, strip - 1) + static_cast<std::size_t>(k) * step.overlap_stride;
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
template <int dim>
SETTLE_INLINE void accelerate(const Step& step, int strip) {
  using Array = NodeArrays<dim>;
  const NodeRange own(step, strip);
  complete(step, strip, own);
  Lanes unbalanced_sum = all(0.0), external_sum = all(0.0), reaction = all(0.0);
  for (std::size_t n = own.first; n < own.last; n += n_lanes) {
    const int count = own.last - n < n_lanes ? static_cast<int>(own.last - n) : n_lanes;
    const Lanes mass = load(step.node[Array::mass] + n, count);
    const Mask empty = mass == 0.0;
    const Lanes inverse_mass = empty ? all(0.0) : 1.0 / mass;
    for (int d = 0; d < dim; ++d) {
      double* force = step.node[Array::force + d] + n;
      const double* given = step.node[Array::external(d)];
      const Lanes external = given == nullptr ? all(0.0) : load(given + n, count);
      const Lanes unbalanced = external - load(force, count);
      const Lanes momentum = load(step.node[Array::momentum + d] + n, count);
      const Lanes size = absolute(unbalanced);
      const Lanes against = momentum > 0.0 ? size : momentum < 0.0 ? -size : all(0.0);
      const Mask held = held_in(step, n, count, 1 << d);
      store(force, held ? all(0.0) : (unbalanced - step.damping * against) * inverse_mass, count);
      external_sum += absolute(external);
      unbalanced_sum += held ? all(0.0) : size;
      if (d == dim - 1) reaction -= held ? unbalanced : all(0.0);
    }
  }
  StripSums& sums = step.sums[strip];
  sums.unbalanced = sum_of(unbalanced_sum);
  sums.external = sum_of(external_sum);
  sums.base_reaction = sum_of(reaction);
}

/// Displacements from the momentum of the updated points, p_i + kick sum_j M_ij a_j with the consistent mass M: what
/// mapping the points' new momenta back to the nodes gives. No row of nodes needs the momentum of another.
template <int dim, int n_edges>
SETTLE_INLINE void displace(const Step& step, int strip) {
  using Array = NodeArrays<dim>;
  const NodeRange own(step, strip);
  Lanes kinetic = all(0.0), work = all(0.0);
  for (std::size_t n = own.first; n < own.last; n += n_lanes) {
    const int count = own.last - n < n_lanes ? static_cast<int>(own.last - n) : n_lanes;
    const Lanes mass = load(step.node[Array::mass] + n, count);
    const Mask moves = mass > 0.0;
    const Lanes inverse_mass = moves ? 1.0 / mass : all(0.0);
    const Lanes diagonal = load(step.node[Array::matrix] + n, count);
    Lanes change[dim];
    for (int d = 0; d < dim; ++d)
      change[d] = diagonal * load(step.node[Array::force + d] + n, count);
    for (int e = 0; e < n_edges; ++e) {
      const double* matrix = step.node[Array::matrix + 1 + e];
      const std::ptrdiff_t edge = step.edge[e], here = static_cast<std::ptrdiff_t>(n);
      const Lanes ahead = load(matrix + here, count), behind = load(matrix + here - edge, count);
      for (int d = 0; d < dim; ++d)
        change[d] += ahead * load(step.node[Array::force + d] + here + edge, count) +
                     behind * load(step.node[Array::force + d] + here - edge, count);
    }
    for (int d = 0; d < dim; ++d) {
      double* momentum = step.node[Array::momentum + d] + n;
      const Lanes moved = (load(momentum, count) + step.kick * change[d]) * inverse_mass;
      const Lanes velocity = held_in(step, n, count, 1 << d) ? all(0.0) : moved;
      const Lanes displacement = step.dt * velocity;
      store(momentum, displacement, count);
      kinetic += 0.5 * mass * velocity * velocity;
      const double* external = step.node[Array::external(d)];
      if (external != nullptr) work += load(external + n, count) * displacement;
    }
  }
  step.sums[strip].kinetic = sum_of(kinetic);
  step.sums[strip].external_work = sum_of(work);
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
