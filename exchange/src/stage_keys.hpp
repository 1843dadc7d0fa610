/// \file
/// The keys of what happens one after the other: stages of a construction, legs of the path of a material point.
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/key_table.hpp"

namespace settle::exchange {

KeyTable<StageEntry> stage_keys();
KeyTable<PathLeg> path_keys();
KeyTable<InitialState> initial_keys();

} // namespace settle::exchange
