// The kernels for one instruction set: this file is compiled once for each, SETTLE_VARIANT being its name. Everything
// is in a namespace of that name, and nothing of any library is used, so that no function can be taken from another.

#pragma GCC diagnostic ignored "-Wsign-conversion" // sizes of small arrays are plain integers

#include "squares.hpp"
#include "triangles.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

namespace {

void accelerate_nodes(const Step& step, int strip) {
  accelerate(step, strip);
}

template <int degree>
constexpr Phases phases_on_squares() {
  using Kernel = Squares<degree>;
  constexpr int most = Kernel::most_sums > Kernel::constants_of(true) ? Kernel::most_sums : Kernel::constants_of(true);
  return {.quantities = Kernel::n_quantities,
          .block = most * static_cast<int>(Kernel::Points::pitch),
          .n_edges = Kernel::n_edges,
          .n_means = Kernel::n_means,
          .scatter = Kernel::scatter,
          .accelerate = accelerate_nodes,
          .displace = Kernel::displace_nodes,
          .move = Kernel::move};
}

#define SETTLE_NAME_OF(variant) #variant
#define SETTLE_QUOTED(variant) SETTLE_NAME_OF(variant)

} // namespace

extern const Variant variant;
const Variant variant{.name = SETTLE_QUOTED(SETTLE_VARIANT),
                      .triangles = {.quantities = triangles::n_quantities,
                                    .block = 22 * static_cast<int>(triangles::Points::pitch),
                                    .n_edges = 3,
                                    .n_means = 0,
                                    .scatter = triangles::scatter,
                                    .accelerate = accelerate_nodes,
                                    .displace = triangles::displace_nodes,
                                    .move = triangles::move},
                      .quadrilaterals = phases_on_squares<1>(),
                      .b_splines = phases_on_squares<2>()};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
