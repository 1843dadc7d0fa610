#include <cmath>

#include <gtest/gtest.h>

#include "drawn_bodies.hpp"

namespace settle::fem::testing {
namespace {

using exchange::FemElement;
using exchange::Kinematics;
using exchange::Stage;

constexpr double unit_weight = 1720.0 * 9.81;
const double modulus = FrozenColumn::oedometric_modulus(400e3, 0.25);
constexpr double lateral_ratio = 0.25 / 0.75; // nu / (1 - nu)

StageEntry place(int layer) {
  return {.action = Action::place, .layer = layer};
}
StageEntry ground(int layer, std::optional<double> k0 = {}) {
  return {.action = Action::ground, .layer = layer, .k0 = k0};
}
StageEntry remove_layer(int layer) {
  return {.action = Action::remove, .layer = layer};
}
StageEntry load(int layer, std::vector<double> from, std::vector<double> to, std::vector<double> traction) {
  return {.action = Action::load,
          .layer = layer,
          .from = std::move(from),
          .to = std::move(to),
          .traction = std::move(traction)};
}

/// Vertical displacement of all probes.
std::vector<double> heave(const Stage& stage) {
  const exchange::ProbeSamples& axis = stage.probes.at("axis");
  std::vector<double> values;
  for (std::size_t i = 0; i < axis.size(); ++i)
    values.push_back(vertical(axis.displacement, i, 2));
  return values;
}

void expect_same_stage(const Stage& a, const Stage& b, double tolerance) {
  EXPECT_EQ(a.points.id, b.points.id);
  expect_close(a.points.displacement, b.points.displacement, tolerance * 0.1); // m
  expect_close(a.points.stress, b.points.stress, tolerance * 3.0 * unit_weight);
  expect_close(a.points.density, b.points.density, tolerance * 1720.0);
  EXPECT_NEAR(a.base_reaction, b.base_reaction, tolerance * a.weight);
  EXPECT_EQ(a.mass, b.mass);
}

void expect_balance(const std::vector<Stage>& stages) {
  double mass = 0.0;
  for (const Stage& stage : stages) {
    mass += stage.mass_placed;
    EXPECT_NEAR(stage.mass, mass, 1e-12 * mass);
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
    EXPECT_TRUE(stage.in_equilibrium);
  }
}

// --- loads -----------------------------------------------------------------------------------------------------------

class LoadOnEveryElement : public ::testing::TestWithParam<FemElement> {};

TEST_P(LoadOnEveryElement, CompressesAColumnByItsHeightOverItsModulus) {
  exchange::Case study = drawn_column(2, 2.0, GetParam());
  study.fem.increments = 3;
  const double q = 30e3;
  study.stages.push_back(load(2, {0.5, 2.0}, {0.0, 2.0}, {0.0, -q}));
  study.stages.push_back({.action = Action::hold, .layer = 2});
  const std::vector<Stage> stages = solve(study);
  ASSERT_EQ(stages.size(), 4U);
  const exchange::ProbeSamples& axis = stages[2].probes.at("axis");
  for (std::size_t i = 0; i < axis.size(); ++i)
    EXPECT_NEAR(heave(stages[2])[i] - heave(stages[1])[i], -q * vertical(axis.design_position, i, 2) / modulus, 1e-12);
  for (std::size_t i = 0; i < stages[2].points.size(); ++i)
    EXPECT_NEAR(stages[2].points.stress[6 * i + 1] - stages[1].points.stress[6 * i + 1], -q, 1e-10 * q);
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight + q * 0.5, 1e-11 * stages[2].weight);
  EXPECT_EQ(stages[2].steps, 3);
  EXPECT_EQ(stages[2].mass_placed, 0.0);
  EXPECT_EQ(stages[3].steps, 1);
  expect_same_stage(stages[2], stages[3], 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, LoadOnEveryElement, ::testing::Values(FemElement::Q1, FemElement::Q2),
                         [](const auto& parameter) { return std::string(exchange::name_of(parameter.param)); });

/// The Hencky law in confined compression, J sigma = M ln J, under a dead load: the only one, without gravity.
TEST(Load, CompressesAFiniteColumnToTheStretchOfItsLaw) {
  exchange::Case study = drawn_column(1, 1.0);
  study.gravity = 0.0;
  study.fem.kinematics = Kinematics::finite;
  study.construction.convention = exchange::Convention::floating;
  study.fem.increments = 4;
  study.materials["fill"].law = exchange::Law::hencky;
  const double stretch = 0.7, q = -modulus * std::log(stretch) / stretch;
  study.stages.push_back(load(1, {0.5, 1.0}, {0.0, 1.0}, {0.0, -q}));
  const Stage stage = solve(study).back();
  EXPECT_NEAR(stage.surface_height, stretch, 1e-11);
  EXPECT_NEAR(stage.base_reaction, q * 0.5, 1e-10 * q);
}

/// Ends of the lines are no nodes.
TEST(Load, OnALineInPartsIsTheLoadOnTheWholeLine) {
  exchange::Case whole = embankment({}), parts = whole;
  whole.stages.push_back(load(3, {0.81, 3.0}, {-0.63, 3.0}, {4e3, -20e3}));
  parts.stages.push_back(load(3, {0.81, 3.0}, {0.13, 3.0}, {4e3, -20e3}));
  parts.stages.push_back(load(3, {-0.63, 3.0}, {0.13, 3.0}, {4e3, -20e3})); // the other way round
  const Stage one = solve(whole).back(), other = solve(parts).back();
  expect_same_stage(one, other, 1e-11);
  EXPECT_NEAR(one.base_reaction, one.weight + 20e3 * 1.44, 1e-10 * one.weight);
  EXPECT_NEAR(one.support_reactions[0], -4e3 * 1.44, 1e-10 * one.weight); // the only support
  EXPECT_NEAR(one.support_reactions[1], one.base_reaction, 1e-12 * one.weight);
}

TEST(Load, StaysUnderALayerThatIsPlacedOnItAndGoesWithTheLayerThatBearsIt) {
  exchange::Case study = drawn_column(3, 3.0);
  study.stages = {place(1), place(2),        load(2, {0.5, 2.0}, {0.0, 2.0}, {0.0, -1e4}),
                  place(3), remove_layer(3), remove_layer(2)};
  const std::vector<Stage> stages = solve(study);
  for (const std::size_t loaded : {2U, 3U, 4U})
    EXPECT_NEAR(stages[loaded].base_reaction, stages[loaded].weight + 5e3, 1e-10 * stages[loaded].weight);
  expect_same_stage(stages[5], stages[0], 1e-10);
}

// --- excavation ------------------------------------------------------------------------------------------------------

TEST(Removal, RelievesWhatIsBelowOfTheWeightOfTheLayer) {
  exchange::Case study = drawn_column(2, 2.0);
  study.stages = {ground(1), ground(2), remove_layer(2)};
  const std::vector<Stage> stages = solve(study);
  expect_balance(stages);
  const exchange::ProbeSamples& axis = stages.back().probes.at("axis");
  ASSERT_EQ(axis.size(), 5U); // of the first layer, which is all there is
  for (std::size_t i = 0; i < axis.size(); ++i)
    EXPECT_NEAR(heave(stages.back())[i], unit_weight * vertical(axis.design_position, i, 2) / modulus, 1e-12);
  EXPECT_NEAR(stages.back().mass_placed, -0.5 * stages[1].mass, 1e-12 * stages[1].mass);
  EXPECT_EQ(stages.back().surface_height, 1.0);
}

TEST(Removal, ReleasesItsForcesInProportionToItsIncrements) {
  exchange::Case study = embankment({});
  study.stages.push_back(remove_layer(3));
  const Stage at_once = solve(study).back();
  study.fem.increments = 5;
  const Stage in_steps = solve(study).back();
  EXPECT_EQ(in_steps.steps, 5);
  expect_same_stage(at_once, in_steps, 1e-10);
}

struct Elastic {
  Kinematics kinematics;
  exchange::Convention convention;
  const char* law;
};

class RemovalOfEveryElasticFill : public ::testing::TestWithParam<Elastic> {};

/// The lower layers never know: neither from what comes after them, nor from what was there and is gone.
TEST_P(RemovalOfEveryElasticFill, BringsBackTheStateBeforeWhichIsThatOfTheSmallerBody) {
  const auto [kinematics, convention, law] = GetParam();
  exchange::Case study = embankment({.kinematics = kinematics, .convention = convention, .law = law});
  study.stages.push_back(remove_layer(3));
  const std::vector<Stage> stages = solve(study);
  expect_balance(stages);
  expect_same_stage(stages[1], stages[3], 1e-8);
  study.stages.resize(2);
  expect_same_stage(solve(study).back(), stages[3], 1e-8);
}

INSTANTIATE_TEST_SUITE_P(All, RemovalOfEveryElasticFill,
                         ::testing::Values(Elastic{Kinematics::small, exchange::Convention::floating, "hencky"},
                                           Elastic{Kinematics::finite, exchange::Convention::floating, "hencky"},
                                           Elastic{Kinematics::finite, exchange::Convention::level_up, "neo-hookean"}),
                         [](const auto& parameter) {
                           return fmt::format("{}{}", exchange::name_of(parameter.param.kinematics), parameter.index);
                         });

// --- existing ground -------------------------------------------------------------------------------------------------

TEST(Ground, HasTheStressOfItsWeightAndNoDisplacement) {
  exchange::Case study = drawn_column(2, 2.0);
  study.stages = {ground(1), place(2)};
  const std::vector<Stage> stages = solve(study);
  expect_balance(stages);
  for (const double displacement : stages[0].points.displacement)
    EXPECT_EQ(displacement, 0.0);
  const exchange::ProbeSamples& axis = stages[0].probes.at("axis");
  for (std::size_t i = 0; i < axis.size(); ++i)
    EXPECT_NEAR(axis.stress[6 * i + 1], -unit_weight * (1.0 - vertical(axis.design_position, i, 2)),
                1e-10 * unit_weight);
  const exchange::ProbeSamples& later = stages[1].probes.at("axis");
  for (std::size_t i = 0; i < 5; ++i) // counted from the state of rest: the weight of the second layer alone
    EXPECT_NEAR(heave(stages[1])[i], -unit_weight * vertical(later.design_position, i, 2) / modulus, 1e-12);
}

TEST(Ground, AtFiniteStrainStandsWhereItCameToRest) {
  exchange::Case study = drawn_column(2, 2.0);
  study.fem.kinematics = Kinematics::finite;
  study.construction.convention = exchange::Convention::floating;
  study.materials["fill"].law = exchange::Law::hencky;
  const std::vector<Stage> placed = solve(study);
  study.stages[0].action = Action::ground;
  const std::vector<Stage> stages = solve(study);
  for (std::size_t k = 0; k < 2; ++k) {
    expect_close(stages[k].points.position, placed[k].points.position, 1e-12);
    expect_close(stages[k].points.stress, placed[k].points.stress, 1e-12 * unit_weight);
    expect_close(stages[k].points.density, placed[k].points.density, 1e-12 * 1720.0);
    EXPECT_NEAR(stages[k].surface_height, placed[k].surface_height, 1e-12);
  }
  EXPECT_LT(stages[0].surface_height, 0.99);
  EXPECT_EQ(stages[0].points.placed_position, stages[0].points.position);
}

class GroundWithK0 : public ::testing::TestWithParam<Kinematics> {};

/// Two strata of their own ratios, the lower loaded by the upper.
TEST_P(GroundWithK0, StartsWithTheStressOfItsOverburdenAndDoesNotMove) {
  exchange::Case study = drawn_column(2, 2.0);
  study.fem.kinematics = GetParam();
  study.construction.convention = exchange::Convention::floating;
  study.stages = {ground(1, 0.8), ground(2, 0.4)};
  const std::vector<Stage> stages = solve(study);
  expect_balance(stages);
  for (const Stage& stage : stages) {
    const double surface = stage.surface_height;
    EXPECT_NEAR(surface, stage.layer, 1e-12);
    for (std::size_t i = 0; i < stage.points.size(); ++i) {
      const double vertical_stress = -unit_weight * (surface - stage.points.position[2 * i + 1]);
      const double k0 = stage.points.layer[i] == 1 ? 0.8 : 0.4;
      EXPECT_NEAR(stage.points.stress[6 * i + 1], vertical_stress, 1e-10 * unit_weight);
      EXPECT_NEAR(stage.points.stress[6 * i], k0 * vertical_stress, 1e-10 * unit_weight);
      EXPECT_NEAR(stage.points.stress[6 * i + 2], k0 * vertical_stress, 1e-10 * unit_weight);
    }
    for (const double height : stage.points.position)
      EXPECT_GE(height, 0.0);
  }
  expect_close(stages[1].points.position, stages[1].points.placed_position, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, GroundWithK0, ::testing::Values(Kinematics::small, Kinematics::finite),
                         [](const auto& parameter) { return std::string(exchange::name_of(parameter.param)); });

TEST(Ground, OfASectionInSpaceStartsWithTheStressOfItsOverburden) {
  exchange::Case study = drawn_column(2, 2.0);
  study.geometry.dimension = 3;
  study.geometry.depth = 1.0;
  study.stages = {ground(1, 0.8), ground(2, 0.4)};
  const Stage stage = solve(study).back();
  for (std::size_t i = 0; i < stage.points.size(); ++i) {
    const double upward = -unit_weight * (2.0 - stage.points.position[3 * i + 2]);
    for (const std::size_t across : {0U, 1U})
      EXPECT_NEAR(stage.points.stress[6 * i + across], (stage.points.layer[i] == 1 ? 0.8 : 0.4) * upward,
                  1e-10 * unit_weight);
    EXPECT_NEAR(stage.points.stress[6 * i + 2], upward, 1e-10 * unit_weight);
  }
  expect_close(stage.points.position, stage.points.placed_position, 1e-12);
}

TEST(Ground, UnderAnEmbankmentIsItsFirstLayerWithoutBeingToldSo) {
  const std::vector<Stage> stages = solve(embankment({.foundation_depth = 2.0}));
  ASSERT_EQ(stages.size(), 4U);
  expect_balance(stages);
  for (const double displacement : stages[0].points.displacement)
    EXPECT_EQ(displacement, 0.0);
  const double area = 2.0 * (2.0 + 3.0 + 2.0 + 3.0 * 3.5);
  EXPECT_NEAR(stages[0].mass, 1720.0 * area, 1e-11 * stages[0].mass);
}

// --- supports --------------------------------------------------------------------------------------------------------

TEST(SupportReactions, AreTheWeightOnTheBaseAndTheThrustOnTheSides) {
  const Stage stage = solve(drawn_column(2, 2.0)).back();
  const double thrust = lateral_ratio * unit_weight * 2.0 * 2.0 / 2.0;
  const std::vector<double> expected{0.0, unit_weight * 2.0 * 0.5, -thrust, 0.0, thrust, 0.0};
  expect_close(stage.support_reactions, expected, 1e-10 * stage.weight);
}

TEST(SupportReactions, AreNotKnownOfAColumnWhoseSupportsHaveNoName) {
  EXPECT_TRUE(
      solve(column({.layers = 1, .element_size = 0.5, .width = 0.5, .height = 1.0})).back().support_reactions.empty());
}

} // namespace
} // namespace settle::fem::testing
