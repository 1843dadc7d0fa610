// One explicit step of a linear velocity field that also rotates: what the laws make of the rotation.

#include <cmath>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm::test {
namespace {

/// 3 x 3 squares of points in the middle of a grid of 9 x 9, off its lines.
Body<TriangleSpace> floating_block(exchange::Law law) {
  const auto source = block();
  auto body = block({.columns = 9, .rows = 9, .filled_rows = 1, .supported = false});
  body.law = law;
  body.points = {};
  body.points.tracks_deformation = law != exchange::Law::rate;
  for (std::size_t p = 0; p < source.points.size(); ++p)
    body.points.add({.position = source.points.position_of(p) + Vector<2>(1.53, 1.61),
                     .volume = source.points.volume[p],
                     .density = block_density});
  body.sort();
  return body;
}

/// Every x moves to x + g (x - middle) in the step.
void step(Body<TriangleSpace>& body, const Tensor<2>& g) {
  const Vector<2> middle(2.25, 2.25);
  ExplicitStep<TriangleSpace> phases(body);
  phases.scatter({});
  for (int n = 0; n < body.space.n_nodes(); ++n)
    phases.set_displacement(n, g * (body.space.node_position(n) - middle));
  phases.move();
  phases.gather();
}

Tensor<2> tensor(double xx, double xy, double yx, double yy) {
  Tensor<2> t;
  t << xx, xy, yx, yy;
  return t;
}

TEST(ExplicitLaws, HyperelasticPointsAreDeformedByTheGradientAndNotByItsTranspose) {
  for (const exchange::Law law : {exchange::Law::hencky, exchange::Law::neo_hookean}) {
    auto body = floating_block(law);
    const Tensor<2> first = tensor(0.05, -0.12, 0.03, -0.08), second = tensor(-0.02, 0.1, 0.04, 0.06);
    step(body, first);
    step(body, second);
    const Tensor<2> exact = (Tensor<2>::Identity() + second) * (Tensor<2>::Identity() + first);
    for (std::size_t p = 0; p < body.points.size(); ++p)
      EXPECT_LT((body.points.deformation_of(p) - exact).norm(), 1e-13) << name_of(law);
  }
}

TEST(ExplicitLaws, TheJaumannRateTurnsStressWithARotationOfTheBody) {
  auto body = floating_block(exchange::Law::rate);
  body.jaumann = true;
  const Tensor<2> before = tensor(-1000.0, 200.0, 200.0, -4000.0);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    body.points.stress[0][p] = before(0, 0);
    body.points.stress[1][p] = before(1, 1);
    body.points.stress[3][p] = before(0, 1);
  }
  const double angle = 0.2;
  const Tensor<2> rotation = tensor(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
  step(body, rotation - Tensor<2>::Identity());
  const Tensor<2> after = rotation * before * rotation.transpose();
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    EXPECT_NEAR(body.points.stress[0][p], after(0, 0), 1e-8);
    EXPECT_NEAR(body.points.stress[1][p], after(1, 1), 1e-8);
    EXPECT_NEAR(body.points.stress[3][p], after(0, 1), 1e-8);
  }
}

} // namespace
} // namespace settle::mpm::test
