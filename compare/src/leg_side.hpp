/// \file
/// The two sides of a leg: what a name in a check stands for.
#pragma once

#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// In the order in which they serve as reference: the exact solution first.
enum class Side { exact, table, solver };

Side side_of(const RunOutcome& run, const std::string& name);

/// Why a side has nothing to give at a stage; empty where it has.
std::string absence_of(const RunOutcome& run, const std::string& name, int stage);

/// A stage, numbered from 1, of a result that has it.
const exchange::Stage& stage_of(const exchange::Result& result, int stage);

/// Kinematics of the exact solution a side is held against: a solver's own; tables come from large-deformation codes.
exchange::Kinematics kinematics_of(const RunOutcome& run, const std::string& name);

} // namespace settle::compare
