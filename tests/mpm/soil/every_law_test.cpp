// What holds for every law: tangents, isotropy, yield surfaces, elastic steps.
#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "soil/samples.hpp"

namespace settle::mpm::test {
namespace {

class EverySoil : public testing::TestWithParam<Sample> {};
INSTANTIATE_TEST_SUITE_P(Laws, EverySoil, testing::ValuesIn(samples()),
                         [](const auto& tested) { return tested.param.name; });

/// Relative difference of the tangent and central differences of the stress. Where a difference straddles two regions
/// of the return it says nothing: both one-sided differences then disagree, and the step is passed over (negative).
double tangent_error(const Sample& at, const Voigt& strain) {
  const double h = 1e-5 * at.strain_scale;
  const Update here = step(at, strain, Wanted::tangent);
  Stiffness central;
  double kink = 0.0;
  for (int i = 0; i < 6; ++i) {
    const Voigt dh = h * Voigt::Unit(i);
    const Voigt ahead = step(at, strain + dh).stress, back = step(at, strain - dh).stress;
    central.col(i) = (ahead - back) / (2.0 * h);
    kink = std::max(kink, (ahead - 2.0 * here.stress + back).norm() / h);
  }
  const double scale = soil::elastic_stiffness(soil::bulk_modulus(soil_elasticity()), soil_elasticity().mu).norm();
  if (kink > 1e-3 * scale) return -1.0;
  return (here.tangent - central).norm() / scale;
}

TEST_P(EverySoil, HasTheTangentOfItsStress) {
  std::mt19937 random(1);
  int told = 0, passed_over = 0;
  for (int k = 0; k < 2000; ++k) {
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(-1.5, 1.0)(random));
    const double error = tangent_error(GetParam(), random_voigt(random, size * GetParam().strain_scale));
    if (error < 0.0) {
      ++passed_over;
      continue;
    }
    ++told;
    ASSERT_LT(error, 1e-6) << "step " << k << " of size " << size;
  }
  EXPECT_LT(passed_over, told / 50);
}

TEST_P(EverySoil, HasTheTangentOfItsStressWherePrincipalStressesCoincide) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int k = 0; k < 200; ++k) {
    const double size = 3.0 * number(random) * GetParam().strain_scale;
    Voigt strain = size * Voigt::Unit(k % 3);
    if (k % 2 == 0) strain += 0.3 * number(random) * GetParam().strain_scale * soil::unit();
    const double error = tangent_error(GetParam(), strain);
    if (error >= 0.0) {
      ASSERT_LT(error, 1e-6) << "step " << k;
    }
  }
}

Voigt turned(const Voigt& v, const Eigen::Matrix3d& rotation, double shear) {
  Eigen::Matrix3d t;
  t << v[0], v[3] / shear, v[5] / shear, v[3] / shear, v[1], v[4] / shear, v[5] / shear, v[4] / shear, v[2];
  const Eigen::Matrix3d r = rotation * t * rotation.transpose();
  return {r(0, 0), r(1, 1), r(2, 2), shear * r(0, 1), shear * r(1, 2), shear * r(0, 2)};
}

TEST_P(EverySoil, IsIsotropic) {
  std::mt19937 random(3);
  for (int k = 0; k < 500; ++k) {
    Sample at = GetParam();
    advance(at, random_voigt(random, at.strain_scale));
    const Voigt strain = random_voigt(random, 3.0 * at.strain_scale);
    const Eigen::Matrix3d rotation = Eigen::Quaterniond::UnitRandom().toRotationMatrix();
    const Update straight = step(at, strain);
    Sample other = at;
    other.start = turned(at.start, rotation, 1.0);
    const Update askew = step(other, turned(strain, rotation, 2.0));
    const double scale = straight.stress.norm() + at.start.norm() + 1e3;
    ASSERT_LT((askew.stress - turned(straight.stress, rotation, 1.0)).norm(), 1e-11 * scale);
    ASSERT_NEAR(askew.state.plastic_strain, straight.state.plastic_strain, 1e-11 * at.strain_scale * 10.0);
    ASSERT_NEAR(askew.state.preconsolidation_pressure, straight.state.preconsolidation_pressure, 1e-6);
  }
}

TEST_P(EverySoil, DoesNothingWithoutStrain) {
  std::mt19937 random(4);
  for (int k = 0; k < 200; ++k) {
    Sample at = GetParam();
    advance(at, random_voigt(random, 3.0 * at.strain_scale));
    const Update again = step(at, Voigt::Zero());
    ASSERT_LT((again.stress - at.start).norm(), 1e-11 * (at.start.norm() + 1e3));
    ASSERT_NEAR(again.state.plastic_strain, at.state.plastic_strain, 1e-12);
  }
}

TEST_P(EverySoil, StressTurnedAtTheStartActsAsItsStrain) {
  std::mt19937 random(5);
  for (int k = 0; k < 200; ++k) {
    Sample at = GetParam();
    advance(at, random_voigt(random, 0.5 * at.strain_scale));
    const Voigt strain = random_voigt(random, 2.0 * at.strain_scale);
    if (tangent_error(at, strain) < 0.0) continue;
    const Update here = step(at, strain, Wanted::tangent);
    const Voigt change = 1e-5 * here.shear_modulus * at.strain_scale *
                         soil::deviator(random_voigt(random, 1.0)); // of the stress, so halves of shears
    Sample ahead = at, back = at;
    ahead.start += change;
    back.start -= change;
    const Voigt difference = 0.5 * (step(ahead, strain).stress - step(back, strain).stress);
    Voigt as_strain = change / (2.0 * here.shear_modulus);
    as_strain.tail<3>() *= 2.0;
    ASSERT_LT((here.tangent * as_strain - difference).norm(), 1e-4 * change.norm()) << k;
  }
}

/// Samples that yield, and how far beyond its surface a stress is, relative to its size.
double passed(const Sample& at, const Voigt& stress, const State& state) {
  const Eigen::Vector3d s = sorted_values(stress);
  const double size = s.cwiseAbs().maxCoeff() + 1e3;
  if (const auto* law = std::get_if<soil::Tresca>(&at.law)) return (s[2] - s[0] - 2.0 * law->cohesion) / size;
  if (const auto* law = std::get_if<soil::MohrCoulomb>(&at.law)) {
    const double phi = law->friction_angle;
    double f = (s[2] - s[0]) + (s[2] + s[0]) * std::sin(phi) - 2.0 * law->cohesion * std::cos(phi);
    if (law->tensile_strength) f = std::max(f, s[2] - *law->tensile_strength);
    return f / size;
  }
  if (const auto* law = std::get_if<soil::DruckerPrager>(&at.law)) {
    const double tangent = std::tan(law->friction_angle), root = std::sqrt(9.0 + 12.0 * tangent * tangent);
    double f = shear_of(stress) / std::sqrt(3.0) + 3.0 / root * (tangent * stress.head<3>().mean() - law->cohesion);
    if (law->tensile_strength) f = std::max(f, s[2] - *law->tensile_strength);
    return f / size;
  }
  if (const auto* law = std::get_if<soil::CamClay>(&at.law)) {
    const double q = shear_of(stress) / law->critical_state_slope, p = pressure_of(stress) + law->attraction;
    return (q * q + p * (p - state.preconsolidation_pressure)) / (p * state.preconsolidation_pressure);
  }
  return -1.0;
}

TEST_P(EverySoil, EndsOnItsYieldSurfaceOrStaysElastic) {
  std::mt19937 random(6);
  int plastic = 0;
  const bool yields = !std::holds_alternative<soil::Elastic>(GetParam().law) &&
                      !std::holds_alternative<soil::StressDependent>(GetParam().law);
  for (int k = 0; k < 5000; ++k) {
    Sample at = GetParam();
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(-2.0, 1.5)(random));
    const Update end = advance(at, random_voigt(random, size * at.strain_scale));
    if (end.state.plastic_strain == 0.0 && (!yields || passed(at, end.stress, end.state) < -1e-6)) continue;
    ++plastic;
    ASSERT_NEAR(passed(at, end.stress, end.state), 0.0, 1e-10) << "step " << k << " of size " << size;
  }
  EXPECT_EQ(plastic > 1000, yields) << plastic;
}

TEST_P(EverySoil, AnElasticStepIsTheElasticLawToTheLastBit) {
  const Sample at = GetParam();
  if (std::holds_alternative<soil::CamClay>(at.law) || std::holds_alternative<soil::StressDependent>(at.law)) return;
  std::mt19937 random(7);
  for (int k = 0; k < 500; ++k) {
    const Voigt strain = random_voigt(random, 0.02 * at.strain_scale);
    const Update end = step(at, strain, Wanted::tangent);
    const Update elastic = soil::Elastic{soil_elasticity()}.update(at.start, at.state, strain, Wanted::tangent);
    ASSERT_EQ(end.state.plastic_strain, 0.0);
    ASSERT_EQ(end.stress, elastic.stress);
    ASSERT_EQ(end.tangent, elastic.tangent);
  }
}

} // namespace
} // namespace settle::mpm::test
