/// \file
/// Where a difference between MPM and FEM comes from (docs/theory.md).
#pragma once

#include <vector>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// The parts of MPM - FEM over probes after the last stage, for the usual fields of the case and those that its checks
/// compare between the two. Empty where either result, its probes or the exact solution are missing: the checks say so.
/// Throws InputError where the exact column does not exist.
std::vector<DifferenceSplit> difference_splits(const RunOutcome& run);

} // namespace settle::compare
