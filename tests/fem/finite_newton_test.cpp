#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "finite_column.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::fem::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A single lift of the law `rate`: its lowest point is compressed to exp(-gamma H/M) of its height.
exchange::Case soft_column(double youngs_modulus) {
  FiniteOptions options;
  options.column = {.layers = 1, .increments = 1};
  exchange::Case study = finite_column(options);
  study.materials["fill"].youngs_modulus = youngs_modulus;
  return study;
}

TEST(Newton, ConvergesInAFewStepsWhereStrainIsModerate) {
  FiniteOptions options;
  options.convention = exchange::Convention::level_up;
  for (const exchange::Law law : {exchange::Law::rate, exchange::Law::hencky, exchange::Law::neo_hookean}) {
    options.law = law;
    for (const exchange::Stage& stage : solve(finite_column(options))) {
      EXPECT_LE(stage.linear_solves, 4 * 6) << exchange::name_of(law); // strain of 1 % an increment: quadratic
      EXPECT_LT(stage.out_of_balance, 1e-10);
    }
  }
}

TEST(Newton, ShortensStepsThatWouldTurnCellsInsideOut) {
  const exchange::Case study = soft_column(1e4); // a full first step would strain the base by -7
  const exchange::Stage stage = solve(study).back();
  EXPECT_EQ(stage.steps, 1);
  EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
  EXPECT_LT(stage.surface_height, 1.0);
}

TEST(Newton, HalvesTheIncrementWhereOneIsTooMuchAndComesToTheSameState) {
  exchange::Case study = soft_column(5e3);
  const exchange::Stage halved = solve(study).back();
  EXPECT_GT(halved.steps, 1);
  EXPECT_NEAR(halved.base_reaction, halved.weight, 1e-9 * halved.weight);
  study.fem.increments = 40;
  const exchange::Stage in_small_steps = solve(study).back();
  EXPECT_EQ(in_small_steps.steps, 40);
  EXPECT_NEAR(halved.surface_height, in_small_steps.surface_height, 1e-9);
}

TEST(Newton, EndsWithEveryResidualWhereNoIncrementIsShortEnough) {
  for (const double modulus : {500.0, 100.0}) {
    try {
      static_cast<void>(solve(soft_column(modulus)));
      FAIL() << "a column a hundred times as heavy as it is stiff has been built";
    } catch (const exchange::NotConverged& error) {
      EXPECT_THAT(error.what(),
                  AllOf(HasSubstr("no equilibrium in layer 1 between"), HasSubstr("of its gravity"),
                        HasSubstr("relative residuals "), HasSubstr("halved"), HasSubstr("fem.increments")));
    }
  }
}

TEST(Newton, ReportsNoStageThatIsNotInEquilibrium) {
  int stages = 0;
  exchange::Case study = soft_column(100.0);
  EXPECT_THROW(Solver(study).build([&](const exchange::Stage&) { ++stages; }), exchange::NotConverged);
  EXPECT_EQ(stages, 0);
}

} // namespace
} // namespace settle::fem::testing
