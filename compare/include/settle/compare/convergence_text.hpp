/// \file
/// A convergence study in words and rows: what the command line, the summary and the report all show.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/family.hpp"

namespace settle::compare {

/// One level as it is shown; empty where there is nothing.
struct ConvergenceRow {
  std::string size, value, error, order;
};

/// A row for each level that was measured, coarse to fine. Without an exact solution `error` is the change from the
/// level before, relative to the value.
std::vector<ConvergenceRow> rows_of(const ConvergenceStudy& study);

/// "converging: fitted order 1.02 ± 0.03 (expected 1, 0.8 to 1.5); the error falls ...", or why nothing can be said.
std::string conclusion_of(const ConvergenceStudy& study);

/// "three finest values: order 1.01, extrapolated 0.22 m, grid convergence index 0.1 %, ..."; empty where the values
/// have no order.
std::string extrapolation_of(const ConvergenceStudy& study);

} // namespace settle::compare
