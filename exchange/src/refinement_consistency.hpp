/// \file
/// Does the table `[converge]` of a case make sense in itself?
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Complains about lists of levels that do not fit together and about expectations that cannot be met. The case has
/// a table `[converge]`.
void check_refinement(const Case& study, Reading& reading);

} // namespace settle::exchange
