/// \file
/// Whether the legs of single material points make paths.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Gives every leg its control, and points their first stress, where the case does not say.
void fill_paths(Case& study);

void check_paths(const Case& study, Reading& reading);

} // namespace settle::exchange
