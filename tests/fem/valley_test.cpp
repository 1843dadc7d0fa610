#include <cmath>

#include <gtest/gtest.h>

#include "dams.hpp"
#include "frozen_column.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Convention;
using exchange::Kinematics;
using exchange::Stage;

/// The displacements of point i and of the one as far from the other end are the same, one component turned round.
void expect_mirrored(const exchange::ProbeSamples& line, std::size_t turned, double tolerance) {
  const std::size_t n = line.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double mirrored = (c == turned ? -1.0 : 1.0) * line.displacement[3 * (n - 1 - i) + c];
      EXPECT_NEAR(line.displacement[3 * i + c], mirrored, tolerance);
    }
}

class DamInAValley : public ::testing::TestWithParam<Kinematics> {};

TEST_P(DamInAValley, RestsOnFloorAndFlanksWithItsWholeWeight) {
  const exchange::Case study = dam({.kinematics = GetParam()});
  const std::vector<Stage> stages = solve(study);
  ASSERT_EQ(stages.size(), 3U);
  double design = 0.0;
  for (const Stage& stage : stages) {
    design += study.fill().density * exchange::layer_volume(study.geometry, stage.layer);
    EXPECT_NEAR(stage.mass, design, (GetParam() == Kinematics::small ? 1e-12 : 1e-2) * design);
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
    EXPECT_NEAR(stage.support_reactions.at(2), stage.weight, 1e-9 * stage.weight);
    EXPECT_NEAR(stage.support_reactions.at(0), 0.0, 1e-9 * stage.weight);
    EXPECT_NEAR(stage.support_reactions.at(1), 0.0, 1e-9 * stage.weight);
  }
}

TEST_P(DamInAValley, IsSymmetricWhereItsDesignIs) {
  const Stage stage = solve(dam({.kinematics = GetParam()})).back();
  const double tolerance = 1e-9 * std::abs(vertical(stage.probes.at("across").displacement, 6, 3));
  expect_mirrored(stage.probes.at("across"), 1, tolerance);
  expect_mirrored(stage.probes.at("along"), 0, tolerance);
}

INSTANTIATE_TEST_SUITE_P(All, DamInAValley, ::testing::Values(Kinematics::small, Kinematics::finite),
                         [](const auto& parameter) { return std::string(exchange::name_of(parameter.param)); });

/// What has settled below is made up for: the crest is level again, and so much heavier.
TEST(DamInAValleyAtFiniteStrain, IsBuiltUpToItsLevelWhereItIsToBe) {
  const exchange::Case study = dam({.kinematics = Kinematics::finite, .convention = Convention::level_up});
  const std::vector<Stage> level = solve(study);
  const std::vector<Stage> floating = solve(dam({.kinematics = Kinematics::finite}));
  const double design = study.fill().density * exchange::layer_volume(study.geometry, 3);
  const auto& placed = level.back().probes.at("axis").placed_position;
  EXPECT_NEAR(placed.back(), 3.0, 1e-12);
  EXPECT_LT(floating.back().probes.at("axis").placed_position.back(), 2.95);
  EXPECT_GT(level.back().mass_placed, 1.015 * design);
  EXPECT_NEAR(floating.back().mass_placed, design, 0.005 * design);
  for (const Stage& stage : level)
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
}

/// Far from vertical flanks it is in plane strain. The meshes differ.
TEST(WideDam, IsItsSectionInTheMiddle) {
  const exchange::Case wide =
      dam({.element_size = 1.0}, {"geometry.valley={ bottom = 18.0, slopes = [0.0, 0.0] }", "fem.element=Q2"});
  exchange::Case extruded = wide;
  extruded.geometry.valley.reset();
  extruded.geometry.depth = 1.0;
  extruded.probes = {{"axis", {.from = {0.0, 0.0}, .to = {0.0, 3.0}, .points = 13}}};
  const auto body = solve(wide).back().probes.at("axis"), section = solve(extruded).back().probes.at("axis");
  ASSERT_EQ(body.size(), section.size());
  const double largest = 0.1; // m
  for (std::size_t i = 0; i < body.size(); ++i)
    EXPECT_NEAR(vertical(body.displacement, i, 3), vertical(section.displacement, i, 3), 0.003 * largest);
}

TEST(DamWithoutItsLastLayer, IsWhatItWasBefore) {
  exchange::Case study = dam();
  study.stages.push_back({.action = exchange::Action::remove, .layer = 3});
  const std::vector<Stage> stages = solve(study);
  const auto &after = stages.at(3).probes.at("axis"), &before = stages.at(1).probes.at("axis");
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.displacement.size(); ++i)
    EXPECT_NEAR(after.displacement[i], before.displacement[i], 1e-12);
}

} // namespace
} // namespace settle::fem::testing
