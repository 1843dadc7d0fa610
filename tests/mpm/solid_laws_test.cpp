// The material laws in three dimensions: their response, its derivative, rotations, and plane strain as a special case.

#include <cmath>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blocks.hpp"
#include "constitutive_update.hpp"

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

const Model rate{"rate", exchange::Law::rate, false}, jaumann{"jaumann", exchange::Law::rate, true},
    hencky{"hencky", exchange::Law::hencky, false}, neo_hookean{"neo_hookean", exchange::Law::neo_hookean, false};

/// One square or cube, filled with points of the model.
template <class Space>
Body<Space> one_cell(const Model& model) {
  Body<Space> body = block<Space>({.columns = 1, .deep = 1, .rows = 1, .filled_rows = 1, .supported = false});
  body.law = model.law;
  body.jaumann = model.jaumann;
  body.points = {};
  body.points.tracks_deformation = model.law != exchange::Law::rate;
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = 0.5});
  body.sort();
  return body;
}

template <class Space>
void deform(Body<Space>& body, const Tensor<Space::dim>& gradient, int times = 1) {
  for (int k = 0; k < times; ++k)
    deform_points(body, points_in(body, 0), IncrementalKinematics<Space::dim>(gradient), StrainMeasure::logarithmic);
}

template <class Space>
Stress<Space::dim> stress_in(const Body<Space>& body) {
  return average_stress_of(body.points, points_in(body, 0)).average;
}

Tensor<3> first_gradient() {
  Tensor<3> gradient;
  gradient << -0.02, 0.05, 0.01, -0.03, -0.1, 0.04, 0.02, -0.06, 0.03;
  return gradient;
}
Tensor<3> second_gradient() {
  Tensor<3> gradient;
  gradient << 0.04, -0.1, 0.03, 0.06, -0.08, -0.02, 0.05, 0.01, -0.03;
  return gradient;
}

Tensor<3> turn(double angle) {
  return Eigen::AngleAxisd(angle, Vector<3>(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

class EverySolidLaw : public testing::TestWithParam<Model> {};
INSTANTIATE_TEST_SUITE_P(Laws, EverySolidLaw, testing::Values(rate, jaumann, hencky, neo_hookean),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(EverySolidLaw, TheResponseIsTheStressThatThePointsGet) {
  auto body = one_cell<HexahedronSpace>(GetParam());
  deform(body, first_gradient());
  const auto range = points_in(body, 0);
  const IncrementalKinematics<3> kinematics(second_gradient());
  const auto response = respond(body, range, average_stress_of(body.points, range), kinematics);
  deform_points(body, range, kinematics, StrainMeasure::logarithmic);
  const Tensor<3> after = stress_in(body).tensor;
  EXPECT_LT((response.stress - after).norm(), 1e-12 * after.norm());
}

TEST_P(EverySolidLaw, VariationsAreTheDerivativesOfTheResponse) {
  auto body = one_cell<HexahedronSpace>(GetParam());
  deform(body, first_gradient());
  const auto range = points_in(body, 0);
  const auto start = average_stress_of(body.points, range);
  const Tensor<3> gradient = second_gradient(), deformation = Tensor<3>::Identity() + gradient;
  const auto response = respond(body, range, start, IncrementalKinematics<3>(gradient));
  const double step = 1e-6;
  for (int b = 0; b < 3; ++b)
    for (int a = 0; a < 3; ++a) { // on top of the increment: F becomes (I + s e_b (x) e_a) F
      const Tensor<3> direction = Vector<3>::Unit(b) * Vector<3>::Unit(a).transpose() * deformation;
      const auto stress_at = [&](double s) {
        return respond(body, range, start, IncrementalKinematics<3>(gradient + s * direction)).stress;
      };
      const Tensor<3> difference = (stress_at(step) - stress_at(-step)) / (2.0 * step);
      const Tensor<3>& variation = response.by_gradient[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
      EXPECT_LT((variation - difference).norm(), 1e-7 * difference.norm()) << "component " << b << a;
    }
}

TEST_P(EverySolidLaw, InThePlaneItIsThatOfPlaneStrain) {
  Tensor<2> plane;
  plane << -0.02, 0.05, -0.03, -0.1;
  Tensor<3> solid = Tensor<3>::Zero(); // the plane of y and z
  solid.bottomRightCorner<2, 2>() = plane;
  auto flat = one_cell<QuadrilateralSpace>(GetParam());
  auto cube = one_cell<HexahedronSpace>(GetParam());
  deform(flat, plane, 3);
  deform(cube, solid, 3);
  const Stress<2> expected = stress_in(flat);
  const Tensor<3> found = stress_in(cube).tensor;
  const double scale = expected.tensor.norm();
  EXPECT_LT((found.bottomRightCorner<2, 2>() - expected.tensor).norm(), 1e-12 * scale);
  EXPECT_NEAR(found(0, 0), expected.out_of_plane, 1e-12 * scale);
  EXPECT_NEAR(found(0, 1), 0.0, 1e-12 * scale);
  EXPECT_NEAR(found(0, 2), 0.0, 1e-12 * scale);
}

TEST_P(EverySolidLaw, ARigidRotationOfAStressFreeBodyLeavesItStressFree) {
  auto body = one_cell<HexahedronSpace>(GetParam());
  deform(body, turn(0.8) - Tensor<3>::Identity());
  EXPECT_LT(stress_in(body).tensor.norm(), 1e-9 * body.lame.mu);
}

TEST(SolidObjectivity, StressTurnsWithTheBodyForTheJaumannRateAndHyperelasticLaws) {
  const Tensor<3> whole = turn(1.2);
  for (const Model& model : {jaumann, hencky, neo_hookean}) {
    auto body = one_cell<HexahedronSpace>(model);
    deform(body, first_gradient());
    const Tensor<3> before = stress_in(body).tensor;
    const double volume = total_volume(body.points);
    const int steps = 300; // a rotation by the mid-point rule errs with the square of its angle
    deform(body, turn(1.2 / steps) - Tensor<3>::Identity(), steps);
    EXPECT_LT((stress_in(body).tensor - whole * before * whole.transpose()).norm(), 1e-5 * before.norm()) << model.name;
    EXPECT_NEAR(total_volume(body.points) / volume, 1.0, 1e-12);
  }
}

TEST(SolidObjectivity, ThePlainRateLeavesTheStressBehind) {
  auto body = one_cell<HexahedronSpace>(rate);
  deform(body, first_gradient());
  const Tensor<3> before = stress_in(body).tensor;
  deform(body, turn(1.2 / 300) - Tensor<3>::Identity(), 300);
  EXPECT_LT((stress_in(body).tensor - before).norm(), 1e-9 * before.norm());
}

TEST(SolidDomains, KeepTheirVolumeInARotationAndFollowAStretch) {
  auto body = block<GimpSpace<3>>({.columns = 1, .deep = 1, .rows = 1, .filled_rows = 1, .supported = false});
  const Vector<3> before = body.points.half_lengths_of(0);
  deform(body, turn(0.7) - Tensor<3>::Identity());
  EXPECT_LT((body.points.half_lengths_of(0) - before).norm(), 1e-14);
  deform(body, Vector<3>(0.1, -0.2, 0.3).asDiagonal().toDenseMatrix());
  EXPECT_LT((body.points.half_lengths_of(0) - before.cwiseProduct(Vector<3>(1.1, 0.8, 1.3))).norm(), 1e-14);
}

} // namespace
} // namespace settle::mpm::test
