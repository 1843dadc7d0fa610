// The kernels of bilinear quadrilaterals and trilinear hexahedra.

#include "box_phases.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

const Phases quadrilaterals = phases_of_boxes<2, 1>();
const Phases hexahedra = phases_of_boxes<3, 1>();

} // namespace settle::mpm::kernel::SETTLE_VARIANT
