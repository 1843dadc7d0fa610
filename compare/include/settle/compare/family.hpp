/// \file
/// A refinement family: the runs of one case on all its levels, what was measured on them, and what is said of it.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/convergence.hpp"
#include "settle/compare/verdict.hpp"

namespace settle::compare {

/// One quantity of one solver over the n levels of a family, coarse to fine.
struct ConvergenceStudy {
  exchange::ExpectedConvergence expected{}; ///< what is measured, and what the case expects of it
  bool is_expected = true;                  ///< false: the case says nothing of this solver, so nothing can pass
  std::vector<double> sizes{};              ///< (n)
  std::vector<double> errors{};             ///< (n) relative to the norm of the exact solution; empty against itself
  std::vector<double> values{};             ///< (n) norm of the solver's values, `unit`
  std::vector<double> exact{};              ///< (n) norm of the exact values, `unit`; empty against itself
  std::string unit{};
  ConvergenceFinding finding{};
  GridConvergence grid{}; ///< of the values of the three finest levels
  std::string problem{};  ///< why a level could not be measured; empty where all could

  /// "settlement, mpm - exact, l2 over points"
  [[nodiscard]] std::string title() const;
};

struct Family {
  std::string name{};
  std::vector<std::string> runs{}; ///< (n) coarse to fine
  exchange::RefinedSize size = exchange::RefinedSize::element_size;
  std::vector<ConvergenceStudy> studies{};
  std::vector<Verdict> verdicts{};
};

} // namespace settle::compare
