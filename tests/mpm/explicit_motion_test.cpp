// Whole explicit steps of bodies whose motion is known exactly, and the step's length.

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <gmock/gmock.h>

#include "blocks.hpp"
#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm::test {
namespace {

/// A block of 3 x 3 squares in the middle of a grid of 9 x 9, off the grid's lines, touching nothing.
Body<TriangleSpace> floating_block() {
  const auto source = block();
  Body<TriangleSpace> body = block({.columns = 9, .rows = 9, .filled_rows = 1, .supported = false});
  body.points = {};
  for (std::size_t p = 0; p < source.points.size(); ++p)
    body.points.add({.position = source.points.position_of(p) + Vector<2>(1.53, 1.61),
                     .volume = source.points.volume[p],
                     .density = block_density});
  body.sort();
  return body;
}

void set_velocity(Body<TriangleSpace>& body, const Vector<2>& velocity) {
  for (std::size_t d = 0; d < 2; ++d)
    std::fill(body.points.velocity[d].begin(), body.points.velocity[d].end(), velocity[static_cast<int>(d)]);
}

StepEnergy advance(Body<TriangleSpace>& body, const Gravity& gravity, double dt, double damping = 0.0) {
  ExplicitStep<TriangleSpace> step(body);
  step.scatter(gravity);
  step.accelerate(damping);
  const StepEnergy energy = step.displace(dt, dt);
  step.move();
  step.gather();
  return energy;
}

/// Of a body as it is.
double stable_time_step(Body<TriangleSpace>& body, double courant) {
  ExplicitStep<TriangleSpace> step(body);
  step.scatter({});
  return step.stable_time_step(courant);
}

double largest_stress(const Points<2>& points) {
  double largest = 0;
  for (const auto& component : points.stress)
    for (const double value : component)
      largest = std::max(largest, std::abs(value));
  return largest;
}

/// Stress that round-off alone may leave: that of a strain of 1e-12.
const double round_off_stress = 1e-12 * Lame::from(400e3, 0.25).constrained_modulus();

TEST(ExplicitMotion, RigidTranslationAcrossCellsKeepsItsVelocityAndGivesNoStrainAndNoStress) {
  auto body = floating_block();
  const auto volume = body.points.volume;
  const Vector<2> velocity(1.7, -1.1);
  set_velocity(body, velocity);
  const double dt = 0.01;
  const int steps = 60;
  for (int k = 0; k < steps; ++k)
    advance(body, {.acceleration = 0.0}, dt);
  EXPECT_LT(largest_stress(body.points), round_off_stress);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const Vector<2> moved = body.points.position_of(p) - Vector<2>(body.points.placed[0][p], body.points.placed[1][p]);
    EXPECT_LT((moved - steps * dt * velocity).norm(), 1e-12);
    EXPECT_NEAR(body.points.velocity[0][p], velocity[0], 1e-12);
    EXPECT_NEAR(body.points.velocity[1][p], velocity[1], 1e-12);
    EXPECT_NEAR(body.points.density(p) / block_density, 1.0, 1e-12);
  }
}

TEST(ExplicitMotion, FreeFallGainsGravityTimesTimeAndNoStress) {
  auto body = floating_block();
  const double dt = 0.005, g = 9.81;
  const int steps = 80;
  for (int k = 0; k < steps; ++k)
    advance(body, {.acceleration = g}, dt);
  EXPECT_LT(largest_stress(body.points), round_off_stress);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    EXPECT_NEAR(body.points.velocity[1][p], -g * steps * dt, 1e-12);
    // velocity first, position with the new velocity: g dt^2 (1 + 2 + ... + n)
    EXPECT_NEAR(body.points.position[1][p] - body.points.placed[1][p], -g * dt * dt * steps * (steps + 1) / 2, 1e-12);
  }
}

TEST(ExplicitMotion, DampedFallFromRestIsFreeForOneStepAndThenFeelsOnlyTheRestOfGravity) {
  auto body = floating_block();
  const double dt = 0.005, g = 9.81;
  const int steps = 20;
  for (int k = 0; k < steps; ++k)
    advance(body, {.acceleration = g}, dt, 0.75);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    EXPECT_NEAR(body.points.velocity[1][p], -g * dt * (1.0 + 0.25 * (steps - 1)), 1e-12);
}

TEST(ExplicitMotion, EnergyOfAFallIsHalfTheMassTimesVelocitySquaredAndItsWorkIsWeightTimesDrop) {
  auto body = floating_block();
  const double dt = 0.005, g = 9.81, mass = total_mass(body.points);
  const auto first = advance(body, {.acceleration = g}, dt);
  EXPECT_NEAR(first.kinetic / (0.5 * mass * g * g * dt * dt), 1.0, 1e-12);
  EXPECT_NEAR(first.external_work / (mass * g * g * dt * dt), 1.0, 1e-12);
}

TEST(ExplicitMotion, ALinearVelocityFieldMovesStrainsAndDilatesEveryPointExactly) {
  auto body = floating_block();
  const auto before = body.points;
  Tensor<2> g; // velocity gradient times the step
  g << 0.05, -0.02, 0.03, -0.08;
  ExplicitStep<TriangleSpace> step(body);
  step.scatter({});
  for (int n = 0; n < body.space.n_nodes(); ++n)
    step.set_displacement(n, g * body.space.node_position(n));
  step.move();
  step.gather();

  const double lambda = 160e3, mu = 160e3; // of E = 400 kPa, nu = 1/4
  const double area_ratio = 1.05 * 0.92 + 0.02 * 0.03;
  const Tensor<2> half_way = g * (Tensor<2>::Identity() + 0.5 * g).inverse(); // gradient at the middle of the step
  const double volumetric = lambda * half_way.trace();
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const auto q =
        static_cast<std::size_t>(std::find(before.id.begin(), before.id.end(), body.points.id[p]) - before.id.begin());
    const Vector<2> x = before.position_of(q);
    EXPECT_LT((body.points.position_of(p) - x - g * x).norm(), 1e-13);
    EXPECT_NEAR(body.points.volume[p] / before.volume[q], area_ratio, 1e-13);
    EXPECT_NEAR(body.points.stress[0][p], volumetric + 2.0 * mu * half_way(0, 0), 1e-8);
    EXPECT_NEAR(body.points.stress[1][p], volumetric + 2.0 * mu * half_way(1, 1), 1e-8);
    EXPECT_NEAR(body.points.stress[2][p], volumetric, 1e-8);
    EXPECT_NEAR(body.points.stress[3][p], mu * (half_way(0, 1) + half_way(1, 0)), 1e-8);
  }
}

TEST(ExplicitMotion, OnlyTheLayerUnderConstructionFeelsTheRamp) {
  const Gravity gravity{.acceleration = 9.81, .ramped_layer = 3, .factor = 0.25};
  EXPECT_DOUBLE_EQ(gravity.on(2), 9.81);
  EXPECT_DOUBLE_EQ(gravity.on(3), 0.25 * 9.81);
}

TEST(StableTimeStep, OfFullCellsIsTheShortestAltitudeOverTheCompressionWave) {
  auto body = block();
  const double wave = std::sqrt(480e3 / block_density);
  EXPECT_NEAR(stable_time_step(body, 0.9) / (0.9 * 0.5 / std::sqrt(2.0) / wave), 1.0, 1e-12);
}

TEST(StableTimeStep, IsThatOfTheLightestCellOverItsFullArea) {
  auto body = block({.columns = 2, .rows = 5, .filled_rows = 3});
  body.points.add({.position = {0.1, 2.1}, .volume = 0.004, .density = block_density});
  body.sort();
  const double density = 0.004 * block_density / (0.5 * 0.5 * 0.5);
  const double wave = std::sqrt(480e3 / density);
  EXPECT_NEAR(stable_time_step(body, 0.9) / (0.9 * 0.5 / std::sqrt(2.0) / wave), 1.0, 1e-12);
}

TEST(StableTimeStep, WithIntegrationOverThePointsVolumesIsThatOfTheMaterial) {
  auto body = block({.columns = 2, .rows = 5, .filled_rows = 3});
  body.integration = StressIntegration::points;
  body.points.add({.position = {0.1, 2.1}, .volume = 0.004, .density = block_density});
  body.sort();
  EXPECT_NEAR(stable_time_step(body, 0.9) / (0.9 * 0.5 / std::sqrt(2.0) / std::sqrt(480e3 / block_density)), 1.0,
              1e-12);
}

TEST(StableTimeStep, GrowsWithTheDensityOfAnOverfullCell) {
  auto body = block();
  for (double& mass : body.points.mass)
    mass *= 4.0;
  for (double& volume : body.points.volume)
    volume *= 2.0; // twice the cell: the points' own density counts
  EXPECT_NEAR(stable_time_step(body, 1.0) / (0.5 / std::sqrt(2.0) / std::sqrt(480e3 / (2.0 * block_density))), 1.0,
              1e-12);
}

} // namespace
} // namespace settle::mpm::test
