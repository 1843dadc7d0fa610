// A cut that is built until it fails, by the explicit scheme, and what becomes of it.
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {
namespace {

using testing::HasSubstr;

constexpr double gravity = 10.0;

/// Half a fill with a vertical face at x = 5 m, in a layer of 3 m and six of 0.5 m; x = 0 is its middle. It stands up
/// to 3.776 c/(rho g) = 4.196 m with the cohesion of 20 kPa.
std::string cut_text() {
  std::string layers;
  for (int layer = 1; layer <= 7; ++layer) {
    const double lower = layer == 1 ? 0.0 : 2.0 + 0.5 * layer, upper = 2.5 + 0.5 * layer;
    layers += fmt::format("  {{ layer = {0}, corners = [[0.0, {1}], [5.0, {1}], [5.0, {2}], [0.0, {2}]] }},\n", layer,
                          lower, upper);
  }
  return "format = 1\ngravity = 10.0\n[geometry]\nshape = 'polygons'\ndimension = 2\npolygon = [\n" + layers + R"(]
[[support]]
from = [0.0, 7.0]
to = [0.0, 0.0]
held = "x"
[[support]]
from = [0.0, 0.0]
to = [12.0, 0.0]
held = "both"
[material.clay]
law = "tresca"
cohesion = 20e3
youngs_modulus = 5e6
poissons_ratio = 0.45
density = 1800.0
[construction]
layers = 7
convention = "drop"
material = "clay"
may_fail = true
[mpm]
element = "quadrilateral"
element_size = 0.5
scheme = "explicit"
jaumann = true
[mpm.explicit]
damping = 0.2
ramp_time = 2.0
failure_displacement = 0.01
)";
}

struct Outcome {
  exchange::Case study;
  std::vector<exchange::Stage> stages;
  std::optional<exchange::Failure> failure;
};

Outcome outcome_of(const std::vector<std::string>& overrides = {}) {
  Outcome outcome{exchange::parse_case(cut_text(), "cut.toml", overrides), {}, {}};
  outcome.failure = solve(outcome.study, [&](const auto& stage) { outcome.stages.push_back(stage); });
  return outcome;
}

/// Height of every point by its number, as the stage has left it, or as placed where it was not there [m].
double height_before(const exchange::Stage& stage, const exchange::SamplePoints& now, std::size_t p) {
  for (std::size_t q = 0; q < stage.points.size(); ++q)
    if (stage.points.id[q] == now.id[p]) return stage.points.position[2 * q + 1];
  return now.placed_position[2 * p + 1];
}

class RunOut : public testing::Test {
protected:
  static const Outcome& outcome() {
    static const Outcome once = outcome_of();
    return once;
  }
  static const exchange::RunOut& run_out() { return *outcome().failure->run_out; }

  void SetUp() override {
    ASSERT_TRUE(outcome().failure);
    ASSERT_TRUE(outcome().failure->run_out);
  }
};

/// Layers of 0.5 m and elements as large: 12 % of the height each.
TEST_F(RunOut, BeginsWhereTheFillWasInEquilibriumLast) {
  const exchange::Failure& failure = *outcome().failure;
  const double height = exchange::fill_height(outcome().study, failure.stage, failure.share);
  EXPECT_NEAR(height, 3.776 * 20e3 / (1800.0 * gravity), 0.12 * 4.196);
  EXPECT_EQ(outcome().stages.size(), static_cast<std::size_t>(failure.share > 0.0 ? failure.stage : failure.stage - 1));
  for (const exchange::Stage& stage : outcome().stages)
    EXPECT_TRUE(stage.in_equilibrium);
}

TEST_F(RunOut, LosesNothing) {
  EXPECT_EQ(run_out().state.mass, run_out().mass_before);
  EXPECT_EQ(run_out().state.points.size(), static_cast<std::size_t>(run_out().points_before));
  double mass = 0;
  for (std::size_t p = 0; p < run_out().state.points.size(); ++p)
    mass += run_out().state.points.density[p] * run_out().state.points.volume[p];
  EXPECT_NEAR(mass, run_out().mass_before, 1e-12 * mass);
}

TEST_F(RunOut, ComesToRestBeyondTheToeWithItsWeightOnTheBase) {
  EXPECT_TRUE(run_out().at_rest);
  EXPECT_GT(run_out().distance, 0.1);
  EXPECT_GT(run_out().largest_displacement, run_out().distance);
  EXPECT_NEAR(run_out().state.weight, gravity * run_out().mass_before, 1e-9 * run_out().state.weight);
  EXPECT_NEAR(run_out().state.base_reaction, run_out().state.weight, 1e-3 * run_out().state.weight);
}

/// The work at the nodes against the way of the points' weights.
TEST_F(RunOut, HasTheWorkOfGravityOfItsPointsWay) {
  const exchange::SamplePoints& now = run_out().state.points;
  double work = 0;
  for (std::size_t p = 0; p < now.size(); ++p)
    work += gravity * now.density[p] * now.volume[p] *
            (height_before(outcome().stages.back(), now, p) - now.position[2 * p + 1]);
  ASSERT_EQ(outcome().failure->share, 0.0) << "else the way begins with a state in which part of the layer has settled";
  EXPECT_NEAR(run_out().external_work, work, 1e-9 * work);
}

/// 0.06 % are left, 4 % where the stress work is that of the forces before each step.
TEST_F(RunOut, AccountsForTheWorkOfGravity) {
  EXPECT_GT(run_out().stress_work, 0.9 * run_out().external_work);
  EXPECT_GT(run_out().damping_loss, 0.0);
  EXPECT_LT(std::abs(run_out().unaccounted()), 2e-3 * run_out().external_work);
}

TEST(CutThatMayFail, StandsWhereItIsStrongEnough) {
  const Outcome outcome = outcome_of({"material.clay.cohesion=40e3"});
  EXPECT_FALSE(outcome.failure);
  ASSERT_EQ(outcome.stages.size(), 7U);
  EXPECT_TRUE(outcome.stages.back().in_equilibrium);
}

TEST(CutThatMayFail, SaysThatItIsNotAtRestWhereTimeIsOver) {
  const Outcome outcome = outcome_of({"mpm.explicit.max_hold_time=3.0"});
  ASSERT_TRUE(outcome.failure && outcome.failure->run_out);
  EXPECT_FALSE(outcome.failure->run_out->at_rest);
  EXPECT_FALSE(outcome.failure->run_out->state.in_equilibrium);
  EXPECT_NEAR(outcome.failure->run_out->duration, 3.0, 1e-12);
}

TEST(CutThatMayFail, WithNeitherEquilibriumNorFailureSaysHowFarItCame) {
  try {
    outcome_of({"mpm.explicit.max_hold_time=3.0", "mpm.explicit.failure_displacement=0.9"});
    FAIL() << "stands";
  } catch (const exchange::NotConverged& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("neither equilibrium nor failure within"), HasSubstr("stage 4"),
                                             HasSubstr("or a point that moves by 5.4 m")));
  }
}

} // namespace
} // namespace settle::mpm::test
