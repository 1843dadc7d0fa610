#include "settle/compare/convergence.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace settle::compare::test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

/// C h^p at each size.
std::vector<double> power_law(const std::vector<double>& sizes, double constant, double order) {
  std::vector<double> errors;
  for (const double size : sizes)
    errors.push_back(constant * std::pow(size, order));
  return errors;
}

const std::vector<double> halved{0.25, 0.125, 0.0625, 0.03125};
const std::vector<double> uneven{0.3, 0.17, 0.1, 0.04};

TEST(PairwiseOrders, ArePowersOfAPowerLawWhateverTheRatios) {
  for (const auto& sizes : {halved, uneven}) {
    for (const double order : {0.5, 1.0, 2.0}) {
      const std::vector<double> expected(3, order);
      EXPECT_THAT(pairwise_orders(sizes, power_law(sizes, 7.0, order)), Pointwise(DoubleNear(1e-12), expected));
    }
  }
}

TEST(PairwiseOrders, OfAnErrorThatIsZeroAreNotNumbers) {
  const auto orders = pairwise_orders({0.4, 0.2, 0.1}, {0.1, 0.0, 0.1});
  EXPECT_TRUE(std::isnan(orders[0]));
  EXPECT_TRUE(std::isnan(orders[1]));
}

TEST(FittedOrder, OfAPowerLawIsItsOrderAndLeavesNoResidual) {
  const FittedOrder fit = fitted_order(uneven, power_law(uneven, 7.0, 1.5));
  EXPECT_NEAR(fit.order, 1.5, 1e-12);
  EXPECT_NEAR(fit.constant, 7.0, 1e-11);
  EXPECT_NEAR(fit.standard_error, 0.0, 1e-7);
  EXPECT_NEAR(fit.error_at(0.1), 7.0 * std::pow(0.1, 1.5), 1e-12);
}

TEST(FittedOrder, IsLeastSquaresWithTheStandardErrorOfItsSlope) {
  // ln h = 2, 1, 0 and ln e = 2, 1.5, 0: slope 1, residuals -1/6, 1/3, -1/6, so s^2 = (1/6)/1 and s_p^2 = s^2/2
  const FittedOrder fit = fitted_order({std::exp(2.0), std::exp(1.0), 1.0}, {std::exp(2.0), std::exp(1.5), 1.0});
  EXPECT_NEAR(fit.order, 1.0, 1e-14);
  EXPECT_NEAR(std::log(fit.constant), 1.0 / 6.0, 1e-14);
  EXPECT_NEAR(fit.standard_error, std::sqrt(1.0 / 12.0), 1e-14);
}

TEST(FittedOrder, OfTwoLevelsHasNoStandardError) {
  const FittedOrder fit = fitted_order({0.2, 0.1}, {0.04, 0.01});
  EXPECT_NEAR(fit.order, 2.0, 1e-14);
  EXPECT_TRUE(std::isnan(fit.standard_error));
}

TEST(GridConvergence, HoldsAPublishedVectorToAllItsDigits) {
  // NPARC Alliance, "Examining spatial (grid) convergence": pressure recovery of an inlet on three grids
  const GridConvergence found = grid_convergence({{{1.0, 0.97050}, {2.0, 0.96854}, {4.0, 0.96178}}});
  EXPECT_NEAR(found.order, 1.786170, 5e-7);
  EXPECT_NEAR(found.extrapolated, 0.971300, 5e-7);
  EXPECT_NEAR(100.0 * found.fine_index, 0.103083, 5e-7);
  EXPECT_NEAR(100.0 * found.coarse_index, 0.356249, 5e-7);
  EXPECT_NEAR(found.asymptotic_ratio, 0.997980, 5e-7);
}

TEST(GridConvergence, OfAPowerLawFindsOrderAndLimitWhateverTheRatios) {
  for (const double order : {0.5, 1.0, 2.0, 3.7}) {
    const auto f = [order](double h) { return GridLevel{h, 2.0 - 3.0 * std::pow(h, order)}; };
    for (const auto& h : {std::array{0.1, 0.2, 0.4}, std::array{0.1, 0.13, 0.4}, std::array{0.1, 0.3, 0.4}}) {
      const GridConvergence found = grid_convergence({{f(h[0]), f(h[1]), f(h[2])}});
      EXPECT_NEAR(found.order, order, 1e-9);
      EXPECT_NEAR(found.extrapolated, 2.0, 1e-9);
      EXPECT_NEAR(found.fine_index, 1.25 * std::abs(found.extrapolated / f(h[0]).value - 1.0), 1e-9);
    }
  }
}

TEST(GridConvergence, OfGrowingChangesHasANegativeOrder) {
  EXPECT_NEAR(grid_convergence({{{0.1, 7.0}, {0.2, 3.0}, {0.4, 1.0}}}).order, -1.0, 1e-12);
}

TEST(GridConvergence, WithoutAnOrderSaysSo) {
  for (const double coarse : {1.1, 2.0}) { // changes of different signs; no change between the coarser two
    const GridConvergence found = grid_convergence({{{0.1, 1.0}, {0.2, 2.0}, {0.4, coarse}}});
    EXPECT_TRUE(std::isnan(found.order)) << coarse;
    EXPECT_TRUE(std::isnan(found.fine_index)) << coarse;
  }
  EXPECT_TRUE(std::isnan(grid_convergence({{{0.1, 1.0}, {0.2, 1.0}, {0.4, 2.0}}}).order));
}

} // namespace
} // namespace settle::compare::test
