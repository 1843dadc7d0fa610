/// \file
/// Measuring one quantity over the levels of a family.
#pragma once

#include <vector>

#include "settle/compare/family.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// The runs of a family, coarse to fine.
using Levels = std::vector<const RunOutcome*>;

/// Sizes, errors or values of every level, and what they say. `is_expected`: the case states what it expects.
ConvergenceStudy study_of(const Levels& levels, const exchange::ExpectedConvergence& expected, bool is_expected);

} // namespace settle::compare
