#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "finite_column.hpp"
#include "staged_problem.hpp"

namespace settle::fem::testing {
namespace {

/// A single lift so soft that a full Newton step would turn cells inside out, or leave them farther from equilibrium.
TEST(LineSearch, TakesNoStepThatDoesNotBringTheResidualDown) {
  FiniteOptions options;
  options.column = {.layers = 1, .increments = 1};
  exchange::Case study = finite_column(options);
  for (const double modulus : {2e4, 1.5e4, 1e4}) {
    study.materials["fill"].youngs_modulus = modulus;
    StagedProblem<2> problem(study);
    problem.begin(1);
    const Equilibrium equilibrium = problem.solve(1.0);
    EXPECT_TRUE(equilibrium.reached()) << modulus;
    EXPECT_GT(equilibrium.linear_solves, 3U) << modulus;
    EXPECT_TRUE(std::is_sorted(equilibrium.residuals.rbegin(), equilibrium.residuals.rend()))
        << modulus << ": " << ::testing::PrintToString(equilibrium.residuals);
  }
}

} // namespace
} // namespace settle::fem::testing
