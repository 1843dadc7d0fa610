/// \file
/// What a sequence of levels, coarse to fine, says about convergence: observed orders, Richardson extrapolation, the
/// grid convergence index, and a verdict. docs/convergence.md has the definitions and their sources.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// The thresholds of a verdict.
struct ConvergenceRules {
  double least_order = 0.25; ///< a pair of levels falls (rises) if its order is above this (below minus this) [-]
  double round_off = 1e-10;  ///< relative errors and relative changes up to this are taken for round-off [-]
};

/// Between each level and the next finer one, (n - 1): ln(e_i / e_{i+1}) / ln(h_i / h_{i+1}) (Roache 1994).
/// NaN where an error is zero or not a number.
std::vector<double> pairwise_orders(const std::vector<double>& sizes, const std::vector<double>& errors);

/// The straight line ln e = ln C + p ln h of least squares.
struct FittedOrder {
  double order = std::numeric_limits<double>::quiet_NaN();          ///< p [-]
  double standard_error = std::numeric_limits<double>::quiet_NaN(); ///< of p; NaN for fewer than three levels
  double constant = std::numeric_limits<double>::quiet_NaN();       ///< C, unit of the error over that of h^p

  /// The line's error at a size.
  [[nodiscard]] double error_at(double size) const;
};

/// Fits all levels. NaN where an error is zero or not a number.
FittedOrder fitted_order(const std::vector<double>& sizes, const std::vector<double>& errors);

/// A level of a study that knows no exact value: size h and value f.
struct GridLevel {
  double size = 0;
  double value = 0;
};

/// What three levels say without an exact value (Celik et al. 2008). NaN where the two changes have different signs or
/// one of them is zero: there is no order then.
struct GridConvergence {
  double order = std::numeric_limits<double>::quiet_NaN();            ///< p [-]
  double extrapolated = std::numeric_limits<double>::quiet_NaN();     ///< Richardson, unit of the value
  double fine_index = std::numeric_limits<double>::quiet_NaN();       ///< GCI of the finest and the next level [-]
  double coarse_index = std::numeric_limits<double>::quiet_NaN();     ///< GCI of the two coarser levels [-]
  double asymptotic_ratio = std::numeric_limits<double>::quiet_NaN(); ///< r^p fine_index / coarse_index: near one [-]
};

/// Three levels, **fine to coarse**; ratios of sizes may differ. The order p solves
/// (f3 - f2)/(f2 - f1) = (h3^p - h2^p)/(h2^p - h1^p). GCI = 1.25 |f1 - f2| / |f1| / (r^p - 1) (Roache 1994).
GridConvergence grid_convergence(const std::array<GridLevel, 3>& levels);

/// What is said of a whole sequence.
struct ConvergenceFinding {
  exchange::Convergence verdict = exchange::Convergence::undetermined;
  double order =
      std::numeric_limits<double>::quiet_NaN(); ///< fitted to errors; of the finest three where there are none
  double band = std::numeric_limits<double>::quiet_NaN(); ///< standard error of the fit; half the spread of the orders
  std::vector<double> pairwise{};                         ///< (n - 1) with errors, (n - 2) without
  FittedOrder fit{};                                      ///< with errors only
  std::string reason{};                                   ///< what the verdict follows from, in a sentence
};

/// The verdict on relative errors against a known value. Throws std::invalid_argument unless sizes fall and match.
ConvergenceFinding judge_errors(const std::vector<double>& sizes, const std::vector<double>& errors,
                                const ConvergenceRules& rules = {});

/// The verdict on values where no exact one is known, from their changes between levels. Throws likewise.
ConvergenceFinding judge_values(const std::vector<double>& sizes, const std::vector<double>& values,
                                const ConvergenceRules& rules = {});

} // namespace settle::compare
