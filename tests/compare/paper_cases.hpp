/// \file
/// The paper's column, and small variations of it.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::compare::test {

/// E = 400 kPa, nu = 0.25, 1720 kg/m3, 5 m high, g = 9.81 m/s2, with nine probes a layer.
exchange::Case paper_case(int layers, exchange::Convention convention, exchange::Law law = exchange::Law::rate);

} // namespace settle::compare::test
