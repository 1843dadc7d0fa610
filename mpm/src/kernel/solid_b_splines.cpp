// The kernels of quadratic B-splines in 3-D, apart because they take long to compile.

#include "box_phases.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

const Phases solid_b_splines = phases_of_boxes<3, 2>();

} // namespace settle::mpm::kernel::SETTLE_VARIANT
