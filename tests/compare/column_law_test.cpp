#include "settle/compare/column_law.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace settle::compare::test {
namespace {

using exchange::Law;
using exchange::Material;

constexpr double young = 400e3;
constexpr double poisson = 0.25;
constexpr double mu = young / (2.0 * (1.0 + poisson));
constexpr double lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));

Material material(Law law) {
  return {.law = law, .youngs_modulus = young, .poissons_ratio = poisson, .density = 1720.0, .porosity = {}};
}

/// Integral by the classical Runge-Kutta scheme, which for an integrand of its variable alone is Simpson's rule.
double integrate(const std::function<double(double)>& integrand, double end) {
  constexpr int steps = 400;
  const double h = end / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    sum += h / 6.0 * (integrand(i * h) + 4.0 * integrand((i + 0.5) * h) + integrand((i + 1.0) * h));
  }
  return sum;
}

class EveryLaw : public testing::TestWithParam<Law> {};

TEST_P(EveryLaw, StretchBalancesTheOverburden) {
  const ColumnLaw law(material(GetParam()));
  for (const double overburden : {0.0, 1.0, 10e3, 92e3, 500e3, -5e3}) {
    EXPECT_NEAR(law.vertical_stress(law.stretch(overburden)), -overburden, 1e-9 * law.constrained_modulus());
  }
}

TEST_P(EveryLaw, IntegralOfTheStretchAgreesWithSimpsonsRule) {
  const ColumnLaw law(material(GetParam()));
  for (const double overburden : {1e3, 50e3, 92e3, 400e3}) {
    const double expected = integrate([&](double w) { return law.stretch(w); }, overburden);
    EXPECT_NEAR(law.integral(overburden), expected, 1e-9 * expected);
  }
}

TEST_P(EveryLaw, InverseOfTheIntegralIsItsInverse) {
  const ColumnLaw law(material(GetParam()));
  for (const double overburden : {0.0, 1.0, 50e3, 400e3, 2e6}) {
    EXPECT_NEAR(law.inverse_integral(law.integral(overburden)), overburden, 1e-9 * (overburden + 1.0));
  }
}

TEST_P(EveryLaw, SmallOverburdenIsLinearElasticity) {
  const ColumnLaw law(material(GetParam()));
  constexpr double overburden = 1.0;
  EXPECT_NEAR((1.0 - law.stretch(overburden)) * law.constrained_modulus(), overburden, 1e-5);
  EXPECT_NEAR(law.lateral_stress(overburden), -overburden * poisson / (1.0 - poisson), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::Values(Law::rate, Law::hencky, Law::neo_hookean));

TEST(ColumnLaw, NeoHookeanIntegralAgreesWithItsAntiderivative) {
  // Lambda(W) = lambda W - integral of sigma from lambda to 1, which has a closed form.
  const ColumnLaw law(material(Law::neo_hookean));
  constexpr double overburden = 120e3;
  const double x = law.stretch(overburden);
  const double antiderivative = 0.5 * lame * std::pow(std::log(x), 2) + mu * (0.5 * x * x - std::log(x));
  EXPECT_NEAR(law.integral(overburden), x * overburden - (0.5 * mu - antiderivative), 1e-9 * overburden);
}

TEST(ColumnLaw, NeoHookeanStressesFollowFromItsTensor) {
  // sigma = [lame ln J I + mu (b - I)] / J with F = diag(1, x, 1).
  const ColumnLaw law(material(Law::neo_hookean));
  constexpr double x = 0.8;
  const double vertical = (lame * std::log(x) + mu * (x * x - 1.0)) / x;
  EXPECT_NEAR(law.vertical_stress(x), vertical, 1e-9 * young);
  EXPECT_NEAR(law.lateral_stress(-vertical), lame * std::log(x) / x, 1e-8 * young);
}

TEST(ColumnLaw, ConstrainedModulusOfThePaper) {
  EXPECT_NEAR(ColumnLaw(material(Law::rate)).constrained_modulus(), 480e3, 1e-9 * 480e3);
}

} // namespace
} // namespace settle::compare::test
