// Tests of soil laboratories whose results are known: laws of strength.
#include <cmath>

#include <gtest/gtest.h>

#include "soil/samples.hpp"

namespace settle::mpm::test {
namespace {

constexpr double cohesion = 10e3, friction = 30.0 * degree, confinement = 100e3;

/// A cylinder, confined and then compressed along z in equal steps, its sides free to move.
Update triaxial(Sample at, double confining, double axial_strain, int steps) {
  at.start = -confining * soil::unit();
  Update end;
  for (int k = 0; k < steps; ++k) {
    const Voigt change{0.0, 0.0, -axial_strain / steps, 0.0, 0.0, 0.0};
    end = mixed_step(at, {true, true, false, false, false, false}, change);
    at.start = end.stress;
    at.state = end.state;
  }
  return end;
}

TEST(Tresca, InCompressionFailsAtTwiceItsStrength) {
  const Update end = triaxial(sample("tresca"), confinement, 0.02, 10);
  EXPECT_NEAR(end.stress[2], -confinement - 60e3, 1e-8 * 60e3);
  EXPECT_NEAR(end.stress[0], -confinement, 1e-8 * confinement);
}

TEST(Tresca, InSimpleShearFailsAtItsStrength) {
  const Update end = step(sample("tresca"), 0.1 * Voigt::Unit(3));
  EXPECT_NEAR(end.stress[3], 30e3, 1e-8 * 30e3);
  EXPECT_NEAR(end.stress.head<3>().cwiseAbs().maxCoeff(), 0.0, 1e-8 * 30e3);
}

TEST(Tresca, PlasticStrainIsWhatElasticStrainLeaves) {
  const double shear = 0.1, elastic = 30e3 / soil_elasticity().mu;
  const Update end = step(sample("tresca"), shear * Voigt::Unit(3));
  EXPECT_NEAR(end.state.plastic_strain, (shear - elastic) / std::sqrt(3.0), 1e-12);
}

TEST(Tresca, IsNotFeltUnderPressureAlone) {
  const Update end = step(sample("tresca"), -0.1 * soil::unit());
  EXPECT_EQ(end.state.plastic_strain, 0.0);
}

class Friction : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Flows, Friction,
                         testing::Values("mohr_coulomb_associated", "mohr_coulomb_dilatant", "mohr_coulomb_isochoric",
                                         "mohr_coulomb_cut"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(Friction, TheTriaxialStrengthIsThatOfMohrAndCoulomb) {
  const double passive = (1.0 + std::sin(friction)) / (1.0 - std::sin(friction));
  const double exact = -confinement * passive - 2.0 * cohesion * std::sqrt(passive);
  const Update end = triaxial(sample(GetParam()), confinement, 0.05, 20);
  EXPECT_NEAR(end.stress[2], exact, 1e-8 * std::abs(exact));
}

TEST_P(Friction, TheStrengthInExtensionIsTheActiveOne) {
  const double active = (1.0 - std::sin(friction)) / (1.0 + std::sin(friction));
  const double exact = -confinement * active + 2.0 * cohesion * std::sqrt(active);
  const Update end = triaxial(sample(GetParam()), confinement, -0.05, 20);
  EXPECT_NEAR(end.stress[2], exact, 1e-8 * std::abs(exact));
}

TEST(MohrCoulomb, InSimpleShearWithoutDilationThePressureStays) {
  Sample at = sample("mohr_coulomb_isochoric");
  at.start = -confinement * soil::unit();
  const Update end = step(at, 0.1 * Voigt::Unit(3));
  const double exact = cohesion * std::cos(friction) + confinement * std::sin(friction);
  EXPECT_NEAR(end.stress[3], exact, 1e-8 * exact);
  EXPECT_NEAR(end.stress[0], -confinement, 1e-8 * confinement);
}

TEST(MohrCoulomb, TornApartItEndsAtItsApex) {
  for (const char* name : {"mohr_coulomb_associated", "mohr_coulomb_dilatant", "mohr_coulomb_isochoric"}) {
    const Update end = step(sample(name), Voigt{0.02, 0.021, 0.019, 0.001, 0.0, 0.002});
    EXPECT_LT((end.stress - cohesion / std::tan(friction) * soil::unit()).norm(), 1e-8 * cohesion) << name;
  }
}

TEST(MohrCoulomb, InTensionItEndsAtItsTensileStrength) {
  EXPECT_NEAR(triaxial(sample("mohr_coulomb_cut"), 0.0, -0.01, 10).stress[2], 5e3, 1e-8 * 5e3);
  const Update torn = step(sample("mohr_coulomb_cut"), Voigt{0.02, 0.02, 0.02, 0.001, 0.0, 0.0});
  EXPECT_LT((torn.stress - 5e3 * soil::unit()).norm(), 1e-8 * 5e3);
}

/// Oedometer of a soil with friction alone whose elastic ratio of stresses, nu / (1 - nu), is less than the active one:
/// it yields from the start on with sigma_h = K_a sigma_v. Lateral strain is zero: plastic lateral strain takes the
/// elastic one back, and brings (1 - sin psi) / (1 + sin psi) times its double along the axis.
TEST(MohrCoulomb, AnOedometerYieldsAtTheActiveRatio) {
  const double young = 20e6, poisson = 0.2, active = (1.0 - std::sin(friction)) / (1.0 + std::sin(friction));
  for (const double dilation : {0.0, 10.0 * degree, friction}) {
    Sample at{.name = "sand",
              .law = soil::MohrCoulomb{
                  .lame = Lame::from(young, poisson), .friction_angle = friction, .dilation_angle = dilation}};
    const double strain = 0.01;
    for (int k = 0; k < 5; ++k)
      advance(at, -strain / 5 * Voigt::Unit(2));
    const double flow = (1.0 - std::sin(dilation)) / (1.0 + std::sin(dilation));
    const double compliance =
        (1.0 - 2.0 * poisson * active + 2.0 * flow * (active * (1.0 - poisson) - poisson)) / young;
    EXPECT_NEAR(at.start[2], -strain / compliance, 1e-8 * strain / compliance);
    EXPECT_NEAR(at.start[0] / at.start[2], active, 1e-8);
  }
}

TEST(MohrCoulomb, WithoutFrictionItIsTresca) {
  const Sample clay = sample("tresca");
  Sample same = clay;
  same.law = soil::MohrCoulomb{.lame = soil_elasticity(), .cohesion = 30e3};
  std::mt19937 random(1);
  for (int k = 0; k < 1000; ++k) {
    const Voigt strain = random_voigt(random, 1e-2);
    ASSERT_LT((step(clay, strain).stress - step(same, strain).stress).norm(), 1e-10 * 30e3);
  }
}

TEST(DruckerPrager, InSimpleShearWithoutDilationThePressureStays) {
  Sample at = sample("drucker_prager_isochoric");
  at.start = -confinement * soil::unit();
  const Update end = step(at, 0.1 * Voigt::Unit(3));
  const double tangent = std::tan(friction), root = std::sqrt(9.0 + 12.0 * tangent * tangent);
  const double exact = 3.0 * (cohesion + tangent * confinement) / root;
  EXPECT_NEAR(end.stress[3], exact, 1e-8 * exact);
}

TEST(DruckerPrager, TornApartItEndsAtItsApexOrItsTensileStrength) {
  const Voigt strain{0.02, 0.021, 0.019, 0.001, 0.0, 0.002};
  for (const char* name : {"drucker_prager_associated", "drucker_prager_isochoric"}) {
    const Update end = step(sample(name), strain);
    EXPECT_LT((end.stress - cohesion / std::tan(friction) * soil::unit()).norm(), 1e-8 * cohesion) << name;
  }
  EXPECT_LT((step(sample("drucker_prager_cut"), strain).stress - 5e3 * soil::unit()).norm(), 1e-8 * 5e3);
}

/// In plane strain, flowing with its friction, it comes to the strength of Mohr and Coulomb, once the stress across the
/// plane has become that at which no plastic strain goes across.
TEST(DruckerPrager, InPlaneStrainItTendsToTheStrengthOfMohrAndCoulomb) {
  Sample at = sample("drucker_prager_associated");
  at.start = -confinement * soil::unit();
  for (int k = 0; k < 100; ++k) {
    const Update end = mixed_step(at, {true, false, false, false, false, false}, -1e-3 * Voigt::Unit(1));
    at.start = end.stress;
  }
  const double passive = (1.0 + std::sin(friction)) / (1.0 - std::sin(friction));
  const double exact = -confinement * passive - 2.0 * cohesion * std::sqrt(passive);
  EXPECT_NEAR(at.start[1], exact, 1e-8 * std::abs(exact));
}

TEST(DruckerPrager, CornersOfTheCutConeAreReached) {
  const Sample at = sample("drucker_prager_cut");
  const double tangent = std::tan(friction), root = std::sqrt(9.0 + 12.0 * tangent * tangent);
  const auto passed = [&](const Voigt& stress) {
    return shear_of(stress) / std::sqrt(3.0) + 3.0 / root * (tangent * stress.head<3>().mean() - cohesion);
  };
  const Update edge = step(at, Voigt{0.007, -0.0015, -0.003, 0.0, 0.0, 0.0});
  EXPECT_NEAR(edge.stress[0], 5e3, 1e-8 * 5e3);
  EXPECT_LT(edge.stress[1], 4e3);
  EXPECT_NEAR(passed(edge.stress), 0.0, 1e-8 * cohesion);
  const Update corner = step(at, Voigt{0.008, 0.008, -0.010, 0.0, 0.0, 0.0});
  EXPECT_NEAR(corner.stress[0], 5e3, 1e-8 * 5e3);
  EXPECT_NEAR(corner.stress[1], 5e3, 1e-8 * 5e3);
  EXPECT_NEAR(passed(corner.stress), 0.0, 1e-8 * cohesion);
}

} // namespace
} // namespace settle::mpm::test
