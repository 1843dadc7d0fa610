// Modified Cam-clay against closed forms and an independent integration.
#include "soil_paths.hpp"

namespace settle::fem::testing {
namespace {

constexpr double e0 = 1.1, lambda = 0.2, kappa = 0.04, slope = 1.2, shear = 3e6;

CamClay clay(double attraction = 0.0) {
  return {.shear_modulus = shear,
          .critical_state_slope = slope,
          .compression_index = lambda,
          .swelling_index = kappa,
          .void_ratio = e0,
          .attraction = attraction};
}

SoilPoint consolidated(double pressure, double preconsolidation) {
  return {diagonal(-pressure, -pressure, -pressure), {.preconsolidation_pressure = preconsolidation}};
}

const Symmetric compression = diagonal(-1, -1, -1) / 3; // volume
const Symmetric shortening = diagonal(0.5, 0.5, -1);    // axial, at constant volume

double yield_function(const SoilPoint& point, double attraction = 0.0) {
  const double p = pressure(point.stress) + attraction, q = shear_stress(point.stress);
  return q * q / (slope * slope) + p * (p - point.variables.preconsolidation_pressure);
}

TEST(CamClay, FollowsItsNormalCompressionLineWhateverTheSteps) {
  for (const int steps : {1, 3, 40}) {
    const auto point = strained(clay(), consolidated(100e3, 100e3), 0.1 * compression, steps);
    const double expected = 100e3 * std::exp((1 + e0) / lambda * 0.1);
    EXPECT_NEAR(pressure(point.stress), expected, 1e-10 * expected);
    EXPECT_NEAR(point.variables.preconsolidation_pressure, expected, 1e-10 * expected);
    EXPECT_LT(shear_stress(point.stress), 1e-10 * expected);
  }
}

TEST(CamClay, SwellsAndIsCompressedAgainAlongItsSwellingLine) {
  const double attraction = 20e3;
  const auto swollen = strained(clay(attraction), consolidated(100e3, 150e3), -0.05 * compression, 3);
  const double expected = 120e3 * std::exp(-(1 + e0) / kappa * 0.05) - attraction;
  EXPECT_NEAR(pressure(swollen.stress), expected, 1e-10 * 120e3);
  EXPECT_NEAR(pressure(strained(clay(attraction), swollen, 0.05 * compression, 4).stress), 100e3, 1e-10 * 120e3);
  EXPECT_EQ(swollen.variables.preconsolidation_pressure, 150e3);
}

/// Undrained, p_c and p are tied by volume alone: p falls or rises to p_0 (R/2)^(1 - kappa/lambda).
TEST(CamClay, ShearedUndrainedEndsInItsCriticalState) {
  for (const double overconsolidation : {1.0, 1.5, 5.0}) {
    const auto point = strained(clay(), consolidated(100e3, 100e3 * overconsolidation), 2.0 * shortening, 50);
    const double expected = 100e3 * std::pow(overconsolidation / 2, 1 - kappa / lambda);
    EXPECT_NEAR(pressure(point.stress), expected, 1e-8 * expected) << overconsolidation;
    EXPECT_NEAR(shear_stress(point.stress), slope * expected, 1e-8 * expected) << overconsolidation;
  }
}

/// p/p_0 = [M^2/(M^2 + eta^2)]^(1 - kappa/lambda) from the tip of the ellipse (Wood 1990, ch. 6).
TEST(CamClay, FollowsItsUndrainedStressPathWhateverTheSteps) {
  for (const int steps : {1, 5, 25}) {
    const auto point = strained(clay(), consolidated(100e3, 100e3), 0.02 * shortening, steps);
    const double ratio = shear_stress(point.stress) / pressure(point.stress);
    EXPECT_GT(ratio, 0.3);
    const double expected = 100e3 * std::pow(slope * slope / (slope * slope + ratio * ratio), 1 - kappa / lambda);
    EXPECT_NEAR(pressure(point.stress), expected, 1e-8 * expected) << steps;
  }
}

TEST(CamClay, DrainedTriaxialCompressionEndsInItsCriticalState) {
  Symmetric strain;
  const auto point = drained(clay(), consolidated(100e3, 120e3), -2.0, 400, strain);
  const double p = 100e3 / (1 - slope / 3);
  EXPECT_NEAR(pressure(point.stress), p, 1e-6 * p);
  EXPECT_NEAR(shear_stress(point.stress), slope * p, 1e-6 * slope * p);
}

/// The rate equations in p, q and p_c of an undrained test, by the classical Runge-Kutta method.
std::array<double, 3> integrated_undrained(double p, double preconsolidation, double axial_strain, int steps) {
  const auto rates = [](const std::array<double, 3>& y) {
    const double pressure = y[0], q = y[1], c = y[2];
    const double by_p = 2 * pressure - c, by_q = 2 * q / (slope * slope);
    const double bulk = (1 + e0) / kappa * pressure, hardening = pressure * (1 + e0) / (lambda - kappa) * c * by_p;
    const double multiplier =
        3 * shear * by_q / (by_p * bulk * by_p + by_q * 3 * shear * by_q + hardening); // for an axial strain of one
    return std::array{-bulk * multiplier * by_p, 3 * shear * (1 - multiplier * by_q),
                      (1 + e0) / (lambda - kappa) * c * multiplier * by_p};
  };
  std::array<double, 3> y{p, 0.0, preconsolidation};
  const double h = axial_strain / steps;
  const auto moved = [](std::array<double, 3> from, const std::array<double, 3>& rate, double by) {
    for (std::size_t i = 0; i < 3; ++i)
      from[i] += by * rate[i];
    return from;
  };
  for (int i = 0; i < steps; ++i) {
    const auto k1 = rates(y), k2 = rates(moved(y, k1, h / 2)), k3 = rates(moved(y, k2, h / 2)),
               k4 = rates(moved(y, k3, h));
    y = moved(moved(moved(moved(y, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
  }
  return y;
}

TEST(CamClay, TendsToTheSolutionOfItsRateEquationsAtFirstOrder) {
  const auto exact = integrated_undrained(100e3, 100e3, 0.02, 20000);
  std::vector<double> p, q;
  for (const int steps : {100, 200, 400}) {
    const auto point = strained(clay(), consolidated(100e3, 100e3), 0.02 * shortening, steps);
    p.push_back(pressure(point.stress));
    q.push_back(shear_stress(point.stress));
  }
  EXPECT_NEAR(std::log2((p[0] - exact[0]) / (p[1] - exact[0])), 1.0, 0.1);
  EXPECT_NEAR(std::log2((p[1] - exact[0]) / (p[2] - exact[0])), 1.0, 0.05);
  // the first two orders taken out
  EXPECT_NEAR((8 * p[2] - 6 * p[1] + p[0]) / 3, exact[0], 1e-6 * exact[0]);
  EXPECT_NEAR((8 * q[2] - 6 * q[1] + q[0]) / 3, exact[1], 1e-6 * exact[1]);
}

TEST(CamClay, ReturnsToItsSurfaceWithTheFlowAndTheHardeningOfItsEnd) {
  std::mt19937 random(3);
  int yielded = 0, softened = 0;
  for (int i = 0; i < 3000; ++i) {
    const double attraction = i % 2 == 0 ? 0.0 : 10e3;
    const CamClay soil = clay(attraction);
    std::uniform_real_distribution<double> overconsolidation(1.2, 12.0);
    SoilPoint start = consolidated(50e3, (50e3 + attraction) * overconsolidation(random));
    start.stress += random_tensor(random, 5e3);
    const Symmetric strain = random_tensor(random, 0.03);
    const auto response = respond(soil, start, strain);
    ASSERT_TRUE(response);
    const SoilPoint& end = response->point;
    const double c0 = start.variables.preconsolidation_pressure, c = end.variables.preconsolidation_pressure;
    const double p0 = pressure(start.stress) + attraction, p = pressure(end.stress) + attraction;
    EXPECT_LE(yield_function(end, attraction), 1e-11 * (c * c + c0 * c0));
    if (end.variables.plastic_strain == 0.0) continue;
    ++yielded;
    softened += c < c0 ? 1 : 0;
    EXPECT_NEAR(yield_function(end, attraction), 0.0, 1e-11 * (c * c + p * p));
    const double elastic = kappa / (1 + e0) * std::log(p / p0),
                 plastic = (lambda - kappa) / (1 + e0) * std::log(c / c0);
    EXPECT_NEAR(elastic + plastic, -trace(strain), 1e-12);
    const Symmetric left = deviator(strain) - deviator(end.stress - start.stress) / (2 * shear);
    // direction of flow: 3 s/M^2 beside 2 p - p_c
    const double multiplier =
        left * deviator(end.stress) / (3 / (slope * slope) * deviator(end.stress) * deviator(end.stress));
    EXPECT_LT((left - multiplier * 3 / (slope * slope) * deviator(end.stress)).norm(), 1e-10);
    EXPECT_NEAR(multiplier * (2 * p - c), plastic, 1e-10);
    EXPECT_NEAR(end.variables.plastic_strain, std::sqrt(2.0 / 3) * left.norm(), 1e-12);
  }
  EXPECT_GT(yielded, 1000);
  EXPECT_GT(softened, 100);
}

TEST(CamClay, HasATangentThatIsTheDerivativeOfItsStress) {
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    SoilPoint start = consolidated(50e3, i % 3 == 0 ? 50e3 : (i % 3 == 1 ? 70e3 : 400e3));
    start.stress += random_tensor(random, 5e3);
    const Symmetric strain = random_tensor(random, 0.01);
    const auto at = respond(clay(5e3), start, strain);
    const auto change = [&](const Symmetric& h, double step) {
      return (respond(clay(5e3), start, strain + step * h)->point.stress -
              respond(clay(5e3), start, strain - step * h)->point.stress) /
             (2 * step);
    };
    for (unsigned k = 0; k < 3; ++k)
      for (unsigned l = k; l < 3; ++l) {
        Symmetric h;
        h[k][l] = 1.0;
        const Symmetric fourth_order = (4.0 * change(h, 1e-6) - change(h, 2e-6)) / 3;
        EXPECT_LT((at->tangent * h - fourth_order).norm(), 1e-6 * at->tangent.norm()) << i << ": " << k << l;
      }
  }
}

TEST(CamClay, SeesNoAxes) {
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    SoilPoint start = consolidated(50e3, 60e3), moved = start;
    start.stress += random_tensor(random, 5e3);
    const Symmetric strain = random_tensor(random, 0.02);
    const Tensor r = rotation(0.3 + i);
    moved.stress = turned(r, start.stress);
    const auto one = respond(clay(), start, strain), other = respond(clay(), moved, turned(r, strain));
    EXPECT_LT((other->point.stress - turned(r, one->point.stress)).norm(), 1e-11 * one->point.stress.norm());
  }
}

TEST(CamClay, HasNoAnswerWithoutPressureOrBeyondNumbers) {
  EXPECT_FALSE(respond(clay(), {}, 0.01 * compression));
  EXPECT_FALSE(respond(clay(), consolidated(100e3, 100e3), 100.0 * compression));
}

} // namespace
} // namespace settle::fem::testing
