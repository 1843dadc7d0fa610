/// \file
/// What profiles differ by: each solver from the exact solution of what it solves, and MPM from FEM.
#pragma once

#include <string>

#include "chart.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

/// Over the height of a column at its last stage.
Chart difference_chart(const RunOutcome& run, exchange::Quantity quantity);
/// Along a line of probes of a body; of a vector or a tensor the norm of the difference.
Chart difference_chart(const RunOutcome& run, const std::string& line, exchange::Quantity quantity);

} // namespace settle::compare::report
