// The kernels of linear triangles and tetrahedra.

#include "phases.hpp"
#include "simplex_move.hpp"
#include "simplex_scatter.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

namespace {

template <class Cut>
void scatter_simplices(const Step& step, int strip, const Scratch& scratch) {
  with_weight<Cut::dim>(step, strip, [&]<Weight weight>() { SimplexScatter<Cut, weight>::run(step, strip, scratch); });
}

template <class Cut>
constexpr Phases phases_of_simplices() {
  using Kind = Simplices<Cut>;
  return {.quantities = Kind::n_quantities,
          .block = larger(Kind::most_sums, Kind::n_constants) * static_cast<int>(Kind::PointBlock::pitch),
          .tile = tile_of(Kind::constants),
          .n_means = 0,
          .edges = Kind::edges(),
          .scatter = scatter_simplices<Cut>,
          .accelerate = accelerate_nodes<Cut::dim>,
          .displace = displace_nodes<Cut::dim, Kind::n_edges>,
          .move = SimplexMove<Cut>::run};
}

} // namespace

const Phases triangles = phases_of_simplices<Triangles>();
const Phases tetrahedra = phases_of_simplices<Tetrahedra>();

} // namespace settle::mpm::kernel::SETTLE_VARIANT
