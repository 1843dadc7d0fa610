// Closed forms of the laws whose stiffness follows the stress: cam-clay and stress-dependent; and of the elastic one.
#include <cmath>

#include <gtest/gtest.h>

#include "soil/samples.hpp"

namespace settle::mpm::test {
namespace {

constexpr double young = 20e6, poisson = 0.3;

TEST(ElasticPoint, AnOedometerHasTheConstrainedModulus) {
  const Update end = step(sample("elastic"), -1e-3 * Voigt::Unit(2));
  const double modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  EXPECT_NEAR(end.stress[2], -1e-3 * modulus, 1e-12 * modulus);
  EXPECT_NEAR(end.stress[0] / end.stress[2], poisson / (1.0 - poisson), 1e-12);
}

/// d(p)/d(strain) = K0 (1 + p / p_ref)^m from zero stress: (1 + p / p_ref)^(1 - m) = 1 + (1 - m) K0 strain / p_ref.
TEST(StressDependent, AnOedometerFollowsItsClosedFormInAnyNumberOfSteps) {
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson)), shear = young / (2.0 * (1.0 + poisson));
  const double reference = 100e3, strain = 0.02;
  for (const double m : {0.0, 0.3, 0.5, 0.8, 1.0})
    for (const int steps : {1, 7, 1000}) {
      Sample at = sample("stress_dependent");
      at.start.setZero();
      std::get<soil::StressDependent>(at.law).stiffness_exponent = m;
      for (int k = 0; k < steps; ++k)
        advance(at, -strain / steps * Voigt::Unit(2));
      const double growth = bulk * strain / reference;
      const double exact = m == 1.0 ? reference * (std::exp(growth) - 1.0)
                                    : reference * (std::pow(1.0 + (1.0 - m) * growth, 1.0 / (1.0 - m)) - 1.0);
      EXPECT_NEAR(pressure_of(at.start) / exact, 1.0, 1e-8) << m;
      EXPECT_NEAR(-at.start[2] / (exact * (1.0 + 4.0 / 3.0 * shear / bulk)), 1.0, 1e-8) << m;
    }
}

TEST(StressDependent, CompressionTakenBackLeavesNothing) {
  Sample at = sample("stress_dependent");
  at.start.setZero();
  advance(at, -0.01 * Voigt::Unit(2));
  advance(at, 0.01 * Voigt::Unit(2));
  EXPECT_LT(at.start.norm(), 1e-6);
}

TEST(StressDependent, TensionIsElasticWithTheStiffnessWithoutStress) {
  Sample at = sample("stress_dependent");
  at.start.setZero();
  const Voigt strain{1e-3, 2e-3, -5e-4, 1e-3, 0.0, -2e-4};
  const Voigt exact = step(sample("elastic"), strain).stress;
  EXPECT_LT((advance(at, strain).stress - exact).norm(), 1e-12 * exact.norm());
}

TEST(StressDependent, AStepThroughZeroIsTwoSteps) {
  for (const double sign : {-1.0, 1.0}) {
    Sample at = sample("stress_dependent"), parts = at;
    at.start = parts.start = sign * 20e3 * soil::unit();
    const Voigt strain = -sign * Voigt{4e-3, 2e-3, 3e-3, 1e-3, -2e-3, 0.0};
    for (int k = 0; k < 10; ++k)
      advance(parts, 0.1 * strain);
    const Voigt whole = advance(at, strain).stress;
    EXPECT_LT((whole - parts.start).norm(), 1e-10 * whole.norm());
  }
}

const soil::CamClay& clay_of(const Sample& at) {
  return std::get<soil::CamClay>(at.law);
}

TEST(CamClay, CompressionFollowsTheNormalCompressionLine) {
  for (const int steps : {1, 10}) {
    Sample at = sample("cam_clay_normally_consolidated");
    at.start = -100e3 * soil::unit();
    const double strain = 0.05;
    for (int k = 0; k < steps; ++k)
      advance(at, -strain / 3.0 / steps * soil::unit());
    const double exact = 100e3 * std::exp((1.0 + 1.0) / 0.2 * strain); // d(e) = -lambda d(ln p)
    EXPECT_NEAR(pressure_of(at.start) / exact, 1.0, 1e-12);
    EXPECT_NEAR(at.state.preconsolidation_pressure / exact, 1.0, 1e-12);
    EXPECT_NEAR(at.state.plastic_strain, 0.0, 1e-14);
  }
}

TEST(CamClay, SwellingFollowsTheSwellingLineAndBack) {
  Sample at = sample("cam_clay_overconsolidated");
  at.start = -100e3 * soil::unit();
  advance(at, 0.01 / 3.0 * soil::unit());
  EXPECT_NEAR(pressure_of(at.start) / (100e3 * std::exp(-2.0 / 0.04 * 0.01)), 1.0, 1e-12);
  EXPECT_EQ(at.state.preconsolidation_pressure, 100e3);
  advance(at, -0.01 / 3.0 * soil::unit());
  EXPECT_NEAR(pressure_of(at.start) / 100e3, 1.0, 1e-12);
  EXPECT_NEAR(at.state.preconsolidation_pressure / 100e3, 1.0, 1e-12);
}

TEST(CamClay, ShearedDrainedItComesToItsCriticalState) {
  for (const char* name : {"cam_clay_normally_consolidated", "cam_clay_overconsolidated", "cam_clay_with_attraction"}) {
    Sample at = sample(name);
    at.start = -40e3 * soil::unit();
    const double lateral = -40e3;
    for (int k = 0; k < 300; ++k) {
      const Update end = mixed_step(at, {true, true, false, false, false, false}, -5e-3 * Voigt::Unit(2));
      at.start = end.stress, at.state = end.state;
    }
    const double m = clay_of(at).critical_state_slope, p = pressure_of(at.start) + clay_of(at).attraction;
    EXPECT_NEAR(shear_of(at.start) / (m * p), 1.0, 1e-6) << name;
    EXPECT_NEAR(at.state.preconsolidation_pressure / (2.0 * p), 1.0, 1e-6) << name;
    EXPECT_NEAR(at.start[0], lateral, 1e-8 * 40e3);
  }
}

/// p*, q and p_c under undrained triaxial shear.
struct Triaxial {
  double p, q, pc;
};

/// Their rates by the shear strain: the volume is kept, so that elastic and plastic volumetric strain are opposite, and
/// the yield condition is kept.
Triaxial undrained_rate(const soil::CamClay& clay, const Triaxial& at) {
  const double m2 = clay.critical_state_slope * clay.critical_state_slope, g3 = 3.0 * clay.shear_modulus;
  const double k = (1.0 + clay.void_ratio) / clay.swelling_index;
  const double h = (1.0 + clay.void_ratio) / (clay.compression_index - clay.swelling_index);
  const double volume = 2.0 * at.p - at.pc, shear = 2.0 * at.q / m2;
  const double flow = shear * g3 / (shear * g3 * shear + volume * volume * k * at.p + at.p * h * at.pc * volume);
  return {-k * at.p * flow * volume, g3 * (1.0 - flow * shear), h * at.pc * flow * volume};
}

/// By the classical Runge-Kutta method.
Triaxial undrained_exact(const soil::CamClay& clay, Triaxial at, double strain, int steps) {
  const auto moved = [](const Triaxial& t, const Triaxial& rate, double by) {
    return Triaxial{t.p + by * rate.p, t.q + by * rate.q, t.pc + by * rate.pc};
  };
  const double h = strain / steps;
  for (int k = 0; k < steps; ++k) {
    const Triaxial k1 = undrained_rate(clay, at), k2 = undrained_rate(clay, moved(at, k1, 0.5 * h));
    const Triaxial k3 = undrained_rate(clay, moved(at, k2, 0.5 * h)), k4 = undrained_rate(clay, moved(at, k3, h));
    at = moved(moved(moved(moved(at, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0);
  }
  return at;
}

TEST(CamClay, ShearedUndrainedItConvergesToTheSolutionInRatesWithOrderOne) {
  Sample start = sample("cam_clay_normally_consolidated");
  start.start = -100e3 * soil::unit();
  const double strain = 0.02;
  const Triaxial exact = undrained_exact(clay_of(start), {100e3, 0.0, 100e3}, strain, 4000);
  // Without steps it is known too: p = p_0 (M^2 / (M^2 + eta^2))^(1 - kappa / lambda).
  const double eta = exact.q / exact.p / 1.2;
  EXPECT_NEAR(exact.p / (100e3 * std::pow(1.0 + eta * eta, -0.8)), 1.0, 1e-9);
  std::vector<double> errors;
  for (const int steps : {50, 100, 200, 400}) {
    Sample at = start;
    for (int k = 0; k < steps; ++k)
      advance(at, strain / steps * Voigt{0.5, 0.5, -1.0, 0.0, 0.0, 0.0});
    errors.push_back(std::hypot(pressure_of(at.start) - exact.p, shear_of(at.start) - exact.q) / 100e3);
  }
  EXPECT_LT(errors.back(), 1e-2);
  for (std::size_t i = 1; i < errors.size(); ++i) {
    const double order = std::log2(errors[i - 1] / errors[i]);
    EXPECT_GT(order, 0.8) << errors[i];
    EXPECT_LT(order, 1.5) << errors[i];
  }
}

} // namespace
} // namespace settle::mpm::test
