/// \file
/// A body of two layers of polygons with a stated motion, and solvers that make no error on it.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/field_samples.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare::test {

/// Two layers, 2 m wide and 1 m high each, on a fixed base; the case as text, further lines at its end.
std::string body_text(const std::string& motion, const std::string& more = "");

/// The motion of `body_state`, which grows with the stage and differs between layers.
std::string stated_motion();

/// That case, with overrides.
exchange::Case body_case(const std::vector<std::string>& overrides = {});

/// The motion written once more, in C++.
MaterialState body_state(double x, double y, int layer, int stage);

/// mpm and fem, both following `body_state` at 8 points in each layer and at the case's probes.
RunOutcome perfect_body_run(const exchange::Case& study);

} // namespace settle::compare::test
