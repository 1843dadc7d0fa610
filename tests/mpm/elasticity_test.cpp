// Isotropic elasticity against its textbook forms.

#include <gtest/gtest.h>

#include "settle/mpm/elasticity.hpp"

namespace settle::mpm::test {
namespace {

constexpr double young = 400e3, poisson = 0.25;

Tensor<2> some_strain() {
  Tensor<2> strain;
  strain << 1.3e-3, -0.4e-3, -0.4e-3, -2.1e-3;
  return strain;
}

TEST(Elasticity, ConstrainedModulusOfThePapersColumnIs480KilopascalsAndInGeneralFollowsItsFormula) {
  EXPECT_NEAR(Lame::from(young, poisson).constrained_modulus(), 480e3, 1e-6);
  for (const double nu : {-0.3, 0.0, 0.2, 0.45, 0.499}) {
    const double expected = young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
    EXPECT_NEAR(Lame::from(young, nu).constrained_modulus() / expected, 1.0, 1e-12) << "nu = " << nu;
  }
}

TEST(Elasticity, LamesConstantsLeadBackToYoungsModulusAndPoissonsRatio) {
  for (const double nu : {-0.3, 0.0, 0.2, 0.45, 0.499}) {
    const Lame lame = Lame::from(young, nu);
    EXPECT_NEAR(lame.youngs_modulus() / young, 1.0, 1e-12) << "nu = " << nu;
    EXPECT_NEAR(lame.poissons_ratio(), nu, 1e-13);
  }
}

TEST(Elasticity, PlaneStrainStressIsThatOfTheMatrixOfTextbooks) {
  Eigen::Matrix3d d; // xx, yy, engineering shear xy
  d << 1.0 - poisson, poisson, 0.0, poisson, 1.0 - poisson, 0.0, 0.0, 0.0, 0.5 - poisson;
  d *= young / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const Tensor<2> strain = some_strain();
  const Eigen::Vector3d expected = d * Eigen::Vector3d(strain(0, 0), strain(1, 1), 2.0 * strain(0, 1));
  const auto stress = stress_increment<2>(Lame::from(young, poisson), strain);
  EXPECT_NEAR(stress.tensor(0, 0), expected[0], 1e-9);
  EXPECT_NEAR(stress.tensor(1, 1), expected[1], 1e-9);
  EXPECT_NEAR(stress.tensor(0, 1), expected[2], 1e-9);
  EXPECT_EQ(stress.tensor(0, 1), stress.tensor(1, 0));
}

TEST(Elasticity, AcrossThePlaneStressIsPoissonsRatioTimesTheSumInThePlane) {
  const auto stress = stress_increment<2>(Lame::from(young, poisson), some_strain());
  EXPECT_NEAR(stress.out_of_plane, poisson * stress.tensor.trace(), 1e-9);
}

TEST(Elasticity, PlaneStrainIsTheThreeDimensionalLawWithoutStrainAcrossThePlane) {
  Tensor<3> strain = Tensor<3>::Zero();
  strain.topLeftCorner<2, 2>() = some_strain();
  const Lame lame = Lame::from(young, poisson);
  const auto plane = stress_increment<2>(lame, some_strain());
  const auto solid = stress_increment<3>(lame, strain);
  EXPECT_LT((solid.tensor.topLeftCorner<2, 2>() - plane.tensor).norm(), 1e-9);
  EXPECT_NEAR(solid.tensor(2, 2), plane.out_of_plane, 1e-9);
}

} // namespace
} // namespace settle::mpm::test
