/// \file
/// What goes with a case that may fail (`construction.may_fail`).
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Complains about what the explicit scheme of the material point method cannot follow to failure and beyond.
void check_failure(const Case& study, Reading& reading);

} // namespace settle::exchange
