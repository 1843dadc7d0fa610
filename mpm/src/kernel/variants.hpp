/// \file
/// The kernels that this processor runs fastest.
#pragma once

#include <vector>

#include "data.hpp"

namespace settle::mpm::kernel {

/// All that this processor can run of those compiled, the best one last.
std::vector<const Variant*> variants_here();
const Variant& best_variant();

} // namespace settle::mpm::kernel
