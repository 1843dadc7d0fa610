#include "settle/compare/norms.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace settle::compare::test {
namespace {

using exchange::Norm;

LegSamples samples(std::vector<double> value, std::vector<double> reference, std::vector<double> weight) {
  LegSamples leg;
  leg.value = std::move(value);
  leg.reference = std::move(reference);
  leg.weight = std::move(weight);
  return leg;
}

TEST(Norms, RelativeL2IsWeightedByVolume) {
  const LegSamples leg = samples({1.0, 2.0}, {1.0, 1.0}, {3.0, 1.0});
  const RelativeNorm norm = relative_norm(leg, Norm::l2);
  EXPECT_NEAR(norm.value, 0.5, 1e-15); // sqrt(1/4)
  EXPECT_NEAR(norm.scale, 1.0, 1e-15);
}

TEST(Norms, LinfIsTheLargestDifferenceOverTheLargestReference) {
  const RelativeNorm norm = relative_norm(samples({1.0, -7.0}, {1.0, -5.0}, {1.0, 100.0}), Norm::linf);
  EXPECT_NEAR(norm.value, 0.4, 1e-15);
  EXPECT_NEAR(norm.scale, 5.0, 1e-15);
}

TEST(Norms, AGivenScaleReplacesTheReference) {
  const RelativeNorm norm = relative_norm(samples({2.0}, {0.0}, {1.0}), Norm::l2, 4.0);
  EXPECT_NEAR(norm.value, 0.5, 1e-15);
}

TEST(Norms, DoNotDependOnTheUnitOfTheWeights) {
  const double small = relative_norm(samples({1.0, 2.0}, {3.0, 4.0}, {1e-9, 2e-9}), Norm::l2).value;
  const double large = relative_norm(samples({1.0, 2.0}, {3.0, 4.0}, {1e9, 2e9}), Norm::l2).value;
  EXPECT_NEAR(small, large, 1e-14);
}

TEST(Norms, NothingToCompareIsAProblemAndNeverZero) {
  const RelativeNorm norm = relative_norm({}, Norm::linf);
  EXPECT_TRUE(std::isnan(norm.value));
  EXPECT_NE(norm.problem.find("no points"), std::string::npos);
}

TEST(Norms, ANanAnywhereIsAProblem) {
  for (const Norm norm : {Norm::l2, Norm::linf}) {
    EXPECT_FALSE(relative_norm(samples({1.0, NAN}, {1.0, 1.0}, {1.0, 1.0}), norm).problem.empty());
    EXPECT_FALSE(relative_norm(samples({1.0, 1.0}, {NAN, 1.0}, {1.0, 1.0}), norm).problem.empty());
    EXPECT_FALSE(relative_norm(samples({1.0, 1.0}, {1.0, 1.0}, {1.0, NAN}), norm).problem.empty());
    EXPECT_FALSE(relative_norm(samples({HUGE_VAL}, {1.0}, {1.0}), norm).problem.empty());
  }
}

TEST(Norms, APointWithoutVolumeIsAProblem) {
  EXPECT_FALSE(relative_norm(samples({1.0, 1.0}, {1.0, 1.0}, {1.0, -1e-3}), Norm::l2).problem.empty());
}

TEST(Norms, AReferenceThatIsZeroEverywhereNeedsAScale) {
  EXPECT_FALSE(relative_norm(samples({1.0}, {0.0}, {1.0}), Norm::l2).problem.empty());
}

TEST(Norms, TakeTheEuclideanNormOfSeveralComponents) {
  const LegSamples leg = samples({3.0, 4.0, 0.0, 1.0}, {0.0, 0.0, 0.0, 0.0}, {1.0, 3.0}); // |d| = 5 and 1
  EXPECT_NEAR(relative_norm(leg, Norm::linf, 1.0).value, 5.0, 1e-14);
  EXPECT_NEAR(relative_norm(leg, Norm::l2, 1.0).value, std::sqrt((25.0 + 3.0) / 4.0), 1e-14);
}

TEST(Norms, SidesOfDifferentSpacesAreAProblem) {
  EXPECT_NE(relative_norm(samples({1.0, 2.0}, {1.0, 2.0, 3.0}, {1.0}), Norm::l2).problem.find("one side has 2 numbers"),
            std::string::npos);
}

} // namespace
} // namespace settle::compare::test
