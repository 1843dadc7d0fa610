// Averages of stress over a cell's points.

#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/quasi_static_step.hpp"

namespace settle::mpm::test {
namespace {

Body<TriangleSpace> stressed_block() {
  std::mt19937 random(31);
  auto body = block();
  scatter_positions(body, random, 0.2);
  randomize_stresses(body, random);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  for (double& volume : body.points.volume)
    volume *= share(random);
  return body;
}

/// Integral of a stress component over the points' volumes.
double integral(const Points<2>& points, std::size_t component) {
  double sum = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    sum += points.volume[p] * points.stress[component][p];
  return sum;
}

TEST(CellAverage, GivesEveryPointOfACellTheSameStressAndKeepsItsIntegral) {
  auto body = stressed_block();
  const auto before = body.points;
  replace_stress_by_cell_average(body);
  for (std::size_t component = 0; component < 4; ++component) {
    EXPECT_NEAR(integral(body.points, component), integral(before, component), 1e-9);
    for (std::size_t p = 1; p < body.points.size(); ++p)
      if (body.points.cell[p] == body.points.cell[p - 1]) {
        EXPECT_EQ(body.points.stress[component][p], body.points.stress[component][p - 1]);
      }
  }
}

TEST(CellAverage, TakenTwiceIsTheSame) {
  auto body = stressed_block();
  replace_stress_by_cell_average(body);
  const auto once = body.points.stress;
  replace_stress_by_cell_average(body);
  for (std::size_t component = 0; component < 4; ++component)
    for (std::size_t p = 0; p < body.points.size(); ++p)
      EXPECT_NEAR(body.points.stress[component][p], once[component][p], 1e-9);
}

TEST(CellAverage, ActsOverTheFullCellOrOverThePointsVolume) {
  auto body = block();
  EXPECT_EQ(integration_volume(body, 0.01), body.space.cell_volume());
  body.integration = StressIntegration::points;
  EXPECT_EQ(integration_volume(body, 0.01), 0.01);
}

/// Do all points of every cell have one vertical stress?
bool is_uniform_in_cells(const Points<2>& points) {
  for (std::size_t p = 1; p < points.size(); ++p)
    if (points.cell[p] == points.cell[p - 1] && points.stress[1][p] != points.stress[1][p - 1]) return false;
  return true;
}

TEST(CellAverage, IsTakenAfterEveryQuasiStaticIncrementIfTheBodyAsksForIt) {
  for (const bool asked : {true, false}) {
    auto body = stressed_block();
    body.average_stress = asked;
    ASSERT_TRUE(QuasiStaticStep<TriangleSpace>(1e-9).advance(body, {}).converged);
    EXPECT_EQ(is_uniform_in_cells(body.points), asked);
  }
}

TEST(CellAverage, IsTakenAfterEveryExplicitStepIfTheBodyAsksForIt) {
  for (const bool asked : {true, false}) {
    auto body = stressed_block();
    body.average_stress = asked;
    ExplicitStep<TriangleSpace> step(body);
    step.scatter({});
    step.accelerate(0.75);
    step.displace(1e-3, 1e-3);
    step.move();
    step.gather();
    EXPECT_EQ(is_uniform_in_cells(body.points), asked);
  }
}

TEST(Supports, AreRollersOnBothSidesAndTheBase) {
  const TriangleSpace grid({.counts = {3, 4}, .size = 0.5});
  const auto fixed = oedometer_supports(grid);
  for (int n = 0; n < grid.n_nodes(); ++n) {
    const auto x = grid.node_position(n);
    EXPECT_EQ(fixed[static_cast<std::size_t>(n)][0], x[0] < 0.1 || x[0] > 1.4) << x.transpose();
    EXPECT_EQ(fixed[static_cast<std::size_t>(n)][1], x[1] < 0.1) << x.transpose();
  }
}

} // namespace
} // namespace settle::mpm::test
