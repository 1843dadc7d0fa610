// The kernels of the explicit step against the plain step, point by point, and against themselves: with other threads,
// other instruction sets, and points that have strayed from their cells.

#include "kernel_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "pointwise_step.hpp"

namespace settle::mpm::test {
namespace {

using SpacesWithKernels = testing::Types<TriangleSpace, QuadrilateralSpace, BSplineSpace<2>, TetrahedronSpace,
                                         HexahedronSpace, BSplineSpace<3>>;

template <class Space>
class KernelStepOf : public testing::Test {};
TYPED_TEST_SUITE(KernelStepOf, SpacesWithKernels, SpaceName);

/// What can be told to a body.
struct Told {
  StressIntegration integration = StressIntegration::full_cells;
  exchange::Law law = exchange::Law::rate;
  bool jaumann = false, average_stress = false;
  Block block{};
  double scatter = 0.3; ///< of points from where they are placed, in squares
};

/// Points of two layers anywhere in the block, of different volumes, stressed and on the move.
template <class Space>
Body<Space> stirred_block(const Told& told, double speed) {
  std::mt19937 random(11);
  auto body = block<Space>(told.block);
  body.integration = told.integration;
  body.law = told.law;
  body.jaumann = told.jaumann;
  body.average_stress = told.average_stress;
  if (told.law != exchange::Law::rate) {
    body.points = {};
    body.points.tracks_deformation = true;
    place_layer(body, {.layer = 1, .base = 0.0, .thickness = told.block.filled_rows * told.block.size});
    body.sort();
  }
  scatter_positions(body, random, told.scatter);
  randomize_velocities(body, random);
  if (told.law == exchange::Law::rate) randomize_stresses(body, random);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const double by = share(random);
    body.points.mass[p] *= by, body.points.volume[p] *= by;
    body.points.layer[p] = body.points.position.back()[p] > 0.6 * told.block.filled_rows * told.block.size ? 2 : 1;
  }
  for (auto& component : body.points.velocity)
    for (double& value : component)
      value *= speed;
  return body;
}

/// What a step says of itself.
struct Said {
  double dt;
  ForceSums forces;
  StepEnergy energy;
};
template <class Step>
Said advance(Step& step, const Gravity& gravity) {
  step.scatter(gravity);
  Said said{};
  said.dt = step.stable_time_step(0.5);
  said.forces = step.accelerate(0.4);
  said.energy = step.displace(0.75 * said.dt, said.dt, 0.9); // as where velocities are those of half steps, and damped
  step.move();
  return said;
}

/// All that a step changes, by point.
template <int dim>
std::map<std::uint64_t, std::vector<double>> by_id(const Points<dim>& points) {
  std::map<std::uint64_t, std::vector<double>> all;
  for (std::size_t p = 0; p < points.size(); ++p) {
    auto& own = all[points.id[p]];
    own = {points.mass[p], points.volume[p]};
    for (const auto* group : {&points.position, &points.velocity})
      for (const auto& values : *group)
        own.push_back(values[p]);
    for (const auto& values : points.stress)
      own.push_back(values[p]);
    for (const auto& values : points.deformation)
      if (!values.empty()) own.push_back(values[p]);
    own.push_back(points.cell[p]);
  }
  return all;
}

/// Largest difference of any quantity over its largest value in the other.
template <int dim>
double difference(const Points<dim>& a, const Points<dim>& b) {
  const auto of_a = by_id(a), of_b = by_id(b);
  EXPECT_EQ(of_a.size(), of_b.size());
  const std::size_t n = of_a.begin()->second.size();
  double worst = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double largest = 0, scale = 0;
    for (const auto& [id, values] : of_a) {
      largest = std::max(largest, std::abs(values[k] - of_b.at(id)[k]));
      scale = std::max(scale, std::abs(values[k]));
    }
    worst = std::max(worst, largest / scale);
  }
  return worst;
}

Vector<2> swirl(const Points<2>& points, std::size_t p) {
  return {0.3 * points.placed[1][p], points.layer[p] - 0.2 * points.placed[0][p]};
}

const Gravity ramped{.acceleration = 9.81, .ramped_layer = 2, .factor = 0.3};
const Gravity forced{.acceleration = 9.81, .ramped_layer = 2, .factor = 0.3, .besides = swirl};

/// Round-off, which a node that hardly any mass reaches enlarges; a wrong term is a thousand million times that.
constexpr double round_off = 1e-8;

template <class Space>
void expect_same_as_pointwise(const Told& told, const Gravity& gravity) {
  auto body = stirred_block<Space>(told, 0.5);
  auto plain = body;
  KernelStep<Space> step(body);
  PointwiseStep<Space> reference(plain);
  const auto before = by_id(body.points);
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(testing::Message() << "step " << k << ", block of " << told.block.columns << " x " << told.block.rows);
    const Said own = advance(step, gravity), other = advance(reference, gravity);
    EXPECT_NEAR(own.dt / other.dt, 1.0, round_off);
    EXPECT_NEAR(own.forces.unbalanced / other.forces.unbalanced, 1.0, round_off);
    EXPECT_NEAR(own.forces.external / other.forces.external, 1.0, round_off);
    EXPECT_NEAR(own.forces.base_reaction, other.forces.base_reaction, round_off * other.forces.external);
    EXPECT_NEAR(own.energy.kinetic / other.energy.kinetic, 1.0, round_off);
    EXPECT_NEAR(own.energy.external_work, other.energy.external_work, round_off * other.energy.kinetic);
  }
  step.gather();
  EXPECT_LT(difference(plain.points, body.points), round_off);
  if (told.block.columns == 1 || told.scatter < 0.1) return; // where hardly anything moves
  int crossed = 0;
  for (const auto& [id, values] : by_id(body.points))
    crossed += values.back() != before.at(id).back() ? 1 : 0;
  EXPECT_GT(crossed, 0);
}

/// Points of the plane can be told a force besides gravity.
template <class Space>
std::vector<Gravity> every_load() {
  if (Space::dim == 2) return {{}, ramped, forced};
  return {{}, ramped};
}

TYPED_TEST(KernelStepOf, IsThePlainStepToRoundOffForBothIntegrationsAndEveryKindOfLoad) {
  for (const auto integration : {StressIntegration::full_cells, StressIntegration::points})
    for (const Gravity& gravity : every_load<TypeParam>())
      expect_same_as_pointwise<TypeParam>({.integration = integration}, gravity);
}

TYPED_TEST(KernelStepOf, IsThePlainStepToRoundOffWhereSquaresHoldAsManyPointsAsWerePlaced) {
  for (const auto integration : {StressIntegration::full_cells, StressIntegration::points})
    for (const Gravity& gravity : every_load<TypeParam>())
      expect_same_as_pointwise<TypeParam>(
          {.integration = integration, .block = {.columns = 29, .rows = 5, .filled_rows = 4}, .scatter = 0.05},
          gravity);
}

TYPED_TEST(KernelStepOf, IsThePlainStepToRoundOffForEveryLaw) {
  expect_same_as_pointwise<TypeParam>({.law = exchange::Law::hencky}, ramped);
  expect_same_as_pointwise<TypeParam>({.law = exchange::Law::neo_hookean}, ramped);
  expect_same_as_pointwise<TypeParam>({.jaumann = true}, ramped);
  expect_same_as_pointwise<TypeParam>({.average_stress = true}, ramped);
}

/// With one strip and many, whose last is short, and with strips of one tile and of many.
template <class Space>
std::vector<Block> every_shape() {
  if (Space::dim == 3)
    return {
        {.columns = 1, .deep = 1, .rows = 2, .filled_rows = 1},
        {.columns = 1, .deep = 3, .rows = 12, .filled_rows = 11},
        {.columns = 100, .deep = 1, .rows = 4, .filled_rows = 3},
        {.columns = 575, .deep = 1, .rows = 3, .filled_rows = 2}, // B-splines: 8 tiles of 72 nodes, and one more node
        {.columns = 20, .deep = 14, .rows = 5, .filled_rows = 4},
        {.columns = 7, .deep = 40, .rows = 4, .filled_rows = 3}};
  return {{.columns = 1, .rows = 2, .filled_rows = 1},
          {.columns = 1, .rows = 12, .filled_rows = 11},
          {.columns = 300, .rows = 7, .filled_rows = 6},
          {.columns = 1100, .rows = 3, .filled_rows = 2}, // lines longer than a tile
          {.columns = 70, .rows = 9, .filled_rows = 8},
          {.columns = 62, .rows = 61, .filled_rows = 60}};
}

TYPED_TEST(KernelStepOf, IsThePlainStepToRoundOffOnGridsOfEveryShape) {
  for (const Block& block : every_shape<TypeParam>())
    for (const auto integration : {StressIntegration::full_cells, StressIntegration::points})
      expect_same_as_pointwise<TypeParam>({.integration = integration, .block = block}, ramped);
}

/// Of all nodes, by component and phase: the largest difference over the largest value.
template <int dim>
void expect_same_nodes(const auto& step, const auto& reference, std::vector<Vector<dim> NodeState<dim>::*> members) {
  Nodes<dim> own, other;
  step.read_nodes(own), reference.read_nodes(other);
  ASSERT_EQ(own.size(), other.size());
  double apart = 0, heaviest = 0;
  for (std::size_t n = 0; n < own.size(); ++n) {
    apart = std::max(apart, std::abs(own[n].mass - other[n].mass));
    heaviest = std::max(heaviest, other[n].mass);
  }
  EXPECT_LT(apart, round_off * heaviest);
  for (const auto member : members) {
    double largest = 0, scale = 0;
    for (std::size_t n = 0; n < own.size(); ++n) {
      largest = std::max(largest, (own[n].*member - other[n].*member).norm());
      scale = std::max(scale, (other[n].*member).norm());
      EXPECT_EQ(step.node(static_cast<int>(n)).*member, own[n].*member);
    }
    EXPECT_LT(largest, round_off * scale);
  }
}

/// Where strips meet, sums are in two places until they are completed.
TYPED_TEST(KernelStepOf, NodesAreThoseOfThePlainStepInEveryPhaseOnGridsOfEveryShape) {
  using State = NodeState<TypeParam::dim>;
  for (const Block& block : every_shape<TypeParam>()) {
    SCOPED_TRACE(testing::Message() << "block of " << block.columns << " x " << block.rows);
    auto body = stirred_block<TypeParam>({.block = block}, 0.5);
    auto plain = body;
    KernelStep<TypeParam> step(body);
    PointwiseStep<TypeParam> reference(plain);
    const auto expect_same = [&](std::vector<Vector<TypeParam::dim> State::*> members) {
      expect_same_nodes<TypeParam::dim>(step, reference, members);
    };
    step.scatter({}), reference.scatter({});
    expect_same({&State::momentum, &State::internal, &State::external});
    const double dt = step.stable_time_step(0.5);
    step.accelerate(0.4), reference.accelerate(0.4);
    expect_same({&State::acceleration});
    step.displace(dt, dt), reference.displace(dt, dt);
    expect_same({&State::displacement});
  }
}

/// Sums of surfaces over the columns, and the surface that nobody has to sort for.
TYPED_TEST(KernelStepOf, KnowsTheSurfaceOfEveryColumnWithoutSorting) {
  auto body = stirred_block<TypeParam>({.block = {.columns = 9, .rows = 60, .filled_rows = 59}}, 0.5);
  KernelStep<TypeParam> step(body);
  for (int k = 0; k < 8; ++k)
    advance(step, ramped);
  step.scatter(ramped);
  const auto heights = step.column_heights();
  step.gather();
  const auto exact = column_heights(body);
  ASSERT_EQ(heights.size(), exact.size());
  for (std::size_t column = 0; column < exact.size(); ++column)
    EXPECT_NEAR(heights[column] / exact[column], 1.0, 1e-13);
}

/// With about 10 000 points for each thread, so that all are used.
template <class Space>
Points<Space::dim> after_steps(int threads, const kernel::Variant& variant) {
  const Block plane{.columns = 70, .rows = 120, .filled_rows = 118},
      solid{.columns = 20, .deep = 12, .rows = 20, .filled_rows = 19};
  auto body = stirred_block<Space>({.block = Space::dim == 2 ? plane : solid}, 0.5);
  KernelStep<Space> step(body, threads, variant);
  for (int k = 0; k < 6; ++k)
    advance(step, ramped);
  step.gather();
  return body.points;
}

TYPED_TEST(KernelStepOf, GivesTheSameBitsOnAnyNumberOfThreads) {
  const auto one = after_steps<TypeParam>(1, kernel::best_variant());
  ASSERT_GT(one.size(), 30'000U);
  for (const int threads : {2, 3})
    EXPECT_EQ(by_id(after_steps<TypeParam>(threads, kernel::best_variant())), by_id(one)) << threads;
}

TYPED_TEST(KernelStepOf, GivesTheSameBitsWithEveryInstructionSet) {
  const auto best = after_steps<TypeParam>(1, kernel::best_variant());
  for (const kernel::Variant* variant : kernel::variants_here())
    EXPECT_EQ(by_id(after_steps<TypeParam>(1, *variant)), by_id(best)) << variant->name;
}

/// Grids of many heights, so that the last strip is a whole one or a short one.
TYPED_TEST(KernelStepOf, EmptyRowsAboveTheBodyChangeNothing) {
  const auto moved = [](int rows) {
    auto body = stirred_block<TypeParam>({.block = {.columns = 129, .rows = rows, .filled_rows = 2}}, 0.1);
    KernelStep<TypeParam> step(body);
    for (int k = 0; k < 3; ++k)
      advance(step, ramped);
    step.gather();
    return by_id(body.points);
  };
  const auto low = moved(5);
  for (const int rows : {64, 127, 128, 129, 130, 131})
    EXPECT_EQ(moved(rows), low) << rows;
}

/// Points that start in the uppermost row fall until the strip of rows there is empty and has been sorted out. Among
/// grids of so many heights the last strip lacks none of its rows, some, or all but a few; nodes above it are those of
/// all squares wherever it ends.
TYPED_TEST(KernelStepOf, NodesOfALastStripOfAnyHeightAreClearedOnceItHasEmptied) {
  for (int rows = 12; rows <= 20; ++rows) {
    const Block data{.columns = 40, .rows = rows, .filled_rows = 1, .supported = false};
    auto body = block<TypeParam>(data);
    body.points = {};
    place_layer(body, {.layer = 1, .base = (rows - 1) * data.size, .thickness = data.size});
    body.sort();
    auto& height = body.points.position.back();
    std::fill(body.points.velocity.back().begin(), body.points.velocity.back().end(), -3.0);
    KernelStep<TypeParam> step(body);
    while (*std::max_element(height.begin(), height.end()) > 2.5 * data.size) {
      step.scatter({.acceleration = 0.0});
      const double dt = step.stable_time_step(0.5);
      step.accelerate(0.0);
      step.displace(dt, dt);
      step.move();
    }
    step.scatter({});
    step.accelerate(0.0);
    double mass = 0;
    for (int n = 0; n < body.space.n_nodes(); ++n)
      mass += step.node(n).mass;
    EXPECT_NEAR(mass / total_mass(body.points), 1.0, 1e-13) << rows;
  }
}

/// Points that leave the grid are missed, also those that have strayed before.
TYPED_TEST(KernelStepOf, APointThatLeavesTheGridIsLost) {
  auto body = stirred_block<TypeParam>({.block = {.supported = false}}, 0.0);
  std::fill(body.points.velocity[0].begin(), body.points.velocity[0].end(), -3.0);
  KernelStep<TypeParam> step(body);
  const auto run = [&] {
    for (int k = 0; k < 200; ++k)
      advance(step, {});
  };
  EXPECT_THROW(run(), PointLost);
}

TYPED_TEST(KernelStepOf, StraysAreKeptApartUntilTheyAreTakenHome) {
  auto body = stirred_block<TypeParam>({.block = {.columns = 40, .rows = 30, .filled_rows = 29}}, 0.3);
  const double mass = total_mass(body.points);
  KernelStep<TypeParam> step(body);
  const auto sorts = body.cells.sorts;
  constexpr int long_enough = 200; // for the first points to cross
  for (int k = 0; k < long_enough && total_mass(body.points) > (1.0 - 1e-4) * mass; ++k)
    advance(step, ramped);
  EXPECT_EQ(body.cells.sorts, sorts); // few enough not to be sorted
  EXPECT_LT(total_mass(body.points), (1.0 - 1e-4) * mass);
  step.gather();
  EXPECT_EQ(body.cells.sorts, sorts + 1);
  EXPECT_NEAR(total_mass(body.points) / mass, 1.0, 1e-13);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    EXPECT_EQ(body.points.cell[p], body.space.locate(body.points.position_of(p)));
}

} // namespace
} // namespace settle::mpm::test
