/// \file
/// Verdicts of refinement families.
#pragma once

#include <vector>

#include "settle/compare/family.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// The families among judged runs, measured and judged, in the order of their first runs. Every expectation of the case
/// gets a verdict, with those on its finest error and on its scatter; a solver of which the case expects nothing gets
/// one that is missing.
std::vector<Family> families_of(const std::vector<RunOutcome>& runs);

} // namespace settle::compare
