/// \file
/// How settlement grew with the construction.
#pragma once

#include "chart.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

/// The largest settlement after each stage: of every solver with a result, and of what they solve where that is known.
/// The key says the last value. Without series where no solver has a result.
Chart history_chart(const RunOutcome& run);

} // namespace settle::compare::report
