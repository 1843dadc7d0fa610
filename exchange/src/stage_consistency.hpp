/// \file
/// Whether stages follow from one another.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// One stage for each layer where the case has none: existing ground first, the others placed.
void fill_stages(Case& study);

void check_stages(const Case& study, Reading& reading);

} // namespace settle::exchange
