/// \file
/// The keys of a material.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/key_table.hpp"

namespace settle::exchange {

KeyTable<Material> material_keys();

} // namespace settle::exchange
