/// \file
/// How the reaction is distributed along the base of a body.
#pragma once

#include "chart.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

/// Vertical stress at the last stage along the supports on which a body stands, of every solver with points of its own
/// and, where the case states the stress, exact: means over stretches of half an element, of points nearer to the base
/// than that. No series where there is no base, or nobody has points there.
Chart base_chart(const RunOutcome& run);

} // namespace settle::compare::report
