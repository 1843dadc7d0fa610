/// \file
/// The one list of keys of case files.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/key_table.hpp"

namespace settle::exchange {

KeyTable<Case> case_keys();

} // namespace settle::exchange
