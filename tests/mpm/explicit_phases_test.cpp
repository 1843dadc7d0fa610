// The phases of an explicit step, each on its own, on bodies with random points, velocities and stresses.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm::test {
namespace {

template <class Space>
struct Scattered {
  Body<Space> body;
  Nodes<Space::dim> nodes;
};

template <class Space = TriangleSpace>
Scattered<Space> scattered(bool supported, double g = 9.81) {
  std::mt19937 random(21);
  Scattered<Space> state{block<Space>({.supported = supported}), {}};
  scatter_positions(state.body, random, 0.2);
  randomize_velocities(state.body, random);
  randomize_stresses(state.body, random);
  state.nodes.resize(static_cast<std::size_t>(state.body.space.n_nodes()));
  scatter_points(state.body, {.acceleration = g}, state.nodes);
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
  const auto [body, nodes] = scattered<TypeParam>(false);
  EXPECT_NEAR(mass_of(nodes) / total_mass(body.points), 1.0, 1e-14);
  const auto momentum = total_momentum(body.points);
  EXPECT_LT((sum_of(nodes, &NodeState<TypeParam::dim>::momentum) - momentum).norm(), 1e-13 * total_mass(body.points));
}

TYPED_TEST(ExplicitPhasesOf, ExternalForceIsTheWeightAndInternalForcesCancelOut) {
  const auto [body, nodes] = scattered<TypeParam>(false);
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
  const auto [body, nodes] = scattered(false);
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
  auto [body, nodes] = scattered(false);
  const double mass = mass_of(nodes);
  scatter_points(body, {}, nodes);
  EXPECT_EQ(mass_of(nodes), mass);
}

/// Constant stress over the full cells of a block whose points lie anywhere in them: only its outer nodes carry force.
TYPED_TEST(ExplicitPhasesOf, AConstantStressIsInEquilibriumInsideABlockWithPointsAnywhere) {
  auto [body, nodes] = scattered<TypeParam>(false);
  for (auto& component : body.points.stress)
    std::fill(component.begin(), component.end(), -5e3);
  scatter_points(body, {}, nodes);
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

TEST(UpdateNodes, DampingIsItsShareOfTheUnbalancedForceAgainstTheVelocityAndNeverTurnsTheAcceleration) {
  auto [body, free] = scattered(false);
  auto damped = free;
  update_nodes(body, 0.0, free);
  update_nodes(body, 0.75, damped);
  int judged = 0;
  for (std::size_t n = 0; n < free.size(); ++n)
    for (int d = 0; d < 2; ++d) {
      if (free[n].mass == 0.0) continue;
      const double a = free[n].acceleration[d], b = damped[n].acceleration[d], v = free[n].momentum[d];
      EXPECT_NEAR(std::abs(b - a), 0.75 * std::abs(a), 1e-12 * std::abs(a));
      EXPECT_LE((b - a) * v, 0.0);
      EXPECT_GT(a * b, 0.0);
      ++judged;
    }
  EXPECT_GT(judged, 20);
}

TEST(UpdateNodes, AnUndampedNodeObeysNewton) {
  auto [body, nodes] = scattered(false);
  update_nodes(body, 0.0, nodes);
  for (const auto& node : nodes)
    if (node.mass > 0.0) {
      EXPECT_LT((node.mass * node.acceleration - (node.external - node.internal)).norm(), 1e-10 * node.external.norm());
    }
}

TEST(UpdateNodes, WhatIsNotAcceleratedIsCarriedByTheBase) {
  auto [body, nodes] = scattered(true);
  const auto sums = update_nodes(body, 0.0, nodes);
  double free_vertical = 0;
  for (const auto& node : nodes)
    free_vertical += node.mass * node.acceleration[1];
  EXPECT_NEAR(sums.base_reaction, 9.81 * total_mass(body.points) + free_vertical, 1e-9 * sums.external);
}

TYPED_TEST(ExplicitPhasesOf, RemappingConservesTheMomentumOfTheUpdatedPoints) {
  auto [body, nodes] = scattered<TypeParam>(false);
  using Momentum = Vector<TypeParam::dim>;
  const Momentum before = total_momentum(body.points);
  update_nodes(body, 0.75, nodes);
  Momentum impulse = Momentum::Zero();
  const double dt = 1e-3;
  for (const auto& node : nodes)
    impulse += dt * node.mass * node.acceleration;
  update_velocity_and_remap(body, dt, nodes);
  const Momentum after = total_momentum(body.points);
  const double scale = total_mass(body.points);
  EXPECT_GT(impulse.norm(), 1e-4 * scale);
  EXPECT_LT((after - before - impulse).norm(), 1e-13 * scale);
  EXPECT_LT((sum_of(nodes, &NodeState<TypeParam::dim>::remapped) - after).norm(), 1e-13 * scale);
}

TYPED_TEST(ExplicitPhasesOf, NothingMovesThroughAFrictionlessSupport) {
  auto [body, nodes] = scattered<TypeParam>(true);
  constexpr int dim = TypeParam::dim;
  const auto distance_to_supports = [&body = body] {
    double distance = INFINITY;
    for (int d = 0; d < dim; ++d) {
      const auto& x = body.points.position[static_cast<std::size_t>(d)];
      const auto [first, last] = std::minmax_element(x.begin(), x.end());
      distance = std::min(distance, *first);
      if (d + 1 < dim) distance = std::min(distance, body.space.extent(d) - *last);
    }
    return distance;
  };
  for (int k = 0; k < 200; ++k) {
    const double dt = stable_time_step(body, 0.5);
    scatter_points(body, {.acceleration = 9.81}, nodes);
    update_nodes(body, 0.0, nodes);
    update_velocity_and_remap(body, dt, nodes);
    update_stress_and_move(body, {.acceleration = 9.81}, dt, nodes);
    ASSERT_GT(distance_to_supports(), 0.0) << "step " << k;
  }
  for (int n = 0; n < body.space.n_nodes(); ++n)
    for (int d = 0; d < dim; ++d)
      if (body.fixed[static_cast<std::size_t>(n)][static_cast<std::size_t>(d)]) {
        EXPECT_EQ(nodes[static_cast<std::size_t>(n)].acceleration[d], 0.0);
      }
}

} // namespace
} // namespace settle::mpm::test
