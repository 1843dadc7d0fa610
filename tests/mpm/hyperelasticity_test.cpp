#include "settle/mpm/hyperelasticity.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace settle::mpm::test {
namespace {

constexpr double young = 400e3, poisson = 0.25;

/// b of a deformation that stretches and shears.
Tensor<2> some_b() {
  Tensor<2> f;
  f << 1.1, 0.25, -0.1, 0.7;
  return f * f.transpose();
}

/// b of a uniaxial stretch along y.
Tensor<2> uniaxial(double stretch) {
  return Vector<2>(1.0, stretch * stretch).asDiagonal();
}

template <class Law>
class HyperelasticLaw : public testing::Test {
protected:
  Lame lame = Lame::from(young, poisson);
};
using Laws = testing::Types<Hencky<2>, NeoHookean<2>>;
TYPED_TEST_SUITE(HyperelasticLaw, Laws);

TYPED_TEST(HyperelasticLaw, HasNoStressWithoutDeformation) {
  const auto stress = TypeParam(this->lame, Tensor<2>::Identity()).kirchhoff();
  EXPECT_EQ(stress.tensor.norm(), 0.0);
  EXPECT_EQ(stress.out_of_plane, 0.0);
}

TYPED_TEST(HyperelasticLaw, TendsToLinearElasticity) {
  Tensor<2> strain;
  strain << 2e-6, 1e-6, 1e-6, -3e-6;
  const auto stress = TypeParam(this->lame, Tensor<2>::Identity() + 2.0 * strain).kirchhoff();
  const auto linear = stress_increment<2>(this->lame, strain);
  EXPECT_LT((stress.tensor - linear.tensor).norm(), 1e-5 * linear.tensor.norm());
  EXPECT_NEAR(stress.out_of_plane / linear.out_of_plane, 1.0, 2e-5); // tr(e^2) / tr(e) of this strain is 1.5e-5
}

TYPED_TEST(HyperelasticLaw, TurnsItsStressWithTheMaterial) {
  const double angle = 0.7;
  Tensor<2> q;
  q << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Tensor<2> turned = TypeParam(this->lame, q * some_b() * q.transpose()).kirchhoff().tensor;
  const Tensor<2> expected = q * TypeParam(this->lame, some_b()).kirchhoff().tensor * q.transpose();
  EXPECT_LT((turned - expected).norm(), 1e-13 * expected.norm());
}

TYPED_TEST(HyperelasticLaw, VariationIsTheDerivativeOfTheStress) {
  Tensor<2> direction;
  direction << 0.3, -0.8, -0.8, 1.1;
  const double step = 1e-6;
  for (const Tensor<2>& b : {some_b(), Tensor<2>(Tensor<2>::Identity()), uniaxial(0.6)}) {
    const auto ahead = TypeParam(this->lame, b + step * direction).kirchhoff();
    const auto back = TypeParam(this->lame, b - step * direction).kirchhoff();
    const auto variation = TypeParam(this->lame, b).variation(direction);
    const Tensor<2> difference = (ahead.tensor - back.tensor) / (2.0 * step);
    EXPECT_LT((variation.tensor - difference).norm(), 1e-8 * difference.norm());
    EXPECT_NEAR(variation.out_of_plane / ((ahead.out_of_plane - back.out_of_plane) / (2.0 * step)), 1.0, 1e-8);
  }
}

TYPED_TEST(HyperelasticLaw, PlaneStrainIsTheSolidWithoutStretchAcross) {
  Tensor<3> b = Tensor<3>::Identity();
  b.topLeftCorner<2, 2>() = some_b();
  Tensor<3> solid;
  if constexpr (std::is_same_v<TypeParam, Hencky<2>>)
    solid = Hencky<3>(this->lame, b).kirchhoff().tensor;
  else
    solid = NeoHookean<3>(this->lame, b).kirchhoff().tensor;
  const auto plane = TypeParam(this->lame, some_b()).kirchhoff();
  EXPECT_LT((solid.topLeftCorner<2, 2>() - plane.tensor).norm(), 1e-13 * plane.tensor.norm());
  EXPECT_NEAR(solid(2, 2) / plane.out_of_plane, 1.0, 1e-12);
}

TEST(Hencky, InAColumnItsKirchhoffStressIsTheModulusTimesTheLogarithmOfTheStretch) {
  const Lame lame = Lame::from(young, poisson);
  for (const double stretch : {0.5, 0.81, 1.0 + 1e-9, 1.7}) {
    const auto stress = Hencky<2>(lame, uniaxial(stretch)).kirchhoff();
    const double exact = lame.constrained_modulus() * std::log(stretch);
    EXPECT_NEAR(stress.tensor(1, 1), exact, 1e-13 * std::abs(exact) + 1e-9);
    EXPECT_NEAR(stress.tensor(0, 0), poisson / (1.0 - poisson) * exact, 1e-13 * std::abs(exact) + 1e-9);
  }
}

TEST(NeoHookean, InAColumnItFollowsItsClosedForm) {
  const Lame lame = Lame::from(young, poisson);
  for (const double stretch : {0.5, 0.81, 1.7}) {
    const auto stress = NeoHookean<2>(lame, uniaxial(stretch)).kirchhoff();
    const double lateral = lame.lambda * std::log(stretch);
    EXPECT_NEAR(stress.tensor(0, 0) / lateral, 1.0, 1e-13);
    EXPECT_NEAR(stress.tensor(1, 1) / (lateral + lame.mu * (stretch * stretch - 1.0)), 1.0, 1e-13);
  }
}

TEST(Hencky, NearlyEqualPrincipalStretchesChangeNothing) {
  Tensor<2> direction;
  direction << 0.3, -0.8, -0.8, 1.1;
  const auto at = [&](double gap) {
    return Hencky<2>(Lame::from(young, poisson), Vector<2>(0.7, 0.7 + gap).asDiagonal()).variation(direction);
  };
  // On both sides of where the divided difference changes from its series to its logarithm.
  EXPECT_LT((at(0.69e-4).tensor - at(0.71e-4).tensor).norm(), 1e-5 * at(0.0).tensor.norm());
  EXPECT_LT((at(1e-12).tensor - at(0.0).tensor).norm(), 1e-11 * at(0.0).tensor.norm());
}

} // namespace
} // namespace settle::mpm::test
