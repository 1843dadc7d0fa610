/// \file
/// The keys of `[geometry]` and the tables in it.
#pragma once

#include "settle/exchange/key_table.hpp"

namespace settle::exchange {

KeyTable<Geometry> geometry_keys();

} // namespace settle::exchange
