// Where Newton's method stalls although the body stands: a slope of soil that does not dilate, near its limit load.
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "staged_problem.hpp"

namespace settle::fem::testing {
namespace {

constexpr double weight = 220.0 * 2000.0 * 10.0; // of the slope [N/m]

/// The slope of cases/soils, its strength divided by a factor.
exchange::Case weakened_slope(double factor, double element_size) {
  constexpr double radian = std::numbers::pi / 180.0;
  const double friction_angle = std::atan(std::tan(20.0 * radian) / factor) / radian;
  return exchange::read_case(
      std::filesystem::path(SETTLE_CASES) / "soils/slope.toml",
      std::vector<std::string>{fmt::format("fem.element_size={:.1f}", element_size),
                               fmt::format("material.soil.cohesion={:.6f}", 10e3 / factor),
                               fmt::format("material.soil.friction_angle={:.6f}", friction_angle)});
}

TEST(Relaxation, BalancesWhereNewtonsMethodStalls) {
  StagedProblem<2> problem(weakened_slope(1.34, 1.0));
  problem.begin(1);
  ASSERT_TRUE(problem.solve(1.0 / 3.0).reached());
  problem.accept();
  ASSERT_FALSE(problem.solve(2.0 / 3.0).reached());
  const Equilibrium relaxed = problem.relax(2.0 / 3.0);
  EXPECT_LE(relaxed.out_of_balance(), 1e-9);
  EXPECT_LE(relaxed.linear_solves, 200U);
  EXPECT_NEAR(relaxed.base_reaction, 2.0 / 3.0 * weight, 1e-9 * weight); // statics
}

TEST(Relaxation, ComesToTheSettlementOfNewtonsMethodWhereThatConverges) {
  const exchange::Case study = weakened_slope(1.3, 2.0);
  StagedProblem<2> newton(study), creeping(study);
  newton.begin(1);
  creeping.begin(1);
  ASSERT_TRUE(newton.solve(0.7).reached());
  ASSERT_TRUE(creeping.relax(0.7).reached());
  newton.accept();
  creeping.accept();
  double difference = 0.0, size = 0.0;
  for (const auto& cell : newton.placed_cells()) {
    const std::vector<double>& expected = newton.history().of(cell).displacement;
    const std::vector<double>& found = creeping.history().of(cell).displacement;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      difference = std::max(difference, std::abs(found[i] - expected[i]));
      size = std::max(size, std::abs(expected[i]));
    }
  }
  EXPECT_LT(difference, 1e-2 * size); // an increment without dilation has no one answer
}

TEST(Relaxation, EndsWhereNothingBalances) {
  StagedProblem<2> problem(weakened_slope(1.8, 2.0));
  problem.begin(1);
  const Equilibrium failed = problem.relax(1.0);
  EXPECT_FALSE(failed.reached());
  EXPECT_LE(failed.linear_solves, 200U);
  EXPECT_TRUE(problem.solve(0.2).reached()); // the history is as it was
}

} // namespace
} // namespace settle::fem::testing
