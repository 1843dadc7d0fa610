#include "settle/compare/convergence.hpp"

#include <cmath>

#include <boost/math/tools/toms748_solve.hpp>

namespace settle::compare {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum / static_cast<double>(values.size());
}

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> logs;
  for (const double value : values)
    logs.push_back(value > 0.0 ? std::log(value) : nan);
  return logs;
}

/// ln of (h3^p - h2^p)/(h2^p - h1^p), from fine = ln(h2/h1) and coarse = ln(h3/h2). Rises with p.
double log_ratio_of_changes(double p, double fine, double coarse) {
  const double quotient = p == 0.0 ? coarse / fine : std::expm1(p * coarse) / std::expm1(p * fine);
  return p * fine + std::log(quotient);
}

/// The order at which changes of this ratio occur; NaN where there is none of a size that means anything.
double order_of_changes(double ratio, double fine, double coarse) {
  constexpr double largest = 50.0;
  if (!(ratio > 0.0) || !std::isfinite(ratio)) return nan;
  const auto residual = [&](double p) { return log_ratio_of_changes(p, fine, coarse) - std::log(ratio); };
  const double at_lower = residual(-largest);
  const double at_upper = residual(largest);
  if (!(at_lower < 0.0 && at_upper > 0.0)) return nan;
  std::uintmax_t iterations = 200;
  const auto root = boost::math::tools::toms748_solve(residual, -largest, largest, at_lower, at_upper,
                                                      boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (root.first + root.second);
}

/// 1.25 |f1 - f2| / |f1| / (r^p - 1).
double grid_convergence_index(const GridLevel& fine, const GridLevel& coarse, double order) {
  constexpr double safety_factor = 1.25; // Roache 1994, for three grids or more
  const double change = std::abs((fine.value - coarse.value) / fine.value);
  return safety_factor * change / std::expm1(order * std::log(coarse.size / fine.size));
}

} // namespace

double FittedOrder::error_at(double size) const {
  return constant * std::pow(size, order);
}

std::vector<double> pairwise_orders(const std::vector<double>& sizes, const std::vector<double>& errors) {
  const std::vector<double> x = logarithms(sizes);
  const std::vector<double> y = logarithms(errors);
  std::vector<double> orders;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    orders.push_back((y[i] - y[i + 1]) / (x[i] - x[i + 1]));
  return orders;
}

FittedOrder fitted_order(const std::vector<double>& sizes, const std::vector<double>& errors) {
  const std::vector<double> x = logarithms(sizes);
  const std::vector<double> y = logarithms(errors);
  const double x_mean = mean(x);
  const double y_mean = mean(y);
  double xx = 0.0;
  double xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  FittedOrder fit;
  fit.order = xy / xx;
  fit.constant = std::exp(y_mean - fit.order * x_mean);
  double residuals = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    residuals += std::pow(y[i] - y_mean - fit.order * (x[i] - x_mean), 2);
  if (x.size() > 2) fit.standard_error = std::sqrt(residuals / static_cast<double>(x.size() - 2) / xx);
  return fit;
}

GridConvergence grid_convergence(const std::array<GridLevel, 3>& levels) {
  const auto& [fine, middle, coarse] = levels;
  GridConvergence found;
  const double log_fine_ratio = std::log(middle.size / fine.size);
  const double log_coarse_ratio = std::log(coarse.size / middle.size);
  found.order =
      order_of_changes((coarse.value - middle.value) / (middle.value - fine.value), log_fine_ratio, log_coarse_ratio);
  found.extrapolated = fine.value + (fine.value - middle.value) / std::expm1(found.order * log_fine_ratio);
  found.fine_index = grid_convergence_index(fine, middle, found.order);
  found.coarse_index = grid_convergence_index(middle, coarse, found.order);
  found.asymptotic_ratio = std::exp(found.order * log_fine_ratio) * found.fine_index / found.coarse_index;
  return found;
}

} // namespace settle::compare
