// Tresca, Mohr-Coulomb and Drucker-Prager against closed forms, and against what defines a return.
#include <algorithm>
#include <array>

#include "soil_paths.hpp"

namespace settle::fem::testing {
namespace {

constexpr double young = 20e6, nu = 0.3;
constexpr double bulk = young / (3 * (1 - 2 * nu)), shear = young / (2 * (1 + nu));
constexpr double lame = bulk - 2 * shear / 3, oedometric = bulk + 4 * shear / 3;
constexpr double undrained = 25e3, cohesion = 10e3, phi = 20 * degree, psi = 5 * degree;

SoilLaw clay() {
  return tresca(soil_elasticity, undrained);
}
SoilLaw planes(double dilation, std::optional<double> tension = {}) {
  return mohr_coulomb(soil_elasticity, {cohesion, phi, dilation, tension});
}
SoilLaw cone(double dilation, std::optional<double> tension = {}) {
  return Cone(soil_elasticity, {cohesion, phi, dilation, tension});
}

SoilPoint under(double pressure) {
  return {diagonal(-pressure, -pressure, -pressure), {}};
}

/// eta and xi of the cone.
double eta(double angle) {
  return 3 * std::tan(angle) / std::sqrt(9 + 12 * std::pow(std::tan(angle), 2));
}
double xi() {
  return 3 / std::sqrt(9 + 12 * std::pow(std::tan(phi), 2));
}

/// In descending order, to round-off also where they coincide.
std::array<double, 3> principal(const Symmetric& stress) {
  const auto pairs = eigenvectors(stress, dealii::SymmetricTensorEigenvectorMethod::jacobi);
  return {pairs[0].first, pairs[1].first, pairs[2].first};
}

double tresca_function(const Symmetric& stress) {
  const auto s = principal(stress);
  return s[0] - s[2] - 2 * undrained;
}
double mohr_coulomb_function(const Symmetric& stress) {
  const auto s = principal(stress);
  return s[0] - s[2] + (s[0] + s[2]) * std::sin(phi) - 2 * cohesion * std::cos(phi);
}
double drucker_prager_function(const Symmetric& stress) {
  return deviator(stress).norm() / std::sqrt(2.0) + eta(phi) * trace(stress) / 3 - xi() * cohesion;
}

void expect_stress(const Symmetric& stress, const Symmetric& expected) {
  EXPECT_LT((stress - expected).norm(), 1e-8 * expected.norm()) << stress << " instead of " << expected;
}

Symmetric sheared(double angle) {
  Symmetric strain;
  strain[0][1] = angle / 2;
  return strain;
}

TEST(Tresca, CarriesTwiceItsStrengthInUndrainedTriaxialCompression) {
  const double axial = 0.01;
  const auto point = strained(clay(), under(100e3), axial * diagonal(0.5, 0.5, -1), 7);
  expect_stress(point.stress, diagonal(-100e3 + 50e3 / 3, -100e3 + 50e3 / 3, -100e3 - 100e3 / 3));
  EXPECT_NEAR(point.variables.plastic_strain, axial - 50e3 / (3 * shear), 1e-8 * axial);
}

TEST(Tresca, ShearsElasticallyUpToItsStrengthAndNoFurther) {
  const double yield = undrained / shear;
  EXPECT_NEAR(strained(clay(), {}, sheared(0.9 * yield)).stress[0][1], 0.9 * undrained, 1e-8 * undrained);
  const auto point = strained(clay(), {}, sheared(5 * yield), 3);
  expect_stress(point.stress, undrained * shear / shear * sheared(2));
  EXPECT_NEAR(point.variables.plastic_strain, 4 * yield / std::sqrt(3.0), 1e-8 * yield);
}

TEST(Tresca, InAnOedometerKeepsTheBulkModulusOnceItYields) {
  const double strain = 0.02, yield = undrained / shear; // where (M - lambda) eps = 2 c
  const auto point = strained(clay(), {}, diagonal(0, 0, -strain), 11);
  const double axial = -oedometric * yield - bulk * (strain - yield);
  expect_stress(point.stress, diagonal(axial + 2 * undrained, axial + 2 * undrained, axial));
}

TEST(Tresca, InADrainedTriaxialTestFailsAtTwiceItsStrengthWithoutChangeOfVolume) {
  Symmetric strain;
  const auto before = drained(clay(), under(100e3), -0.004, 2, strain);
  expect_stress(before.stress, diagonal(-100e3, -100e3, -150e3));
  const double volume = trace(strain);
  expect_stress(drained(clay(), before, -0.01, 3, strain).stress, before.stress);
  EXPECT_NEAR(trace(strain), volume, 1e-10);
}

/// At the edge lateral stress follows the axial one by K_a, and elastic and plastic lateral strain cancel.
TEST(MohrCoulomb, InAnOedometerMovesAlongTheEdgeOfItsSurface) {
  const double pressure = 5e3, strain = 0.03, ka = (1 - std::sin(phi)) / (1 + std::sin(phi));
  const double yield =
      (2 * cohesion * std::cos(phi) + 2 * pressure * std::sin(phi)) / (2 * shear - (oedometric + lame) * std::sin(phi));
  ASSERT_LT(yield, strain);
  const double multiplier = (nu - (1 - nu) * ka) / (young * (1 + std::sin(psi))); // for an axial stress of one
  const double modulus = 1 / ((1 - 2 * nu * ka) / young - 2 * multiplier * (1 - std::sin(psi)));
  const double axial = -pressure - oedometric * yield - modulus * (strain - yield);
  const double lateral = -pressure - lame * yield - ka * modulus * (strain - yield);
  const auto point = strained(planes(psi), under(pressure), diagonal(0, 0, -strain), 4);
  expect_stress(point.stress, diagonal(lateral, lateral, axial));
  EXPECT_NEAR(point.variables.plastic_strain, -multiplier * modulus * (strain - yield) * 2 * (1 - std::sin(psi) / 3),
              1e-8 * strain);
}

TEST(MohrCoulomb, InADrainedTriaxialTestHasItsPeakAndDilatesByItsAngle) {
  Symmetric strain, later;
  const auto point = drained(planes(psi), under(50e3), -0.02, 4, strain);
  const double root = std::sqrt((1 + std::sin(phi)) / (1 - std::sin(phi)));
  expect_stress(point.stress, diagonal(-50e3, -50e3, -(50e3 * root * root + 2 * cohesion * root)));
  expect_stress(drained(planes(psi), point, -0.01, 2, later).stress, point.stress);
  EXPECT_NEAR(later[0][0], 0.01 * (1 + std::sin(psi)) / (2 * (1 - std::sin(psi))), 1e-10);
}

TEST(MohrCoulomb, WithoutDilationKeepsItsMeanStressInUndrainedTriaxialCompression) {
  const double p = 80e3, s = std::sin(phi);
  const double q = (2 * cohesion * std::cos(phi) + 2 * p * s) / (1 - s / 3);
  expect_stress(strained(planes(0), under(p), 0.02 * diagonal(0.5, 0.5, -1), 5).stress,
                diagonal(-p + q / 3, -p + q / 3, -p - 2 * q / 3));
}

TEST(MohrCoulomb, WithoutDilationCarriesCCosPhiAndPSinPhiInSimpleShear) {
  const auto point = strained(planes(0), under(80e3), sheared(0.02), 5);
  expect_stress(point.stress, under(80e3).stress + sheared(2 * (cohesion * std::cos(phi) + 80e3 * std::sin(phi))));
}

TEST(MohrCoulomb, WithoutDilationIsPulledToItsApex) {
  const double apex = cohesion / std::tan(phi);
  expect_stress(strained(planes(0), {}, diagonal(0.01, 0.012, 0.009)).stress, diagonal(apex, apex, apex));
}

TEST(DruckerPrager, InADrainedTriaxialTestHasItsPeakAndDilatesByItsAngle) {
  Symmetric strain, later;
  const auto point = drained(cone(psi), under(50e3), -0.02, 4, strain);
  const double q = (xi() * cohesion + eta(phi) * 50e3) / (1 / std::sqrt(3.0) - eta(phi) / 3);
  expect_stress(point.stress, diagonal(-50e3, -50e3, -50e3 - q));
  expect_stress(drained(cone(psi), point, -0.01, 2, later).stress, point.stress);
  const double lateral = 1 / (2 * std::sqrt(3.0)) + eta(psi) / 3, axial = -1 / std::sqrt(3.0) + eta(psi) / 3;
  EXPECT_NEAR(later[0][0], -0.01 * lateral / axial, 1e-10);
}

TEST(DruckerPrager, WithoutDilationCarriesXiCAndEtaPInSimpleShear) {
  expect_stress(strained(cone(0), under(80e3), sheared(0.02), 5).stress,
                under(80e3).stress + sheared(2 * (xi() * cohesion + eta(phi) * 80e3)));
}

TEST(DruckerPrager, WithoutDilationKeepsItsMeanStressInUndrainedTriaxialCompression) {
  const double p = 80e3, q = std::sqrt(3.0) * (xi() * cohesion + eta(phi) * p);
  expect_stress(strained(cone(0), under(p), 0.02 * diagonal(0.5, 0.5, -1), 5).stress,
                diagonal(-p + q / 3, -p + q / 3, -p - 2 * q / 3));
}

TEST(DruckerPrager, IsMohrCoulombWherePlaneStrainFailsWithAssociatedFlow) {
  SoilPoint point = under(50e3);
  for (int step = 0; step < 100; ++step)
    point = follow(cone(phi), point, {.stress_given = {true}, .values = {-50e3, -2e-3, 0.0, 0.0, 0.0, 0.0}})->point;
  EXPECT_NEAR(mohr_coulomb_function(point.stress), 0.0, 1e-8 * point.stress.norm());
}

TEST(DruckerPrager, WithoutFrictionIsMises) {
  const SoilLaw mises = Cone(soil_elasticity, {cohesion, 0.0, 0.0, {}});
  expect_stress(strained(mises, under(80e3), sheared(0.02), 5).stress, under(80e3).stress + sheared(2 * cohesion));
}

struct Soil {
  const char* name;
  SoilLaw law; ///< associated
  std::function<double(const Symmetric&)> function;
  double tension; ///< [Pa]
};

std::vector<Soil> associated_soils() {
  constexpr double none = 1e12;
  return {{"tresca", clay(), tresca_function, none},
          {"mohr-coulomb", planes(phi), mohr_coulomb_function, none},
          {"mohr-coulomb, cut off", planes(phi, 4e3), mohr_coulomb_function, 4e3},
          {"mohr-coulomb, no tension", planes(phi, 0.0), mohr_coulomb_function, 0.0},
          {"drucker-prager", cone(phi), drucker_prager_function, none},
          {"drucker-prager, cut off", cone(phi, 4e3), drucker_prager_function, 4e3},
          {"drucker-prager, no tension", cone(phi, 0.0), drucker_prager_function, 0.0}};
}

/// Trial stresses everywhere around the surfaces.
Symmetric random_trial(std::mt19937& random) {
  std::uniform_real_distribution<double> mean(-150e3, 100e3);
  return random_tensor(random, 60e3) + mean(random) * dealii::unit_symmetric_tensor<3>();
}

/// How far a stress is beyond the yield surface [Pa].
double beyond(const Soil& soil, const Symmetric& stress) {
  return std::max(soil.function(stress), principal(stress)[0] - soil.tension);
}

TEST(PerfectPlasticity, ReturnsToTheSurfaceFromAnyTrialStress) {
  for (const Soil& soil : associated_soils()) {
    std::mt19937 random(11);
    int yielded = 0;
    for (int i = 0; i < 5000; ++i) {
      const Symmetric trial = random_trial(random), strain = elastic_strain(soil_elasticity, trial);
      const auto response = respond(soil.law, {}, strain);
      ASSERT_TRUE(response) << soil.name << " from " << trial;
      if (beyond(soil, trial) <= 0) {
        EXPECT_LT((response->point.stress - trial).norm(), 1e-12 * trial.norm()) << soil.name;
        continue;
      }
      ++yielded;
      EXPECT_NEAR(beyond(soil, response->point.stress), 0.0, 1e-11 * trial.norm()) << soil.name << " from " << trial;
    }
    EXPECT_GT(yielded, 1000) << soil.name;
  }
}

/// An associated return is the nearest admissible stress in the elastic norm, and no other stress is: plastic strain
/// does at least as much work on it as on any other admissible stress.
TEST(PerfectPlasticity, WithAssociatedFlowReturnsToTheNearestStress) {
  for (const Soil& soil : associated_soils()) {
    std::mt19937 random(12);
    std::vector<Symmetric> others;
    while (others.size() < 300)
      if (const Symmetric stress = random_trial(random); beyond(soil, stress) <= 0) others.push_back(stress);
    for (int i = 0; i < 500; ++i) {
      const Symmetric trial = random_trial(random);
      const Symmetric returned = respond(soil.law, {}, elastic_strain(soil_elasticity, trial))->point.stress;
      const Symmetric plastic = elastic_strain(soil_elasticity, trial - returned);
      const double work_of_round_off = 1e-12 * elastic_strain(soil_elasticity, trial).norm() * (trial.norm() + 300e3);
      for (const Symmetric& other : others)
        ASSERT_LE(plastic * (other - returned), work_of_round_off)
            << soil.name << " from " << trial << " to " << returned << " but " << other;
    }
  }
}

TEST(PerfectPlasticity, SeesNoAxes) {
  std::vector<SoilLaw> laws{planes(psi, 4e3), cone(psi, 4e3)};
  for (const Soil& soil : associated_soils())
    laws.push_back(soil.law);
  std::mt19937 random(13);
  for (const SoilLaw& law : laws)
    for (int i = 0; i < 200; ++i) {
      const SoilPoint start{random_tensor(random, 5e3) - 20e3 * dealii::unit_symmetric_tensor<3>(), {}};
      const Symmetric strain = elastic_strain(soil_elasticity, random_trial(random));
      const Tensor r = rotation(0.1 + i);
      const auto response = respond(law, start, strain),
                 moved = respond(law, {turned(r, start.stress), {}}, turned(r, strain));
      EXPECT_LT((moved->point.stress - turned(r, response->point.stress)).norm(),
                1e-11 * (20e3 + young * strain.norm()));
      EXPECT_NEAR(moved->point.variables.plastic_strain, response->point.variables.plastic_strain, 1e-12);
    }
}

} // namespace
} // namespace settle::fem::testing
