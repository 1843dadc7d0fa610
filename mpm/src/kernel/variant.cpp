// The kernels for one instruction set: this file and those of the spaces are compiled once for each, SETTLE_VARIANT
// being its name. Everything is in a namespace of that name, and nothing of any library is used, so that no function
// can be taken from another.

#include "phases.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

#define SETTLE_NAME_OF(variant) #variant
#define SETTLE_QUOTED(variant) SETTLE_NAME_OF(variant)

extern const Variant variant;
const Variant variant{.name = SETTLE_QUOTED(SETTLE_VARIANT),
                      .triangles = &triangles,
                      .quadrilaterals = &quadrilaterals,
                      .plane_b_splines = &plane_b_splines,
                      .tetrahedra = &tetrahedra,
                      .hexahedra = &hexahedra,
                      .solid_b_splines = &solid_b_splines};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
