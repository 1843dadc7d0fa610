/// \file
/// Which keys a material's law needs, and which it has no use for.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

void check_materials(const Case& study, Reading& reading);

} // namespace settle::exchange
