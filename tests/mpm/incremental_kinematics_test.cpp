// Strain of an increment, its variation, its volume.

#include <cmath>

#include <gtest/gtest.h>

#include "incremental_kinematics.hpp"

namespace settle::mpm::test {
namespace {

using Kinematics = IncrementalKinematics<2>;

Tensor<2> stretch_along_y(double stretch) {
  Tensor<2> gradient = Tensor<2>::Zero();
  gradient(1, 1) = stretch - 1.0;
  return gradient;
}

/// Gradient of the displacement of a rotation.
Tensor<2> rotation(double angle) {
  Tensor<2> gradient;
  gradient << std::cos(angle) - 1.0, -std::sin(angle), std::sin(angle), std::cos(angle) - 1.0;
  return gradient;
}

Tensor<2> some_gradient() {
  Tensor<2> gradient;
  gradient << 0.11, -0.07, 0.16, -0.23;
  return gradient;
}

TEST(IncrementalKinematics, UniaxialStrainIsTheLogarithmicOneToThirdOrder) {
  // 2 artanh(x) = ln[(1 + x)/(1 - x)] with x = (stretch - 1)/(stretch + 1): the first term left out is 2 x^3 / 3.
  double previous = 0;
  for (const double elongation : {-0.2, -0.1, -0.05, -0.025}) {
    const double stretch = 1.0 + elongation;
    const double error = Kinematics(stretch_along_y(stretch)).strain(1, 1) - std::log(stretch);
    EXPECT_NEAR(error / (-std::pow(elongation, 3) / 12.0), 1.0, 2.0 * std::abs(elongation));
    if (previous != 0) {
      EXPECT_NEAR(std::log2(previous / error), 3.0, 0.25);
    }
    previous = error;
  }
}

TEST(IncrementalKinematics, ManySmallIncrementsAddUpToTheLogarithmOfTheStretchAtSecondOrder) {
  const auto error_with = [](int increments) {
    const double stretch = std::pow(0.8, 1.0 / increments);
    return std::abs(increments * Kinematics(stretch_along_y(stretch)).strain(1, 1) - std::log(0.8));
  };
  EXPECT_NEAR(std::log2(error_with(5) / error_with(10)), 2.0, 0.05);
  EXPECT_LT(error_with(20), 3e-6);
}

TEST(IncrementalKinematics, ARigidRotationOfAnyAngleBelowAHalfTurnGivesNoStrainAndNoChangeOfVolume) {
  for (const double angle : {1e-3, 0.1, 1.0, 2.5}) {
    const Kinematics kinematics(rotation(angle));
    EXPECT_LT(kinematics.strain.norm(), 1e-14) << "angle " << angle;
    EXPECT_NEAR(kinematics.volume_ratio, 1.0, 1e-14);
  }
}

TEST(IncrementalKinematics, VolumeRatioIsThatOfTheParallelogramOfTheDeformedAxes) {
  const Tensor<2> f = Tensor<2>::Identity() + some_gradient();
  const double area = f(0, 0) * f(1, 1) - f(1, 0) * f(0, 1);
  EXPECT_NEAR(Kinematics(some_gradient()).volume_ratio, area, 1e-15);
}

TEST(IncrementalKinematics, InverseUndoesTheDeformation) {
  const Tensor<2> f = Tensor<2>::Identity() + some_gradient();
  EXPECT_LT((Kinematics(some_gradient()).inverse * f - Tensor<2>::Identity()).norm(), 1e-14);
}

TEST(IncrementalKinematics, SpinVariationIsTheDerivativeOfTheSpin) {
  const Vector<2> g(1.7, -0.6);
  const double step = 1e-5;
  for (int b = 0; b < 2; ++b) {
    const Tensor<2> direction = Vector<2>::Unit(b) * g.transpose();
    const Tensor<2> difference =
        (Kinematics(some_gradient() + step * direction).spin - Kinematics(some_gradient() - step * direction).spin) /
        (2.0 * step);
    const Tensor<2> variation = Kinematics(some_gradient()).spin_variation(g, b);
    EXPECT_LT((variation - difference).norm(), 1e-8 * variation.norm()) << "direction " << b;
  }
}

TEST(IncrementalKinematics, TheRotationIsOrthogonalAndTurnsWithTheMaterial) {
  const double angle = 0.02;
  Tensor<2> turned;
  turned << std::cos(angle) - 1.0, -std::sin(angle), std::sin(angle), std::cos(angle) - 1.0;
  const Tensor<2> rotation = Kinematics(turned).rotation();
  EXPECT_LT((rotation * rotation.transpose() - Tensor<2>::Identity()).norm(), 1e-14);
  EXPECT_NEAR(rotation(1, 0), std::sin(angle), 1e-6); // third order in the angle: angle^3 / 12
}

} // namespace
} // namespace settle::mpm::test
