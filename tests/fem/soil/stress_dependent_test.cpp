// Elasticity that grows with pressure against closed forms and an independent integration.
#include "soil_paths.hpp"

namespace settle::fem::testing {
namespace {

constexpr double reference = 100e3;

StressDependent fill(double exponent) {
  return {.at_rest = soil_elasticity, .exponent = exponent, .reference_pressure = reference};
}

constexpr double bulk = 20e6 / (3 * 0.4), shear_to_bulk = 3 * 0.4 / (2 * 1.3);
const Symmetric compression = diagonal(-1, -1, -1) / 3;

/// Pressure from none after a compression.
double compressed(double exponent, double strain) {
  if (exponent == 1.0) return reference * std::expm1(bulk / reference * strain);
  return reference * (std::pow(1 + (1 - exponent) * bulk / reference * strain, 1 / (1 - exponent)) - 1);
}

class EveryExponent : public ::testing::TestWithParam<double> {};

TEST_P(EveryExponent, CompressionHasItsClosedFormWhateverTheSteps) {
  for (const int steps : {1, 7, 100}) {
    const double p = pressure(strained(fill(GetParam()), {}, 0.02 * compression, steps).stress);
    EXPECT_NEAR(p, compressed(GetParam(), 0.02), 1e-11 * p) << steps;
  }
}

TEST_P(EveryExponent, AnOedometerHasItsClosedFormWhateverTheSteps) {
  const double p = compressed(GetParam(), 0.02), deviatoric = 2 * shear_to_bulk * p; // 2 G/K dp times e/eps_v
  for (const int steps : {1, 7, 100}) {
    const Symmetric stress = strained(fill(GetParam()), {}, diagonal(0, 0, -0.02), steps).stress;
    EXPECT_NEAR(stress[2][2], -p - deviatoric * 2 / 3, 1e-11 * p) << steps;
    EXPECT_NEAR(stress[0][0], -p + deviatoric / 3, 1e-11 * p) << steps;
  }
}

TEST_P(EveryExponent, IsLinearInTensionAndCrossesNoPressureExactly) {
  const SoilLaw law = fill(GetParam());
  const Symmetric stretched = strained(law, {}, diagonal(0, 0, 0.01)).stress;
  EXPECT_LT((stretched - hooke(soil_elasticity, diagonal(0, 0, 0.01))).norm(), 1e-8);
  const Symmetric across = strained(law, {stretched, {}}, diagonal(0, 0, -0.03)).stress;
  EXPECT_LT((across - strained(law, {}, diagonal(0, 0, -0.02)).stress).norm(), 1e-10 * across.norm());
  EXPECT_LT((strained(law, {across, {}}, diagonal(0, 0, 0.03)).stress - stretched).norm(), 1e-10 * across.norm());
}

TEST_P(EveryExponent, ShearAtConstantVolumeHasTheModulusOfItsPressure) {
  const SoilPoint start{diagonal(-50e3, -50e3, -50e3), {}};
  Symmetric strain;
  strain[0][1] = 1e-3;
  const double modulus = shear_to_bulk * bulk * std::pow(1.5, GetParam());
  EXPECT_NEAR(strained(fill(GetParam()), start, strain).stress[0][1], 2 * modulus * 1e-3, 1e-8 * modulus);
}

TEST_P(EveryExponent, FollowsAnIntegrationOfItsRates) {
  const Symmetric strain = diagonal(-4e-3, 2e-3, -9e-3) + 3e-3 * turned(rotation(1.0), diagonal(1, -1, 0));
  const auto rate = [&](const Symmetric& stress) {
    const double p = std::max(pressure(stress), 0.0);
    return std::pow(1 + p / reference, GetParam()) * hooke(soil_elasticity, strain);
  };
  const Symmetric start = diagonal(20e3, 10e3, 15e3);
  Symmetric integrated = start;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    const Symmetric k1 = rate(integrated), k2 = rate(integrated + k1 / (2.0 * steps)),
                    k3 = rate(integrated + k2 / (2.0 * steps)), k4 = rate(integrated + k3 / (1.0 * steps));
    integrated += (k1 + 2 * k2 + 2 * k3 + k4) / (6.0 * steps);
  }
  EXPECT_LT((strained(fill(GetParam()), {start, {}}, strain).stress - integrated).norm(), 1e-7 * integrated.norm());
}

TEST_P(EveryExponent, HasATangentThatIsTheDerivativeOfItsStress) {
  std::mt19937 random(8);
  const SoilLaw law = fill(GetParam());
  for (const double p : {-30e3, 0.0, 40e3})
    for (const double size : {1e-9, 1e-4, 5e-3})
      for (int i = 0; i < 20; ++i) {
        const SoilPoint start{random_tensor(random, 10e3) - p * dealii::unit_symmetric_tensor<3>(), {}};
        const Symmetric strain = random_tensor(random, size);
        const auto at = respond(law, start, strain);
        for (unsigned k = 0; k < 3; ++k)
          for (unsigned l = k; l < 3; ++l) {
            Symmetric h;
            h[k][l] = 1e-6;
            const Symmetric difference =
                (respond(law, start, strain + h)->point.stress - respond(law, start, strain - h)->point.stress) / 2e-6;
            EXPECT_LT((at->tangent * h / 1e-6 - difference).norm(), 1e-6 * at->tangent.norm())
                << p << ", " << strain << ", " << k << l;
          }
      }
}

INSTANTIATE_TEST_SUITE_P(All, EveryExponent, ::testing::Values(0.0, 0.5, 0.8, 1.0));

TEST(StressDependent, WithoutAnExponentIsHooke) {
  const Symmetric strain = diagonal(-4e-3, 2e-3, -9e-3);
  EXPECT_LT((strained(fill(0.0), {}, strain).stress - hooke(soil_elasticity, strain)).norm(), 1e-8);
}

TEST(StressDependent, HasNoAnswerWhereNoPressureIsLargeEnough) {
  EXPECT_FALSE(respond(SoilLaw(fill(2.0)), {}, 0.02 * compression));
}

} // namespace
} // namespace settle::fem::testing
