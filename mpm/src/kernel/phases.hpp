/// \file
/// What the phases of all spaces have in common.
#pragma once

#include "nodes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

constexpr int larger(int a, int b) {
  return a > b ? a : b;
}
/// Squares of a tile of so many quantities that it fits into a cache of the second level, but long enough for loops.
constexpr int tile_of(int quantities) {
  return larger(64, 32'768 / quantities);
}

/// The phase for the strip's weight. Points of 3-D have no force besides gravity.
template <int dim, class Phase>
SETTLE_INLINE void with_weight(const Step& step, int strip, Phase&& phase) {
  switch (step.weight[strip].kind) {
  case Weight::uniform:
    return phase.template operator()<Weight::uniform>();
  case Weight::by_layer:
    return phase.template operator()<Weight::by_layer>();
  case Weight::with_force:
    if constexpr (dim == 2) return phase.template operator()<Weight::with_force>();
  }
}

template <int dim>
void accelerate_nodes(const Step& step, int strip) {
  accelerate<dim>(step, strip);
}
template <int dim, int n_edges>
void displace_nodes(const Step& step, int strip) {
  displace<dim, n_edges>(step, strip);
}

extern const Phases triangles, quadrilaterals, plane_b_splines, tetrahedra, hexahedra, solid_b_splines;

} // namespace settle::mpm::kernel::SETTLE_VARIANT
