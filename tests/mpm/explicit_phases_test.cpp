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

/// A body, and a step that has been begun.
template <class Space>
struct Scattered {
  Body<Space> body;
  ExplicitStep<Space> step{body};

  [[nodiscard]] Nodes<Space::dim> nodes() { return step.nodes(); }
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

template <int dim>
Vector<dim> sum_of(const Nodes<dim>& nodes, Vector<dim> NodeState<dim>::*member) {
  Vector<dim> sum = Vector<dim>::Zero();
  for (const auto& node : nodes)
    sum += node.*member;
  return sum;
}

template <int dim>
double mass_of(const Nodes<dim>& nodes) {
  double mass = 0;
  for (const auto& node : nodes)
    mass += node.mass;
  return mass;
}

template <class Space>
class ExplicitPhasesOf : public testing::Test {};
TYPED_TEST_SUITE(ExplicitPhasesOf, EverySpace, SpaceName);

TYPED_TEST(ExplicitPhasesOf, ScatteringConservesMassAndMomentum) {
  const auto state = scattered<TypeParam>(false);
  auto& body = state->body;
  const auto nodes = state->nodes();
  EXPECT_NEAR(mass_of(nodes) / total_mass(body.points), 1.0, 1e-14);
  const auto momentum = total_momentum(body.points);
  EXPECT_LT((sum_of(nodes, &NodeState<TypeParam::dim>::momentum) - momentum).norm(), 1e-13 * total_mass(body.points));
}

TYPED_TEST(ExplicitPhasesOf, ExternalForceIsTheWeightAndInternalForcesCancelOut) {
  const auto state = scattered<TypeParam>(false);
  auto& body = state->body;
  const auto nodes = state->nodes();
  constexpr int dim = TypeParam::dim;
  const Vector<dim> external = sum_of(nodes, &NodeState<dim>::external);
  EXPECT_EQ(external.template head<dim - 1>().norm(), 0.0);
  EXPECT_NEAR(external[dim - 1] / (-9.81 * total_mass(body.points)), 1.0, 1e-14);
  double largest = 0;
  for (const auto& node : nodes)
    largest = std::max(largest, node.internal.norm());
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(sum_of(nodes, &NodeState<dim>::internal).norm(), 1e-13 * largest);
}

TEST(ScatterPoints, InternalForceDoesTheWorkOfTheCellsStressOverTheirFullArea) {
  const auto state = scattered(false);
  auto& body = state->body;
  const auto nodes = state->nodes();
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
  const auto nodes = state->nodes();
  constexpr std::size_t vertical = TypeParam::dim - 1;
  const auto& numbering = body.space.node_numbering();
  int inner = 0, expected = 2;
  for (std::size_t d = 0; d < vertical; ++d)
    expected *= numbering.counts[d] - 2;
  for (int n = 0; n < body.space.n_nodes(); ++n) {
    const auto index = numbering.index(n);
    bool inside = index[vertical] > 0 && index[vertical] < 3;
    for (std::size_t d = 0; d < vertical; ++d)
      inside = inside && index[d] > 0 && index[d] < numbering.counts[d] - 1;
    if (!inside) continue;
    EXPECT_LT(nodes[static_cast<std::size_t>(n)].internal.norm(), 1e-12 * 5e3 * body.space.column_area());
    ++inner;
  }
  EXPECT_EQ(inner, expected);
}

TEST(Accelerate, DampingIsItsShareOfTheUnbalancedForceAgainstTheVelocityAndNeverTurnsTheAcceleration) {
  const auto state = scattered(false);
  const auto before = state->nodes();
  state->step.accelerate(0.0);
  const auto free = state->nodes();
  state->step.scatter({});
  state->step.accelerate(0.75);
  const auto damped = state->nodes();
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
  const auto before = state->nodes();
  state->step.accelerate(0.0);
  const auto after = state->nodes();
  for (std::size_t n = 0; n < after.size(); ++n)
    if (after[n].mass > 0.0) {
      const auto unbalanced = (before[n].external - before[n].internal).eval();
      EXPECT_LT((after[n].mass * after[n].acceleration - unbalanced).norm(), 1e-10 * before[n].external.norm());
    }
}

TYPED_TEST(ExplicitPhasesOf, WhatIsNotAcceleratedIsCarriedByTheBase) {
  const auto state = scattered<TypeParam>(true);
  const auto sums = state->step.accelerate(0.0);
  double free_vertical = 0;
  for (const auto& node : state->nodes())
    free_vertical += node.mass * node.acceleration[TypeParam::dim - 1];
  EXPECT_NEAR(sums.base_reaction, 9.81 * total_mass(state->body.points) + free_vertical, 1e-9 * sums.external);
}

/// Masses do not change within a step; a point loses mass to nothing.
TYPED_TEST(ExplicitPhasesOf, AStepConservesMassAndChangesMomentumByItsImpulse) {
  const auto state = scattered<TypeParam>(false);
  auto& [body, step] = *state;
  const double mass = total_mass(body.points);
  using Momentum = Vector<TypeParam::dim>;
  const Momentum before = total_momentum(body.points);
  step.accelerate(0.75);
  Momentum impulse = Momentum::Zero();
  const double dt = 1e-3;
  for (const auto& node : state->nodes())
    impulse += dt * node.mass * node.acceleration;
  step.displace(dt, dt);
  Momentum remapped = Momentum::Zero();
  for (const auto& node : state->nodes())
    remapped += node.mass / dt * node.displacement;
  step.move();
  step.gather();
  const Momentum after = total_momentum(body.points);
  EXPECT_EQ(total_mass(body.points), mass);
  EXPECT_GT(impulse.norm(), 1e-4 * mass);
  EXPECT_LT((after - before - impulse).norm(), 1e-13 * mass);
  EXPECT_LT((remapped - after).norm(), 1e-13 * mass);
}

TYPED_TEST(ExplicitPhasesOf, NothingMovesThroughAFrictionlessSupport) {
  const auto state = scattered<TypeParam>(true);
  auto& [body, step] = *state;
  constexpr int dim = TypeParam::dim;
  const auto distance_to_supports = [&position = body.points.position, &space = body.space] {
    double distance = INFINITY;
    for (int d = 0; d < dim; ++d) {
      const auto& x = position[static_cast<std::size_t>(d)];
      const auto [first, last] = std::minmax_element(x.begin(), x.end());
      distance = std::min(distance, *first);
      if (d + 1 < dim) distance = std::min(distance, space.extent(d) - *last);
    }
    return distance;
  };
  for (int k = 0; k < 200; ++k) {
    step.scatter({});
    const double dt = step.stable_time_step(0.5);
    step.accelerate(0.0);
    for (int n = 0; n < body.space.n_nodes(); ++n)
      for (int d = 0; d < dim; ++d)
        if (body.fixed[static_cast<std::size_t>(n)][static_cast<std::size_t>(d)]) {
          EXPECT_EQ(step.node(n).acceleration[d], 0.0);
        }
    step.displace(dt, dt);
    step.move();
    step.gather();
    ASSERT_GT(distance_to_supports(), 0.0) << "step " << k;
  }
}

} // namespace
} // namespace settle::mpm::test
