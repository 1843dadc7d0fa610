// What Newton's method does on the way to equilibrium, or to none.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "finite_column.hpp"
#include "staged_problem.hpp"

namespace settle::fem::testing {
namespace {

/// All of the weight of a lift in one increment, by its Young's modulus [Pa].
Equilibrium solve_at_once(double youngs_modulus) {
  FiniteOptions options;
  options.column = {.layers = 1, .increments = 1};
  exchange::Case study = finite_column(options);
  study.materials["fill"].youngs_modulus = youngs_modulus;
  StagedProblem<2> problem(study);
  problem.activate(1);
  return problem.solve(1.0);
}

TEST(NewtonSteps, NeverRaiseTheResidual) {
  for (const double modulus : {1e5, 5e4, 2e4, 1e4, 5e3, 2e3, 1e3}) {
    const std::vector<double> residuals = solve_at_once(modulus).residuals;
    EXPECT_GT(residuals.size(), 2U);
    EXPECT_TRUE(std::is_sorted(residuals.rbegin(), residuals.rend()))
        << modulus << " Pa: " << ::testing::PrintToString(residuals);
  }
}

} // namespace
} // namespace settle::fem::testing
