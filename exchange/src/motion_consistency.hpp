/// \file
/// Does the table `[motion]` of a case go with the rest? Its formulas are checked by compiling them (formulas.hpp).
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Complains about a motion in time that would be built in layers or damped. The case has a table `[motion]`.
void check_motion(const Case& study, Reading& reading);

/// Complains about a motion in time whose displacement is not zero at its start, at corners and inside of polygons.
void check_start(const Case& study, const Formulas& formulas, Reading& reading);

} // namespace settle::exchange
