/// \file
/// What does not go together with a valley.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Complains about a case of an embankment in a valley that cannot be drawn; called before it is.
void check_valley(const Case& study, Reading& reading);

} // namespace settle::exchange
