#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/compare/convergence.hpp"

namespace settle::compare::test {
namespace {

using exchange::Convergence;
using testing::HasSubstr;

/// Sizes 1, 1/2, 1/4, ...
std::vector<double> halved(std::size_t count) {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < count; ++i)
    sizes.push_back(std::ldexp(1.0, -static_cast<int>(i)));
  return sizes;
}

ConvergenceFinding of_errors(const std::vector<double>& errors) {
  return judge_errors(halved(errors.size()), errors);
}
ConvergenceFinding of_values(const std::vector<double>& values) {
  return judge_values(halved(values.size()), values);
}

TEST(VerdictOnErrors, IsConvergingWhereTheyFallDownToTheFinestLevel) {
  const ConvergenceFinding finding = of_errors({0.08, 0.041, 0.019, 0.01});
  EXPECT_EQ(finding.verdict, Convergence::converging);
  EXPECT_NEAR(finding.order, 1.01, 0.02);
  EXPECT_GT(finding.band, 0.0);
  EXPECT_LT(finding.band, 0.1);
  EXPECT_EQ(finding.pairwise.size(), 3U);
}

TEST(VerdictOnErrors, IsConvergingWithUnevenSizes) {
  const ConvergenceFinding finding = judge_errors({0.3, 0.17, 0.1}, {9.0, 2.89, 1.0});
  EXPECT_EQ(finding.verdict, Convergence::converging);
  EXPECT_NEAR(finding.order, 2.0, 1e-12);
}

TEST(VerdictOnErrors, IsConvergingWhereOnePairStandsStillAndTheFinestFall) {
  EXPECT_EQ(of_errors({0.08, 0.04, 0.041, 0.02, 0.01}).verdict, Convergence::converging);
}

TEST(VerdictOnErrors, IsFloorLimitedWhereTheyStopFalling) {
  const ConvergenceFinding finding = of_errors({0.08, 0.02, 0.005, 0.0046, 0.0049});
  EXPECT_EQ(finding.verdict, Convergence::floor_limited);
  EXPECT_THAT(finding.reason, HasSubstr("from level 3 on"));
}

TEST(VerdictOnErrors, IsFloorLimitedWhereTheyNeverChange) {
  EXPECT_EQ(of_errors({0.5, 0.5, 0.5}).verdict, Convergence::floor_limited);
  EXPECT_THAT(of_errors({0.5, 0.5, 0.5}).reason, HasSubstr("from level 1 on"));
}

TEST(VerdictOnErrors, IsFloorLimitedAtRoundOffHoweverItScatters) {
  EXPECT_EQ(of_errors({3e-15, 1e-13, 2e-14, 8e-12}).verdict, Convergence::floor_limited);
  EXPECT_EQ(of_errors({1e-4, 1e-7, 3e-14, 1e-12}).verdict, Convergence::floor_limited);
  EXPECT_EQ(of_errors({0.0, 0.0, 0.0}).verdict, Convergence::floor_limited);
}

TEST(VerdictOnErrors, IsConvergingWhereOnlyTheFinestLevelReachesRoundOff) {
  EXPECT_EQ(of_errors({1e-4, 1e-8, 1e-15}).verdict, Convergence::converging);
}

TEST(VerdictOnErrors, IsOscillatingWhereTheyFallAndRise) {
  EXPECT_EQ(of_errors({0.1, 0.05, 0.1, 0.05}).verdict, Convergence::oscillating);
  EXPECT_EQ(of_errors({0.1, 0.05, 0.025, 0.05}).verdict, Convergence::oscillating);
  EXPECT_EQ(of_errors({0.05, 0.1, 0.02, 0.01}).verdict, Convergence::oscillating);
}

TEST(VerdictOnErrors, IsDivergingWhereTheyRise) {
  EXPECT_EQ(of_errors({0.1, 0.2, 0.4}).verdict, Convergence::diverging);
  EXPECT_EQ(of_errors({0.1, 0.1, 0.4}).verdict, Convergence::diverging);
  EXPECT_LT(of_errors({0.1, 0.2, 0.4}).order, 0.0);
  EXPECT_EQ(of_errors({1e-15, 1e-3, 1e-2}).verdict, Convergence::diverging);
}

TEST(VerdictOnErrors, IsFloorLimitedWhereTheyRiseOnceAndStayFlatAsAWhole) {
  const ConvergenceFinding finding = of_errors({0.22, 0.19, 0.23, 0.23, 0.22});
  EXPECT_LT(finding.pairwise[1], -0.25);
  EXPECT_EQ(finding.verdict, Convergence::floor_limited);
}

TEST(VerdictOnErrors, IsDivergingWhereTheyTurnForGood) {
  EXPECT_EQ(of_errors({0.1, 0.05, 0.025, 0.05, 0.1}).verdict, Convergence::diverging);
}

TEST(VerdictOnErrors, IsUndeterminedForTwoLevels) {
  const ConvergenceFinding finding = of_errors({0.2, 0.1});
  EXPECT_EQ(finding.verdict, Convergence::undetermined);
  EXPECT_THAT(finding.reason, HasSubstr("too few levels"));
  EXPECT_EQ(of_errors({}).verdict, Convergence::undetermined);
}

TEST(VerdictOnErrors, IsUndeterminedForWhatIsNotANumber) {
  for (const double bad : {std::nan(""), HUGE_VAL}) {
    const ConvergenceFinding finding = of_errors({0.2, bad, 0.05, 0.02});
    EXPECT_EQ(finding.verdict, Convergence::undetermined);
    EXPECT_THAT(finding.reason, HasSubstr("level 2"));
    EXPECT_TRUE(std::isnan(finding.order));
  }
}

TEST(VerdictOnErrors, ChangesAtTheStatedThresholdOnly) {
  const double below = std::pow(2.0, -0.24);
  const double above = std::pow(2.0, -0.26);
  EXPECT_EQ(of_errors({0.4, 0.2, 0.2 * below}).verdict, Convergence::floor_limited);
  EXPECT_EQ(of_errors({0.4, 0.2, 0.2 * above}).verdict, Convergence::converging);
  EXPECT_EQ(of_errors({0.4, 0.2, 0.2 / below}).verdict, Convergence::floor_limited);
  EXPECT_EQ(of_errors({0.4, 0.2, 0.2 / above}).verdict, Convergence::oscillating);
}

TEST(VerdictOnErrors, NeedsSizesFromCoarseToFine) {
  EXPECT_THROW(judge_errors({0.1, 0.2, 0.4}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(judge_errors({0.4, 0.4, 0.1}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(judge_errors({0.4, 0.2, 0.0}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(judge_errors({0.4, 0.2}, {1, 2, 3}), std::invalid_argument);
  EXPECT_THROW(judge_values({0.1, 0.2, 0.4}, {1, 2, 3}), std::invalid_argument);
}

TEST(VerdictOnValues, IsConvergingWhereChangesBecomeSmaller) {
  const ConvergenceFinding finding = of_values({2.0, 1.5, 1.25, 1.125});
  EXPECT_EQ(finding.verdict, Convergence::converging);
  EXPECT_NEAR(finding.order, 1.0, 1e-12);
  EXPECT_NEAR(finding.band, 0.0, 1e-12);
  EXPECT_EQ(finding.pairwise.size(), 2U);
}

TEST(VerdictOnValues, HasNoBandForOneTriplet) {
  EXPECT_TRUE(std::isnan(of_values({2.0, 1.5, 1.25}).band));
}

TEST(VerdictOnValues, IsOscillatingWhereChangesAlternate) {
  EXPECT_EQ(of_values({2.0, 1.5, 1.75, 1.625}).verdict, Convergence::oscillating);
}

TEST(VerdictOnValues, IsDivergingWhereChangesDoNotBecomeSmaller) {
  EXPECT_EQ(of_values({2.0, 1.5, 0.5}).verdict, Convergence::diverging);
  EXPECT_EQ(of_values({2.0, 1.5, 1.0}).verdict, Convergence::diverging);
  EXPECT_EQ(of_values({2.0, 2.0, 1.0}).verdict, Convergence::diverging);
}

TEST(VerdictOnValues, IsFloorLimitedWhereTheFinestDifferByRoundOff) {
  EXPECT_EQ(of_values({2.0, 1.5, 1.5 + 1e-13}).verdict, Convergence::floor_limited);
  EXPECT_EQ(of_values({2.0, 2.0, 2.0}).verdict, Convergence::floor_limited);
}

TEST(VerdictOnValues, IsUndeterminedForTwoLevelsAndForWhatIsNotANumber) {
  EXPECT_EQ(of_values({2.0, 1.5}).verdict, Convergence::undetermined);
  EXPECT_EQ(of_values({2.0, std::nan(""), 1.0}).verdict, Convergence::undetermined);
}

} // namespace
} // namespace settle::compare::test
