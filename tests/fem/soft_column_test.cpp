#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "finite_column.hpp"
#include "staged_problem.hpp"

namespace settle::fem::testing {
namespace {

/// By law `rate` the lowest point of a lift is compressed to exp(-gamma H/M) of its height, here far below round-off
/// of a length.
class SoftColumn : public ::testing::TestWithParam<double> {
protected:
  SoftColumn() : study(finite_column({.column = {.layers = 1, .increments = 1}})) {
    study.materials["fill"].youngs_modulus = GetParam();
  }
  exchange::Case study;
};

/// Of the part of the increment that was tried at first, as far as an equilibrium is found for it.
constexpr double shortest = 1.0 / 64.0;

TEST_P(SoftColumn, StartsEveryIncrementFromAStateThatHasAStress) {
  StagedProblem<2> problem(study);
  problem.begin(1);
  double reached = 0.0, step = 1.0;
  while (reached < 1.0 && step >= shortest) {
    const Equilibrium equilibrium = problem.solve(std::min(1.0, reached + step));
    EXPECT_TRUE(std::isfinite(equilibrium.residuals.front())) << "at " << reached << " of its gravity";
    if (equilibrium.reached()) {
      problem.accept();
      reached = std::min(1.0, reached + step);
    } else {
      step /= 2.0;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modulus, SoftColumn, ::testing::Values(5e3, 1e3, 500.0, 250.0));

} // namespace
} // namespace settle::fem::testing
