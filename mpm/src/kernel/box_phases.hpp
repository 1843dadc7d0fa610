/// \file
/// The phases on squares and cubes.
#pragma once

#include "box_move.hpp"
#include "box_scatter.hpp"
#include "phases.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

template <class Kind>
void scatter_boxes(const Step& step, int strip, const Scratch& scratch) {
  with_weight<Kind::dim>(step, strip, [&]<Weight weight>() {
    return step.full_cells ? BoxScatter<Kind, true, weight>::run(step, strip, scratch)
                           : BoxScatter<Kind, false, weight>::run(step, strip, scratch);
  });
}
template <class Kind>
void move_boxes(const Step& step, int strip, const Scratch& scratch) {
  return step.full_cells ? BoxMove<Kind, true>::run(step, strip, scratch)
                         : BoxMove<Kind, false>::run(step, strip, scratch);
}
template <int dim, int degree>
constexpr Phases phases_of_boxes() {
  using Kind = Boxes<dim, degree>;
  return {.quantities = Kind::n_quantities,
          .block = larger(Kind::largest_stress * static_cast<int>(Kind::SumBlock::pitch),
                          Kind::constants_of(true) * static_cast<int>(Kind::MoveBlock::pitch)),
          .tile = tile_of(Kind::constants),
          .n_means = Kind::n_nodes,
          .edges = Kind::edges(),
          .scatter = scatter_boxes<Kind>,
          .accelerate = accelerate_nodes<dim>,
          .displace = displace_nodes<dim, Kind::n_edges>,
          .move = move_boxes<Kind>};
}

} // namespace settle::mpm::kernel::SETTLE_VARIANT
