#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "drawn_bodies.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Convention;
using exchange::Kinematics;
using exchange::Stage;

class EmbankmentBy : public ::testing::TestWithParam<Convention> {
protected:
  [[nodiscard]] static EmbankmentOptions finite() {
    return {.kinematics = Kinematics::finite, .convention = GetParam()};
  }
};

/// Of the probes of a layer, from below: one component.
std::vector<double> of_layer(const Stage& stage, int layer, const std::vector<double>& vectors, std::size_t axis) {
  const exchange::ProbeSamples& probes = stage.probes.at("axis");
  std::vector<double> values;
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (probes.layer[i] == layer) values.push_back(vectors[2 * i + axis]);
  return values;
}

TEST_P(EmbankmentBy, LayersArePlacedOnTheSurfaceAsItHasSettled) {
  const std::vector<Stage> stages = solve(embankment(finite()));
  for (int layer = 2; layer <= 3; ++layer) {
    const Stage &before = stages[static_cast<std::size_t>(layer) - 2],
                &now = stages[static_cast<std::size_t>(layer) - 1];
    for (const std::size_t axis : {0U, 1U}) {
      const auto& probes = before.probes.at("axis");
      const double surface = of_layer(before, layer - 1, probes.placed_position, axis).back() +
                             of_layer(before, layer - 1, probes.displacement, axis).back();
      EXPECT_NEAR(of_layer(now, layer, now.probes.at("axis").placed_position, axis).front(), surface, 1e-12);
    }
    EXPECT_LT(of_layer(now, layer, now.probes.at("axis").placed_position, 1).front(), layer - 1.0 - 0.01);
  }
}

TEST_P(EmbankmentBy, LayersAreAsThickAsTheConventionSays) {
  const Stage stage = solve(embankment(finite())).back();
  const std::vector<double> third = of_layer(stage, 3, stage.probes.at("axis").placed_position, 1);
  if (GetParam() == Convention::level_up)
    EXPECT_NEAR(third.back(), 3.0, 1e-12);
  else
    EXPECT_NEAR(third.back() - third.front(), 1.0, 1e-12);
  const double halfway = third[third.size() / 2];
  EXPECT_NEAR(halfway, (third.front() + third.back()) / 2, 1e-12);
}

TEST_P(EmbankmentBy, TheBaseCarriesTheWeightAndMassAddsUp) {
  double mass = 0.0;
  for (const Stage& stage : solve(embankment(finite()))) {
    mass += stage.mass_placed;
    EXPECT_NEAR(stage.mass, mass, 1e-12 * mass);
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
    double of_points = 0.0;
    for (std::size_t i = 0; i < stage.points.size(); ++i)
      of_points += stage.points.density[i] * stage.points.volume[i];
    EXPECT_NEAR(of_points, mass, 1e-9 * mass);
  }
}

/// About 1, 0.1 and 0.01 % of strain.
TEST_P(EmbankmentBy, TendsToSmallStrainAsItGetsStiff) {
  double previous = 0.0;
  for (const char* modulus : {"4e6", "4e7", "4e8"}) {
    const std::vector<std::string> stiff{fmt::format("material.fill.youngs_modulus={}", modulus)};
    EmbankmentOptions options = finite();
    const Stage finite = solve(embankment(options, stiff)).back();
    options.kinematics = Kinematics::small;
    const Stage small = solve(embankment(options, stiff)).back();
    double difference = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < small.points.displacement.size(); ++i) {
      difference = std::max(difference, std::abs(finite.points.displacement[i] - small.points.displacement[i]));
      largest = std::max(largest, std::abs(small.points.displacement[i]));
    }
    if (previous > 0) {
      EXPECT_NEAR(previous / (difference / largest), 10.0, 1.5);
    }
    previous = difference / largest;
  }
  EXPECT_LT(previous, 1e-3);
}

TEST_P(EmbankmentBy, GroundThatDoesNotMoveChangesNothingAboveIt) {
  EmbankmentOptions options = finite();
  const Stage rigid = solve(embankment(options)).back();
  options.foundation_depth = 0.5;
  exchange::Case on_ground = embankment(options);
  on_ground.supports.push_back({.from = on_ground.supports[0].from, .to = on_ground.supports[0].to});
  on_ground.supports.back().from[1] = on_ground.supports.back().to[1] = 0.0; // its surface is held too
  const Stage held = solve(on_ground).back();
  for (int layer = 1; layer <= 3; ++layer)
    expect_close(of_layer(held, layer + 1, held.probes.at("axis").displacement, 1),
                 of_layer(rigid, layer, rigid.probes.at("axis").displacement, 1), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(All, EmbankmentBy, ::testing::Values(Convention::floating, Convention::level_up),
                         [](const auto& parameter) {
                           return parameter.param == Convention::floating ? "Floating" : "LevelUp";
                         });

/// What is as thick as designed, measured vertically, has the area designed but for the strain of the surface below.
TEST(EmbankmentByFloat, HasTheMassOfItsDesignButForTheStrainOfTheSurfaceBelow) {
  const std::vector<Stage> stages = solve(embankment({.kinematics = Kinematics::finite}));
  const double designed = 1720.0 * (2.0 + 3.5 / 2); // of the uppermost layer
  EXPECT_NEAR(stages[2].mass_placed, designed, 2e-3 * designed);
  EXPECT_GT(std::abs(stages[2].mass_placed - designed), 1e-6 * designed); // it is not placed as drawn
}

/// A drawn column of several layers is the column.
TEST(DrawnColumn, AtFiniteStrainIsTheColumn) {
  for (const Convention convention : {Convention::floating, Convention::level_up}) {
    exchange::Case drawn = drawn_column(5, 5.0);
    exchange::Case plain = column({.element_size = 0.25, .width = 0.5});
    for (exchange::Case* study : {&drawn, &plain}) {
      study->fem.kinematics = Kinematics::finite;
      study->fem.increments = 4;
      study->construction.convention = convention;
    }
    const std::vector<Stage> one = solve(drawn), other = solve(plain);
    for (std::size_t k = 0; k < 5; ++k) {
      expect_close(one[k].points.placed_position, other[k].points.placed_position, 1e-11 * 5.0);
      expect_close(one[k].points.displacement, other[k].points.displacement, 1e-11);
      expect_close(one[k].points.stress, other[k].points.stress, 1e-10 * 84e3);
    }
  }
}

} // namespace
} // namespace settle::fem::testing
