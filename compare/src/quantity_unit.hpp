/// \file
/// Units of what is compared.
#pragma once

#include <string>

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// "m", "Pa", ...; forces and masses are per metre out of plane in 2-D.
std::string unit_of(exchange::Quantity quantity, int dimension);

} // namespace settle::compare
