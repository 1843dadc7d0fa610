// The phases of an explicit step, each on its own, on bodies with random points, velocities and stresses.

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm::test {
namespace {

using Nodes = std::vector<NodeState<2>>;

/// A body, and a step that has been begun.
template <class Space>
struct Scattered {
  Body<Space> body;
  ExplicitStep<Space> step{body};

  [[nodiscard]] Nodes nodes() const {
    Nodes all;
    for (int n = 0; n < body.space.n_nodes(); ++n)
      all.push_back(step.node(n));
    return all;
  }
};

template <class Space = TriangleSpace>
std::unique_ptr<Scattered<Space>> scattered(bool supported) {
  std::mt19937 random(21);
  auto state = std::make_unique<Scattered<Space>>(block<Space>({.supported = supported}));
  scatter_positions(state->body, random, 0.2);
  randomize_velocities(state->body, random);
  randomize_stresses(state->body, random);
  state->step.scatter({});
  return state;
}

template <class Member>
Vector<2> sum_of(const Nodes& nodes, Member member) {
  Vector<2> sum = Vector<2>::Zero();
  for (const auto& node : nodes)
    sum += node.*member;
  return sum;
}

double mass_of(const Nodes& nodes) {
  double mass = 0;
  for (const auto& node : nodes)
    mass += node.mass;
  return mass;
}

template <class Space>
class ExplicitPhasesOf : public testing::Test {};
TYPED_TEST_SUITE(ExplicitPhasesOf, EveryPlaneSpace, SpaceName);

TYPED_TEST(ExplicitPhasesOf, ScatteringConservesMassAndMomentum) {
  const auto state = scattered<TypeParam>(false);
  auto& body = state->body;
  const Nodes nodes = state->nodes();
  EXPECT_NEAR(mass_of(nodes) / total_mass(body.points), 1.0, 1e-14);
  const Vector<2> momentum = total_momentum(body.points);
  EXPECT_LT((sum_of(nodes, &NodeState<2>::momentum) - momentum).norm(), 1e-13 * total_mass(body.points));
}

TYPED_TEST(ExplicitPhasesOf, ExternalForceIsTheWeightAndInternalForcesCancelOut) {
  const auto state = scattered<TypeParam>(false);
  auto& body = state->body;
  const Nodes nodes = state->nodes();
  const Vector<2> external = sum_of(nodes, &NodeState<2>::external);
  EXPECT_EQ(external[0], 0.0);
  EXPECT_NEAR(external[1] / (-9.81 * total_mass(body.points)), 1.0, 1e-14);
  double largest = 0;
  for (const auto& node : nodes)
    largest = std::max(largest, node.internal.norm());
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(sum_of(nodes, &NodeState<2>::internal).norm(), 1e-13 * largest);
}

TEST(ScatterPoints, InternalForceDoesTheWorkOfTheCellsStressOverTheirFullArea) {
  const auto state = scattered(false);
  auto& body = state->body;
  const Nodes nodes = state->nodes();
  const auto field = [](const Vector<2>& x) { return Vector<2>(0.3 * x[0] - 0.2 * x[1], 0.7 * x[0] + 0.4 * x[1]); };
  double nodal = 0, expected = 0;
  for (int n = 0; n < body.space.n_nodes(); ++n)
    nodal += nodes[static_cast<std::size_t>(n)].internal.dot(field(body.space.node_position(n)));
  for (const int cell : body.cells.occupied) { // area * sigma : sym(gradient of the field), averages taken by hand
    double volume = 0, xx = 0, yy = 0, xy = 0;
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      if (body.points.cell[p] != cell) continue;
      volume += body.points.volume[p];
      xx += body.points.volume[p] * body.points.stress[0][p];
      yy += body.points.volume[p] * body.points.stress[1][p];
      xy += body.points.volume[p] * body.points.stress[3][p];
    }
    expected += 0.5 * 0.5 * 0.5 * (0.3 * xx + 0.4 * yy + (0.7 - 0.2) * xy) / volume;
  }
  EXPECT_NEAR(nodal / expected, 1.0, 1e-11);
}

TEST(ScatterPoints, ForgetsTheStepBefore) {
  const auto state = scattered(false);
  const double mass = mass_of(state->nodes());
  state->step.accelerate(0.0);
  state->step.displace(0.0, 0.0);
  state->step.scatter({});
  EXPECT_EQ(mass_of(state->nodes()), mass);
}

/// Constant stress over the full cells of a block whose points lie anywhere in them: only its outer nodes carry force.
TYPED_TEST(ExplicitPhasesOf, AConstantStressIsInEquilibriumInsideABlockWithPointsAnywhere) {
  const auto state = scattered<TypeParam>(false);
  auto& body = state->body;
  for (auto& component : body.points.stress)
    std::fill(component.begin(), component.end(), -5e3);
  state->step.scatter({});
  const Nodes nodes = state->nodes();
  int inner = 0;
  for (int n = 0; n < body.space.n_nodes(); ++n) {
    const int column = n % body.space.node_columns(), row = n / body.space.node_columns();
    const bool inside = column > 0 && column < body.space.node_columns() - 1 && row > 0 && row < 3;
    const double force = nodes[static_cast<std::size_t>(n)].internal.norm();
    if (!inside) continue;
    EXPECT_LT(force, 1e-12 * 5e3 * body.space.size());
    ++inner;
  }
  EXPECT_EQ(inner, 2 * (body.space.node_columns() - 2));
}

TEST(Accelerate, DampingIsItsShareOfTheUnbalancedForceAgainstTheVelocityAndNeverTurnsTheAcceleration) {
  const auto state = scattered(false);
  const Nodes before = state->nodes();
  state->step.accelerate(0.0);
  const Nodes free = state->nodes();
  state->step.scatter({});
  state->step.accelerate(0.75);
  const Nodes damped = state->nodes();
  int judged = 0;
  for (std::size_t n = 0; n < free.size(); ++n)
    for (int d = 0; d < 2; ++d) {
      if (free[n].mass == 0.0) continue;
      const double a = free[n].acceleration[d], b = damped[n].acceleration[d], v = before[n].momentum[d];
      EXPECT_NEAR(std::abs(b - a), 0.75 * std::abs(a), 1e-12 * std::abs(a));
      EXPECT_LE((b - a) * v, 0.0);
      EXPECT_GT(a * b, 0.0);
      ++judged;
    }
  EXPECT_GT(judged, 20);
}

TYPED_TEST(ExplicitPhasesOf, AnUndampedNodeObeysNewton) {
  const auto state = scattered<TypeParam>(false);
  const Nodes before = state->nodes();
  state->step.accelerate(0.0);
  const Nodes after = state->nodes();
  for (std::size_t n = 0; n < after.size(); ++n)
    if (after[n].mass > 0.0) {
      const Vector<2> unbalanced = before[n].external - before[n].internal;
      EXPECT_LT((after[n].mass * after[n].acceleration - unbalanced).norm(), 1e-10 * before[n].external.norm());
    }
}

TYPED_TEST(ExplicitPhasesOf, WhatIsNotAcceleratedIsCarriedByTheBase) {
  const auto state = scattered<TypeParam>(true);
  const auto sums = state->step.accelerate(0.0);
  double free_vertical = 0;
  for (const auto& node : state->nodes())
    free_vertical += node.mass * node.acceleration[1];
  EXPECT_NEAR(sums.base_reaction, 9.81 * total_mass(state->body.points) + free_vertical, 1e-9 * sums.external);
}

/// Masses do not change within a step; a point loses mass to nothing.
TYPED_TEST(ExplicitPhasesOf, AStepConservesMassAndChangesMomentumByItsImpulse) {
  const auto state = scattered<TypeParam>(false);
  auto& [body, step] = *state;
  const double mass = total_mass(body.points);
  const Vector<2> before = total_momentum(body.points);
  step.accelerate(0.75);
  Vector<2> impulse = Vector<2>::Zero();
  const double dt = 1e-3;
  for (const auto& node : state->nodes())
    impulse += dt * node.mass * node.acceleration;
  step.displace(dt, dt);
  Vector<2> remapped = Vector<2>::Zero();
  for (const auto& node : state->nodes())
    remapped += node.mass / dt * node.displacement;
  step.move();
  step.gather();
  const Vector<2> after = total_momentum(body.points);
  EXPECT_EQ(total_mass(body.points), mass);
  EXPECT_GT(impulse.norm(), 1e-4 * mass);
  EXPECT_LT((after - before - impulse).norm(), 1e-13 * mass);
  EXPECT_LT((remapped - after).norm(), 1e-13 * mass);
}

TYPED_TEST(ExplicitPhasesOf, NothingMovesThroughAFrictionlessSupport) {
  const auto state = scattered<TypeParam>(true);
  auto& [body, step] = *state;
  const auto lowest_and_outermost = [&points = body.points, width = body.space.width()] {
    const auto& [x, y] = points.position;
    const auto [left, right] = std::minmax_element(x.begin(), x.end());
    return std::array{*left, width - *right, *std::min_element(y.begin(), y.end())};
  };
  for (int k = 0; k < 200; ++k) {
    step.scatter({});
    const double dt = step.stable_time_step(0.5);
    step.accelerate(0.0);
    for (int n = 0; n < body.space.n_nodes(); ++n)
      for (int d = 0; d < 2; ++d)
        if (body.fixed[static_cast<std::size_t>(n)][static_cast<std::size_t>(d)]) {
          EXPECT_EQ(step.node(n).acceleration[d], 0.0);
        }
    step.displace(dt, dt);
    step.move();
    step.gather();
    for (const double distance : lowest_and_outermost())
      ASSERT_GT(distance, 0.0) << "step " << k;
  }
}

} // namespace
} // namespace settle::mpm::test
