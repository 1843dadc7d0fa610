/// \file
/// The levels of a case's refinement study: what is set on each, and the size that orders refer to.
#pragma once

#include <string>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// The overrides (`key=value`) of each level of the case's `[converge]`, coarse to fine. Throws InputError where the
/// case has no such table.
std::vector<std::vector<std::string>> level_overrides(const exchange::Case& study);

/// The size h of one level, of a case with `[converge]`: the solver's element size or the thickness of a layer [m], or
/// one over the solver's increments a stage [-].
double level_size(const exchange::Case& study, const std::string& solver);

/// "element size [m]", ...
std::string size_title(exchange::RefinedSize size);

/// Throws InputError unless the size of each level is smaller than that of the level before, for every solver.
/// `levels`: the case with the overrides of each level.
void require_finer_levels(const std::vector<exchange::Case>& levels, const std::vector<std::string>& solvers);

} // namespace settle::compare
