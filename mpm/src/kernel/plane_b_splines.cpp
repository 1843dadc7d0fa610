// The kernels of quadratic B-splines in the plane.

#include "box_phases.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

const Phases plane_b_splines = phases_of_boxes<2, 2>();

} // namespace settle::mpm::kernel::SETTLE_VARIANT
