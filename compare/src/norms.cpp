#include "settle/compare/norms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace settle::compare {
namespace {

/// Squares of the Euclidean norms of n points, c components each.
std::vector<double> squares_of(const std::vector<double>& values, std::size_t n) {
  std::vector<double> squares(n, 0.0);
  const std::size_t components = n > 0 ? values.size() / n : 0;
  for (std::size_t i = 0; i < n * components; ++i)
    squares[i / components] += values[i] * values[i];
  return squares;
}

double l2(const std::vector<double>& squares, const std::vector<double>& weights) {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    sum += weights[i] * squares[i];
    total += weights[i];
  }
  return std::sqrt(sum / total); // no values: 0/0
}

double linf(const std::vector<double>& squares) {
  if (squares.empty()) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0.0;
  for (const double square : squares) {
    if (std::isnan(square)) return square; // a comparison would skip it
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

std::size_t count_not_finite(const std::vector<double>& values) {
  std::size_t count = 0;
  for (const double value : values)
    count += std::isfinite(value) ? 0U : 1U;
  return count;
}

std::string problem_of(const LegSamples& samples) {
  if (!samples.problem.empty()) return samples.problem;
  if (samples.size() == 0) return "there are no points to compare";
  if (samples.value.size() != samples.reference.size()) {
    return fmt::format("one side has {} numbers at {} points, the other {}", samples.value.size(), samples.size(),
                       samples.reference.size());
  }
  const std::size_t bad = count_not_finite(samples.value) + count_not_finite(samples.reference);
  if (bad > 0) return fmt::format("{} of {} values are NaN or infinite", bad, 2 * samples.value.size());
  for (const double weight : samples.weight) {
    if (!(weight > 0.0) || !std::isfinite(weight)) return fmt::format("a point has the volume {}", weight);
  }
  return {};
}

} // namespace

double norm_of(const std::vector<double>& values, const std::vector<double>& weights, exchange::Norm norm) {
  const std::vector<double> squares = squares_of(values, weights.size());
  switch (norm) {
  case exchange::Norm::l2:
    return l2(squares, weights);
  case exchange::Norm::linf:
    return linf(squares);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

RelativeNorm relative_norm(const LegSamples& samples, exchange::Norm norm, std::optional<double> scale) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  RelativeNorm result{.value = none, .scale = none, .problem = problem_of(samples)};
  if (!result.problem.empty()) return result;
  result.scale = scale ? *scale : norm_of(samples.reference, samples.weight, norm);
  if (!(result.scale > 0.0)) {
    result.problem = "the reference is zero everywhere, so nothing can be relative to it: give `scale` a number";
    return result;
  }
  std::vector<double> difference(samples.value.size());
  for (std::size_t i = 0; i < difference.size(); ++i)
    difference[i] = samples.value[i] - samples.reference[i];
  result.value = norm_of(difference, samples.weight, norm) / result.scale;
  return result;
}

} // namespace settle::compare
