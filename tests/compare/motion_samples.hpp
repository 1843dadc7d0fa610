/// \file
/// Random points of a case, and the collection of differences at them.
#pragma once

#include <array>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "motion_calculus.hpp"
#include "motion_proof.hpp"
#include "settle/exchange/formulas.hpp"

namespace settle::compare::test {

/// A point on the edge of a polygon, at a stage in which the polygon is there.
struct EdgePoint {
  exchange::FormulaPoint at;
  Vector normal{};              ///< outwards
  std::optional<int> neighbour; ///< layer on the other side, if one has been placed
  const exchange::Support* support = nullptr;
};

/// Draws points, times and stages; the same ones in every run.
class Sampler {
public:
  explicit Sampler(const exchange::Case& study) : study_(study) {}
  exchange::FormulaPoint inside();
  EdgePoint on_edge();

private:
  const exchange::Case& study_;
  std::mt19937_64 engine_{20240131};

  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }
  int from_to(int first, int last) { return std::uniform_int_distribution<int>(first, last)(engine_); }
  exchange::FormulaPoint moment(int layer, const Vector& position);
};

/// Values that should be equal. Numerical derivatives come with two steps: where the two disagree there is a kink.
class Comparison {
public:
  explicit Comparison(std::string what) : what_(std::move(what)) {}

  template <std::size_t n>
  void add(const std::array<double, n>& value, const std::array<double, n>& with_half_step,
           const std::array<double, n>& expected) {
    scale_with(magnitude(value));
    scale_with(magnitude(expected));
    std::array<double, n> error{}, kink{};
    for (std::size_t i = 0; i < n; ++i) {
      error[i] = with_half_step[i] - expected[i];
      kink[i] = with_half_step[i] - value[i];
    }
    rows_.push_back({magnitude(error), magnitude(kink)});
  }
  template <std::size_t n>
  void add(const std::array<double, n>& value, const std::array<double, n>& expected) {
    add(value, value, expected);
  }
  /// What a difference is relative to, where it is more than the values compared.
  void scale_with(double size) { scale_ = std::max(scale_, size); }

  [[nodiscard]] Finding finding() const;

private:
  struct Row {
    double error, kink;
  };
  std::string what_;
  std::vector<Row> rows_;
  double scale_ = 0.0;
};

} // namespace settle::compare::test
