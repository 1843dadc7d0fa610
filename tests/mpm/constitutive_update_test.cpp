#include "constitutive_update.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "blocks.hpp"

namespace settle::mpm::test {
namespace {

struct Model {
  const char* name;
  exchange::Law law;
  bool jaumann;
};

std::ostream& operator<<(std::ostream& out, const Model& model) {
  return out << model.name;
}

/// One square with two triangles, filled, with points of the model.
Body<TriangleSpace> one_square(const Model& model) {
  Body<TriangleSpace> body = block({.columns = 1, .rows = 1, .filled_rows = 1, .supported = false});
  Body<TriangleSpace> tracked = body;
  tracked.law = model.law;
  tracked.jaumann = model.jaumann;
  tracked.points = {};
  tracked.points.tracks_deformation = model.law != exchange::Law::rate;
  place_layer(tracked, {.layer = 1, .base = 0.0, .thickness = 0.5});
  tracked.sort();
  return tracked;
}

Tensor<2> tensor(double xx, double xy, double yx, double yy) {
  Tensor<2> t;
  t << xx, xy, yx, yy;
  return t;
}

/// Deforms all points of a cell by the gradients one after another.
void deform(Body<TriangleSpace>& body, int cell, const Tensor<2>& gradient, int times = 1) {
  for (int k = 0; k < times; ++k)
    deform_points(body, points_in(body, cell), IncrementalKinematics<2>(gradient), StrainMeasure::logarithmic);
}

class EveryLaw : public testing::TestWithParam<Model> {};
INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw,
                         testing::Values(Model{"rate", exchange::Law::rate, false},
                                         Model{"jaumann", exchange::Law::rate, true},
                                         Model{"hencky", exchange::Law::hencky, false},
                                         Model{"neo_hookean", exchange::Law::neo_hookean, false}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(EveryLaw, TheResponseIsTheStressThatThePointsGet) {
  Body<TriangleSpace> body = one_square(GetParam());
  deform(body, 0, tensor(-0.02, 0.05, -0.03, -0.1));
  const auto range = points_in(body, 0);
  const auto start = average_stress_of(body.points, range);
  const IncrementalKinematics<2> kinematics(tensor(0.04, -0.1, 0.06, -0.08));
  const auto response = respond(body, range, start, kinematics);
  deform_points(body, range, kinematics, StrainMeasure::logarithmic);
  const Tensor<2> after = average_stress_of(body.points, points_in(body, 0)).average.tensor;
  EXPECT_LT((response.stress - after).norm(), 1e-12 * after.norm());
}

TEST_P(EveryLaw, VariationsAreTheDerivativesOfTheResponse) {
  Body<TriangleSpace> body = one_square(GetParam());
  deform(body, 0, tensor(-0.02, 0.05, -0.03, -0.1));
  const auto range = points_in(body, 0);
  const auto start = average_stress_of(body.points, range);
  const Tensor<2> gradient = tensor(0.04, -0.1, 0.06, -0.08);
  const auto response = respond(body, range, start, IncrementalKinematics<2>(gradient));
  const double step = 1e-6;
  const Tensor<2> deformation = Tensor<2>::Identity() + gradient;
  for (int b = 0; b < 2; ++b)
    for (int a = 0; a < 2; ++a) { // on top of the increment: F becomes (I + s e_b (x) e_a) F
      const Tensor<2> direction = Vector<2>::Unit(b) * Vector<2>::Unit(a).transpose() * deformation;
      const auto stress_at = [&](double s) {
        return respond(body, range, start, IncrementalKinematics<2>(gradient + s * direction)).stress;
      };
      const Tensor<2> difference = (stress_at(step) - stress_at(-step)) / (2.0 * step);
      const Tensor<2>& variation = response.by_gradient[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
      EXPECT_LT((variation - difference).norm(), 1e-7 * difference.norm()) << "component " << b << a;
    }
}

TEST_P(EveryLaw, CompressionToHalfTheHeightHasItsClosedFormToRoundOff) {
  const Model& model = GetParam();
  Body<TriangleSpace> body = one_square(model);
  const int increments = 10;
  const double ratio = std::pow(0.5, 1.0 / increments);
  deform(body, 1, tensor(0.0, 0.0, 0.0, ratio - 1.0), increments);
  const double modulus = body.lame.constrained_modulus(), stretch = 0.5;
  const double lateral = body.lame.lambda * std::log(stretch);
  double exact = modulus * std::log(stretch);
  if (model.law == exchange::Law::hencky) exact /= stretch;
  if (model.law == exchange::Law::neo_hookean) exact = (lateral + body.lame.mu * (stretch * stretch - 1.0)) / stretch;
  const auto p = static_cast<std::size_t>(body.cells.begin[1]);
  EXPECT_NEAR(body.points.stress[1][p] / exact, 1.0, 1e-12);
  EXPECT_NEAR(body.points.stress[0][p] / (model.law == exchange::Law::rate ? lateral : lateral / stretch), 1.0, 1e-12);
  EXPECT_NEAR(body.points.density(p) / body.density, 2.0, 1e-12);
}

TEST_P(EveryLaw, ARigidRotationOfAStressFreeBodyLeavesItStressFree) {
  Body<TriangleSpace> body = one_square(GetParam());
  const double angle = 0.3;
  deform(body, 0, tensor(std::cos(angle) - 1.0, -std::sin(angle), std::sin(angle), std::cos(angle) - 1.0));
  for (const auto& component : body.points.stress)
    EXPECT_NEAR(component[body.cells.begin[0]], 0.0, 1e-9 * body.lame.mu);
}

/// Stress at a point of a cell that is compressed, then turned by a quarter circle in many steps.
Stress<2> compressed_and_turned(const Model& model) {
  Body<TriangleSpace> body = one_square(model);
  deform(body, 0, tensor(0.0, 0.0, 0.0, -0.1));
  const int steps = 200;
  const double angle = 0.5 * M_PI / steps;
  deform(body, 0, tensor(std::cos(angle) - 1.0, -std::sin(angle), std::sin(angle), std::cos(angle) - 1.0), steps);
  return average_stress_of(body.points, points_in(body, 0)).average;
}

TEST(Objectivity, StressTurnsWithTheBodyForTheJaumannRateAndHyperelasticLaws) {
  for (const Model& model : {Model{"jaumann", exchange::Law::rate, true}, Model{"hencky", exchange::Law::hencky, false},
                             Model{"neo_hookean", exchange::Law::neo_hookean, false}}) {
    Body<TriangleSpace> body = one_square(model);
    deform(body, 0, tensor(0.0, 0.0, 0.0, -0.1));
    const Tensor<2> before = average_stress_of(body.points, points_in(body, 0)).average.tensor;
    const Tensor<2> after = compressed_and_turned(model).tensor;
    EXPECT_NEAR(after(0, 0) / before(1, 1), 1.0, 1e-4) << model.name;
    EXPECT_NEAR(after(1, 1) / before(0, 0), 1.0, 1e-4) << model.name;
    EXPECT_NEAR(after(0, 1) / before(1, 1), 0.0, 1e-4) << model.name;
  }
}

TEST(Objectivity, ThePlainRateLeavesTheStressBehind) {
  const Tensor<2> after = compressed_and_turned({"rate", exchange::Law::rate, false}).tensor;
  EXPECT_LT(after(1, 1), 2.0 * after(0, 0)); // still compressed along what was the vertical
}

} // namespace
} // namespace settle::mpm::test
