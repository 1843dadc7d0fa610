/// \file
/// What is exact of a case, as formulas and what they say (docs/theory.md).
#pragma once

#include <string>
#include <vector>

#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

struct Formula {
  std::string text;    ///< in the language of cases (mathml.hpp)
  std::string meaning; ///< may be empty
};

struct FormulaGroup {
  std::string title;
  std::vector<Formula> formulas;
};

/// Of a column the closed form of each model that the run's solvers solve, of a body the formulas of its motion; empty
/// where nothing but the mass is known.
std::vector<FormulaGroup> exact_formulas(const RunOutcome& run);

} // namespace settle::compare::report
