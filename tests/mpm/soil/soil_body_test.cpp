// Bodies of soil from the case to the stages.
#include <cmath>

#include <gmock/gmock.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/mpm/solver.hpp"

namespace settle::mpm::test {
namespace {

using testing::HasSubstr;

/// A block of 1 m by 1 m between smooth walls, of one layer or two halves.
std::string block_text(const std::string& material, int layers = 1) {
  const std::string one = "[[geometry.polygon]]\ncorners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]\n";
  const std::string two = "[[geometry.polygon]]\ncorners = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [0.0, 0.5]]\n"
                          "[[geometry.polygon]]\nlayer = 2\nmaterial = 'upper'\n"
                          "corners = [[0.0, 0.5], [1.0, 0.5], [1.0, 1.0], [0.0, 1.0]]\n";
  return "format = 1\ngravity = 10.0\n[geometry]\nshape = 'polygons'\ndimension = 2\n" + (layers == 1 ? one : two) +
         material + "[construction]\nlayers = " + std::to_string(layers) + R"(
convention = "drop"
material = "fill"
[mpm]
element = "quadrilateral"
element_size = 0.25
[[support]]
from = [0.0, 1.0]
to = [0.0, 0.0]
held = "x"
[[support]]
from = [0.0, 0.0]
to = [1.0, 0.0]
held = "y"
[[support]]
from = [1.0, 0.0]
to = [1.0, 1.0]
held = "x"
)";
}

std::string material(const std::string& name, const std::string& law, double young, double poisson, double density) {
  return "[material." + name + "]\n" + law + "youngs_modulus = " + std::to_string(young) +
         "\npoissons_ratio = " + std::to_string(poisson) + "\ndensity = " + std::to_string(density) + "\n";
}

std::vector<exchange::Stage> stages_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::vector<exchange::Stage> stages;
  solve(exchange::parse_case(text, "block.toml", overrides), [&](const auto& stage) { stages.push_back(stage); });
  return stages;
}

/// Average of a component of the stress over the points of a layer [Pa].
double mean_stress(const exchange::Stage& stage, int layer, std::size_t component) {
  double sum = 0, volume = 0;
  for (std::size_t p = 0; p < stage.points.size(); ++p)
    if (stage.points.layer[p] == layer) {
      sum += stage.points.volume[p] * stage.points.stress[6 * p + component];
      volume += stage.points.volume[p];
    }
  return sum / volume;
}

double mean_settlement(const exchange::Stage& stage, int layer) {
  double sum = 0, n = 0;
  for (std::size_t p = 0; p < stage.points.size(); ++p)
    if (stage.points.layer[p] == layer) sum -= stage.points.displacement[2 * p + 1], n += 1;
  return sum / n;
}

TEST(LayersOfSoil, EveryLayerHasItsOwnDensityAndStiffness) {
  const std::string law = "law = 'rate'\n";
  const auto stages =
      stages_of(block_text(material("fill", law, 10e6, 0.0, 1500.0) + material("upper", law, 100e6, 0.0, 2000.0), 2));
  ASSERT_EQ(stages.size(), 2U);
  EXPECT_NEAR(stages[1].mass, 0.5 * 1500.0 + 0.5 * 2000.0, 1e-9 * 1750.0);
  EXPECT_NEAR(mean_stress(stages[1], 2, 1), -0.25 * 2000.0 * 10.0, 5e-3 * 5e3); // settled a little into cells below
  EXPECT_NEAR(mean_stress(stages[1], 1, 1), -(0.5 * 2000.0 + 0.25 * 1500.0) * 10.0, 5e-3 * 13.75e3);
  // The lower layer settles by 10 kPa of the upper one, on average half of it; the upper one besides by its own weight:
  // 5 kPa on average, integrated from its base, a third of 10 kPa x 0.5 m / 100 MPa.
  const double lower = mean_settlement(stages[1], 1) - mean_settlement(stages[0], 1);
  EXPECT_NEAR(lower, 0.5 * 10e3 * 0.5 / 10e6, 0.02 * 2.5e-4);
  EXPECT_NEAR(mean_settlement(stages[1], 2), 10e3 * 0.5 / 10e6 + 10e3 * 0.5 / 100e6 / 3.0, 0.02 * 5e-4);
}

const std::string sand = "law = 'mohr-coulomb'\ncohesion = 1.0\nfriction_angle = 30.0\n";

TEST(LayersOfSoil, SandBetweenWallsIsAtItsActiveStateInBothSchemesAndIntegrations) {
  const std::string text = block_text(material("fill", sand, 10e6, 0.2, 1800.0));
  for (const char* integration : {"mixed", "points"})
    for (const auto& scheme : {std::vector<std::string>{"mpm.scheme=quasi-static"},
                               {"mpm.scheme=explicit", "mpm.explicit.relaxation=viscous"}}) {
      std::vector<std::string> overrides = scheme;
      overrides.push_back(std::string("mpm.integration=") + integration);
      const auto stages = stages_of(text, overrides);
      const double vertical = mean_stress(stages[0], 1, 1);
      EXPECT_NEAR(vertical, -9e3, 0.01 * 9e3) << integration << scheme[0];
      // The cohesion takes 2 c sqrt(K_a) off.
      EXPECT_NEAR(mean_stress(stages[0], 1, 0), vertical / 3.0 + 2.0 / std::sqrt(3.0), 0.01 * 3e3) << scheme[0];
      EXPECT_GT(stages[0].points.plastic_strain[0], 0.0);
    }
}

TEST(LayersOfSoil, TheStateOfClayIsInTheResult) {
  const std::string clay = "law = 'cam-clay'\ncritical_state_slope = 1.2\ncompression_index = 0.02\n"
                           "swelling_index = 0.004\nvoid_ratio = 1.0\npreconsolidation_pressure = 6e3\n"
                           "attraction = 5e3\n";
  const auto stages = stages_of(block_text(material("fill", clay, 2e6, 0.3, 1800.0)));
  const exchange::SamplePoints& points = stages[0].points;
  ASSERT_EQ(points.preconsolidation_pressure.size(), points.size());
  ASSERT_EQ(points.plastic_strain.size(), points.size());
  double highest = 0, lowest = 1e9;
  for (const double pressure : points.preconsolidation_pressure)
    highest = std::max(highest, pressure), lowest = std::min(lowest, pressure);
  EXPECT_GE(lowest, 6e3);
  EXPECT_LT(lowest, 7e3);
  EXPECT_GT(highest, 10e3); // p + attraction at the base, under 18 kPa
  EXPECT_NEAR(mean_stress(stages[0], 1, 1), -9e3, 0.02 * 9e3);
}

/// Stress cannot follow gravity where the strength is nothing against it.
TEST(LayersOfSoil, WhatCannotStandSaysAtWhichStageAndShareItFails) {
  std::string text = block_text(material("fill", "law = 'tresca'\ncohesion = 1.0\n", 10e6, 0.4, 2000.0));
  text = text.substr(0, text.rfind("[[support]]")); // its right side is free
  try {
    stages_of(text);
    FAIL() << "stands";
  } catch (const exchange::NotConverged& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("stage 1"), HasSubstr("of it is carried")));
  }
}

TEST(LayersOfSoil, WhereACaseMayFailTheShareThatStoodIsHandedOver) {
  std::string text = block_text(material("fill", "law = 'tresca'\ncohesion = 100.0\n", 10e6, 0.4, 2000.0));
  text = text.substr(0, text.rfind("[[support]]"));
  std::vector<exchange::Stage> stages;
  const auto failure = solve(exchange::parse_case(text, "block.toml", {"construction.may_fail=true"}),
                             [&](const auto& stage) { stages.push_back(stage); });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->stage, 1);
  EXPECT_LT(failure->share, 0.5);
  EXPECT_EQ(stages.size(), failure->share > 0.0 ? 1U : 0U);
}

TEST(LayersOfSoil, WithoutMoreThanOneLawNothingIsKeptForSoils) {
  const auto stages = stages_of(block_text(material("fill", "law = 'rate'\n", 10e6, 0.2, 1800.0)));
  EXPECT_TRUE(stages[0].points.plastic_strain.empty());
  EXPECT_TRUE(stages[0].points.preconsolidation_pressure.empty());
}

} // namespace
} // namespace settle::mpm::test
