// Dynamic relaxation: viscous damping by the lowest frequency.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/viscous_damping.hpp"

namespace settle::mpm::test {
namespace {

/// One node that moves by `displacement`, whose internal force then is `force`.
void make_step(ViscousDamping<2>& damping, double displacement, double force) {
  NodeState<2> node;
  node.mass = 2.0;
  node.internal = {0.0, force};
  node.displacement = {0.0, displacement};
  damping.know_forces({node});
  damping.know_displacements({node});
}

TEST(ViscousDamping, IsNoneBeforeAFrequencyIsKnown) {
  EXPECT_EQ(ViscousDamping<2>(0.75).kept(0.1), 1.0);
  EXPECT_EQ(ViscousDamping<2>(0.75).kick(0.1), 0.1);
}

TEST(ViscousDamping, FrequencyIsTheSquareRootOfStiffnessOverMass) {
  ViscousDamping<2> damping(1.0);
  make_step(damping, 0.01, 5.0);
  EXPECT_EQ(damping.frequency(), 0.0); // a force alone has no stiffness
  make_step(damping, 0.0, 5.0 + 0.01 * 800.0);
  EXPECT_NEAR(damping.frequency(), std::sqrt(800.0 / 2.0), 1e-12);
}

TEST(ViscousDamping, FrequencyFallsFreelyAndRisesOnlyALittleInAStep) {
  ViscousDamping<2> damping(1.0);
  double force = 0;
  const auto stiffness = [&](double k) { make_step(damping, 1.0, force += k); };
  stiffness(0.0);
  stiffness(800.0);
  EXPECT_NEAR(damping.frequency(), 20.0, 1e-12);
  stiffness(80'000.0); // as where a point crosses into the next cell
  EXPECT_NEAR(damping.frequency(), 20.0 * ViscousDamping<2>::largest_rise, 1e-12);
  stiffness(8.0);
  EXPECT_NEAR(damping.frequency(), 2.0, 1e-12);
}

TEST(ViscousDamping, ABodyThatSoftensOrStandsStillLeavesTheFrequencyAsItIs) {
  ViscousDamping<2> damping(1.0);
  make_step(damping, 1.0, 0.0);
  make_step(damping, 1.0, 800.0);
  make_step(damping, 0.0, 700.0);
  EXPECT_NEAR(damping.frequency(), 20.0, 1e-12);
  make_step(damping, 0.0, 900.0);
  EXPECT_NEAR(damping.frequency(), 20.0, 1e-12);
}

TEST(ViscousDamping, VelocitiesFollowTheCentralDifferenceOfDampedMotion) {
  const double zeta = 0.6, omega = 20.0, dt = 0.03;
  ViscousDamping<2> damping(zeta);
  make_step(damping, 1.0, 0.0);
  make_step(damping, 1.0, omega * omega * 2.0);
  const double before = 3.0, acceleration = 7.0;
  const double after = damping.kept(dt) * before + damping.kick(dt) * acceleration;
  // (after - before) / dt + c (after + before) / 2 = acceleration
  EXPECT_NEAR((after - before) / dt + 2.0 * zeta * omega * 0.5 * (after + before), acceleration, 1e-12);
}

/// A column of squares under a weight so small that nothing crosses a cell and strains are linear.
template <class Space>
double frequency_on_the_way_to_rest(int squares, int steps) {
  auto body = block<Space>({.columns = 1, .rows = squares + 1, .filled_rows = squares});
  ExplicitStep<Space> step(body);
  ViscousDamping<2> damping(1.5); // above one only the slowest mode is slow
  const Gravity gravity{.acceleration = 1e-3};
  for (int k = 0; k < steps; ++k) {
    step.scatter(gravity);
    const double dt = step.stable_time_step(0.9);
    damping.know_forces(step.nodes());
    step.accelerate(0.0);
    step.displace(damping.kick(dt), dt, damping.kept(dt));
    damping.know_displacements(step.nodes());
    step.move();
  }
  return damping.frequency();
}

TEST(ViscousDamping, FindsTheLowestFrequencyOfAColumn) {
  // A quarter of a wave over the height: omega = pi c / (2 H). Squares with lumped mass are slower by
  // sin(x) / x with x = pi h / (4 H), 0.1 % for ten. Of the second mode nothing is left after three periods.
  const int squares = 10;
  const Body<QuadrilateralSpace> body = block<QuadrilateralSpace>();
  const double height = squares * body.space.size();
  const double exact = std::numbers::pi / (2.0 * height) * std::sqrt(body.lame.constrained_modulus() / block_density);
  EXPECT_NEAR(frequency_on_the_way_to_rest<QuadrilateralSpace>(squares, 150) / exact, 1.0, 0.005);
  EXPECT_NEAR(frequency_on_the_way_to_rest<TriangleSpace>(squares, 150) / exact, 1.0, 0.005);
}

} // namespace
} // namespace settle::mpm::test
