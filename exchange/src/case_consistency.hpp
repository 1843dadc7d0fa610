/// \file
/// What one key of a case says about another: names that must exist, entries that must differ, places inside the
/// column.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Complains about every name or number that does not fit the rest of the case.
void check_consistency(const Case& study, Reading& reading);

} // namespace settle::exchange
