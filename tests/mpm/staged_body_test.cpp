// What stages do to bodies that are drawn: layers on settled ones, existing ground, excavation, loads.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_case.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "solved_body.hpp"

using namespace settle;
using namespace mpm::test;
using testing::HasSubstr;

namespace {

/// Upwards [N/m], of all supports.
double vertical_reaction(const exchange::Stage& stage) {
  double sum = 0;
  for (std::size_t i = 1; i < stage.support_reactions.size(); i += 2)
    sum += stage.support_reactions[i];
  return sum;
}

double horizontal_reaction(const exchange::Stage& stage) {
  double sum = 0;
  for (std::size_t i = 0; i < stage.support_reactions.size(); i += 2)
    sum += stage.support_reactions[i];
  return sum;
}

INSTANTIATE_TEST_SUITE_P(Mpm, BothSchemes,
                         testing::Values(SchemeOfTest{"quasi-static", 1e-7}, SchemeOfTest{"explicit", 1e-4}),
                         [](const auto& parameter) { return parameter.param.name.substr(0, 5); });

} // namespace

TEST_P(BothSchemes, NoMassIsLostAndTheBaseCarriesWhatIsThere) {
  Overrides overrides = scheme();
  for (const std::string convention : {"drop", "float", "level-up"}) {
    overrides.push_back("construction.convention=" + convention);
    const auto stages = stages_of(embankment(
        stage("place", 1) + hold + stage("place", 2) + surface_load("[0.0, -2e3]", "[0.5, 1.0]", "[-0.5, 1.0]") + hold +
            "[[stage]]\naction = \"load\"\nfrom = [0.5, 1.0]\nto = [-0.5, 1.0]\ntraction = [0.0, 2e3]\n",
        overrides));
    double before = 0;
    for (std::size_t i = 0; i < stages.size(); ++i) {
      const double load = i == 3 || i == 4 ? 2e3 : 0.0;
      EXPECT_NEAR(before + stages[i].mass_placed, stages[i].mass, 1e-12 * stages[i].mass);
      EXPECT_NEAR(stages[i].base_reaction, stages[i].weight + load, GetParam().balance * stages[i].weight);
      EXPECT_NEAR(vertical_reaction(stages[i]), stages[i].base_reaction, GetParam().balance * stages[i].weight);
      EXPECT_NEAR(horizontal_reaction(stages[i]), 0.0, GetParam().balance * stages[i].weight);
      EXPECT_TRUE(stages[i].in_equilibrium);
      before = stages[i].mass;
    }
    // the surface has settled by about a thousandth; `float` spreads a layer by less than that
    EXPECT_NEAR(before, density * 2.5, 2e-3 * before);
  }
}

/// Elastic: its weight was all that the layer did to the rest.
TEST_P(BothSchemes, ALayerBuiltAndRemovedLeavesTheStateBefore) {
  Overrides overrides = scheme();
  overrides.emplace_back("construction.convention=float");
  const auto stages = stages_of(embankment(stage("place", 1) + stage("place", 2) + stage("remove", 2), overrides));
  EXPECT_NEAR(stages[2].mass, stages[0].mass, 1e-12 * stages[0].mass);
  EXPECT_NEAR(stages[2].mass_placed, -stages[1].mass_placed, 1e-12 * stages[0].mass);
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight, GetParam().balance * stages[2].weight);
  const auto &before = stages[0].probes.at("axis"), &after = stages[2].probes.at("axis");
  std::vector<double> between = stages[1].probes.at("axis").displacement;
  between.resize(after.displacement.size()); // of the first layer
  EXPECT_GT(relative_difference(between, after.displacement), 0.2);
  EXPECT_LT(relative_difference(after.displacement, before.displacement), 1e-3);
  EXPECT_LT(relative_difference(after.stress, before.stress), 1e-3);
}

TEST_P(BothSchemes, GroundKeepsItsStressAndForgetsItsDisplacements) {
  const auto placed = stages_of(box(2, "", scheme()));
  const auto ground = stages_of(box(2, stage("ground", 1) + stage("ground", 2), scheme()));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(ground[i].points.position, ground[i].points.placed_position);
    EXPECT_EQ(*std::max_element(ground[i].points.displacement.begin(), ground[i].points.displacement.end()), 0.0);
    EXPECT_LT(relative_difference(ground[i].points.stress, placed[i].points.stress), 1e-12);
    EXPECT_NEAR(ground[i].base_reaction, ground[i].weight, GetParam().balance * ground[i].weight);
  }
}

/// The lateral stress is what the case says, and vertical stress the weight above: round-off of a start in equilibrium.
TEST_P(BothSchemes, LevelGroundStartsWithTheStressOfItsDepth) {
  const auto stages = stages_of(box(2, stage("ground", 1, "k0 = 0.7\n") + stage("ground", 2, "k0 = 0.4\n"), scheme()));
  const exchange::SamplePoints& points = stages[1].points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double vertical = -density * gravity * (1.0 - points.position[2 * p + 1]);
    EXPECT_NEAR(points.stress[6 * p + 1], vertical, 1e-8 * 1.7e4);
    EXPECT_NEAR(points.stress[6 * p], (points.layer[p] == 1 ? 0.7 : 0.4) * vertical, 1e-8 * 1.7e4);
    EXPECT_NEAR(points.stress[6 * p + 2], points.stress[6 * p], 1e-8 * 1.7e4);
  }
  EXPECT_NEAR(stages[1].base_reaction, stages[1].weight, GetParam().balance * stages[1].weight);
}

/// Along its whole surface: 10 kPa everywhere, and what the column yields under them.
TEST_P(BothSchemes, AUniformLoadIsFeltEverywhereAndStays) {
  Overrides overrides = scheme();
  overrides.emplace_back("material.fill.youngs_modulus=4e8"); // strains of 2e-5: small
  const auto stages =
      stages_of(box(2, stage("place", 1) + stage("place", 2) + surface_load("[0.0, -1e4]") + hold, overrides));
  const exchange::SamplePoints &before = stages[1].points, &after = stages[2].points;
  for (std::size_t p = 0; p < before.size(); ++p)
    EXPECT_NEAR(after.stress[6 * p + 1] - before.stress[6 * p + 1], -1e4, 0.02 * 1e4);
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight + 2e4, GetParam().balance * stages[2].weight);
  EXPECT_NEAR(stages[3].base_reaction, stages[2].base_reaction, GetParam().balance * stages[2].weight);
  // a hold finds the equilibrium of points where they have moved to: strains of 2e-5 away
  EXPECT_LT(relative_difference(stages[3].points.displacement, after.displacement), std::max(GetParam().balance, 2e-5));
  const double modulus = 4e8 * 0.75 / (1.25 * 0.5); // E (1 - nu)/((1 + nu)(1 - 2 nu))
  const auto &top_before = stages[1].probes.at("middle").displacement,
             &top = stages[2].probes.at("middle").displacement;
  EXPECT_NEAR(top.back() - top_before.back(), -1e4 / modulus, 0.01 * 1e4 / modulus);
}

/// Drag along the crest is carried by the rough base.
TEST_P(BothSchemes, SupportsCarryALoadAlongTheSurface) {
  const auto stages = stages_of(embankment(
      stage("place", 1) + stage("place", 2) + surface_load("[1e3, 0.0]", "[0.5, 1.0]", "[-0.5, 1.0]"), scheme()));
  EXPECT_NEAR(horizontal_reaction(stages[2]), -1e3, GetParam().balance * stages[2].weight);
  EXPECT_NEAR(vertical_reaction(stages[2]), stages[2].weight, GetParam().balance * stages[2].weight);
}

/// A rough base between smooth walls: the nodes in their corners belong to both.
TEST(StagedBody, TheForceAtASharedCornerCountsOnce) {
  const auto stages =
      stages_of(box(2, stage("place", 1) + stage("place", 2) + surface_load("[1e3, 0.0]"), {"support.1.held=both"}));
  EXPECT_NEAR(horizontal_reaction(stages[2]), -2e3, 1e-3);
}

/// Layers that span the walls are those of a column: two ways of placing them, one result.
TEST(StagedBody, LayersOnASettledSurfaceAreThoseOfAColumn) {
  for (const std::string convention : {"float", "level-up"}) {
    const Overrides overrides{"construction.convention=" + convention, "material.fill.youngs_modulus=4e5"};
    const auto drawn = stages_of(box(3, "", overrides));
    const auto column = stages_of(
        exchange::parse_case(head("[geometry]\nshape = \"column\"\ndimension = 2\nheight = 1.5\nwidth = 2.0\n") +
                                 "layers = 3\n[probes.middle]\npoints_per_layer = 3\n",
                             "column.toml", overrides));
    const auto &own = drawn.back().probes.at("middle"), &reference = column.back().probes.at("middle");
    EXPECT_EQ(own.design_position, reference.design_position);
    // a plane through points takes the surface for flat: second order of a layer's 0.5 m in its settlement
    EXPECT_LT(relative_difference(own.placed_position, reference.placed_position), 1e-4) << convention;
    EXPECT_LT(relative_difference(own.displacement, reference.displacement), 5e-3) << convention;
    EXPECT_NEAR(drawn.back().mass, column.back().mass, 2e-4 * column.back().mass) << convention;
  }
}

/// Elements one and two deep.
TEST_P(BothSchemes, AnExtrudedEmbankmentIsItsSection) {
  const std::string stages = stage("place", 1) + hold + stage("place", 2) + stage("remove", 2);
  for (const std::string convention : {"drop", "float", "level-up"})
    for (const double depth : {0.25, 0.5}) {
      Overrides overrides = scheme();
      overrides.push_back("construction.convention=" + convention);
      const auto section = stages_of(embankment(stages, overrides));
      overrides.insert(overrides.end(), {"geometry.dimension=3", "geometry.depth=" + std::to_string(depth),
                                         "mpm.element=hexahedron", "mpm.points_per_element=8"});
      const auto body = stages_of(embankment(stages, overrides));
      ASSERT_EQ(body.size(), section.size());
      for (std::size_t i = 0; i < body.size(); ++i)
        expect_section_of(body[i], section[i], depth, GetParam().balance);
    }
}

TEST(StagedBody, AnExtrudedEmbankmentIsItsSectionWithGimp) {
  Overrides overrides{"construction.convention=level-up", "mpm.basis=gimp"};
  const auto section = stages_of(embankment("", overrides));
  overrides.insert(overrides.end(), {"geometry.dimension=3", "geometry.depth=0.5", "mpm.element=hexahedron"});
  const auto body = stages_of(embankment("", overrides));
  ASSERT_EQ(body.size(), section.size());
  for (std::size_t i = 0; i < body.size(); ++i)
    expect_section_of(body[i], section[i], 0.5, 1e-7);
}

/// Not to the balance of forces: two points an element do not integrate the splines along y exactly.
TEST(StagedBody, AnExtrudedEmbankmentOfBSplinesIsNearItsSectionAndRests) {
  Overrides overrides{"construction.convention=level-up", "mpm.basis=b-spline"};
  const auto section = stages_of(embankment("", overrides));
  overrides.insert(overrides.end(), {"geometry.dimension=3", "geometry.depth=0.5", "mpm.element=hexahedron"});
  const auto body = stages_of(embankment("", overrides));
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_NEAR(body[i].base_reaction, body[i].weight, 1e-7 * body[i].weight);
    EXPECT_NEAR(body[i].mass, 0.5 * section[i].mass, 1e-5 * body[i].mass); // level-up fills a settlement of 1e-3
    const auto &own = body[i].probes.at("axis").displacement, &reference = section[i].probes.at("axis").displacement;
    std::vector<double> vertical, in_section;
    for (std::size_t p = 0; 3 * p < own.size(); ++p) {
      vertical.push_back(own[3 * p + 2]);
      in_section.push_back(reference[2 * p + 1]);
    }
    EXPECT_LT(relative_difference(vertical, in_section), 2e-3);
  }
}

TEST(StagedBody, ExtrudedGroundStartsWithTheStressOfItsDepth) {
  const auto stages = stages_of(box(2, stage("ground", 1, "k0 = 0.7\n") + stage("ground", 2, "k0 = 0.4\n"),
                                    {"geometry.dimension=3", "geometry.depth=0.5", "mpm.element=hexahedron"}));
  const exchange::SamplePoints& points = stages[1].points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double vertical = -density * gravity * (1.0 - points.position[3 * p + 2]);
    EXPECT_NEAR(points.stress[6 * p + 2], vertical, 1e-8 * 1.7e4);
    EXPECT_NEAR(points.stress[6 * p], (points.layer[p] == 1 ? 0.7 : 0.4) * vertical, 1e-8 * 1.7e4);
    EXPECT_NEAR(points.stress[6 * p + 1], points.stress[6 * p], 1e-8 * 1.7e4);
  }
  EXPECT_NEAR(stages[1].mass, density * 2.0 * 1.0 * 0.5, 1e-12 * stages[1].mass);
  EXPECT_NEAR(stages[1].base_reaction, stages[1].weight, 1e-7 * stages[1].weight);
}

TEST(StagedRequirements, AnExtrusionIsOfWholeHexahedra) {
  const Overrides solid{"geometry.dimension=3", "mpm.element=hexahedron", "geometry.depth=0.5"};
  const auto with = [&](const std::string& other) { return Overrides{solid[0], solid[1], solid[2], other}; };
  Overrides splines{solid};
  splines.insert(splines.end(), {"mpm.basis=b-spline", "mpm.scheme=explicit"});
  EXPECT_THAT(complaint_about(embankment("", splines)), HasSubstr("set mpm.integration = \"points\""));
  const std::string placed = stage("place", 1) + stage("place", 2);
  EXPECT_THAT(complaint_about(embankment(placed, with("geometry.depth=0.6"))), HasSubstr("set geometry.depth = 0.5"));
  EXPECT_THAT(complaint_about(embankment(placed, with("mpm.element=tetrahedron"))), HasSubstr("hexahedron"));
}

TEST(StagedBody, ALevelUpReachesTheDesignLevelAndAFloatStaysBelowItByTheSettlement) {
  const Overrides soft{"material.fill.youngs_modulus=4e5"};
  const auto lowest_top = [&](const std::string& convention) {
    Overrides overrides = soft;
    overrides.push_back("construction.convention=" + convention);
    const auto probes = stages_of(embankment("", overrides)).back().probes.at("axis");
    return std::pair(probes.placed_position[2 * probes.size() - 1], probes.displacement[2 * 2 + 1]);
  };
  EXPECT_NEAR(lowest_top("level-up").first, 1.0, 1e-6);
  const auto [top, settlement] = lowest_top("float"); // of the first layer's top, more by now than at placement
  EXPECT_LT(top, 1.0 - 1e-3);
  EXPECT_GT(top, 1.0 + settlement);
}

TEST(StagedRequirements, AStressOfLevelGroundIsForLevelGround) {
  const auto study = embankment(stage("ground", 1, "k0 = 0.5\n") + stage("place", 2));
  EXPECT_THAT(complaint_about(study), HasSubstr("layer 1, which is no upright rectangle"));
}

TEST(StagedRequirements, HyperelasticGroundCannotStartWithAStress) {
  const auto study = box(1, stage("ground", 1, "k0 = 0.5\n"), {"material.fill.law=hencky"});
  EXPECT_THAT(complaint_about(study), HasSubstr("use law = \"rate\", or leave k0 out"));
}

TEST(StagedRequirements, ALoadLiesOnTheSurfaceWithTheBodyToItsLeft) {
  const std::string placed = stage("place", 1) + stage("place", 2);
  for (const std::string& load : {surface_load("[0.0, -1.0]", "[0.0, 1.0]", "[2.0, 1.0]"),  // the other way
                                  surface_load("[0.0, -1.0]", "[2.0, 0.5]", "[0.0, 0.5]"),  // within
                                  surface_load("[0.0, -1.0]", "[3.0, 1.0]", "[0.0, 1.0]")}) // beyond an end
    EXPECT_THAT(complaint_about(box(2, placed + load)), HasSubstr("the load is not on the surface of what is there"));
}

TEST(StagedRequirements, ALayerWithALoadOnItStays) {
  const auto study = box(2, stage("place", 1) + stage("place", 2) + surface_load("[0.0, -1.0]") + stage("remove", 2));
  EXPECT_THAT(complaint_about(study), HasSubstr("layer 2 is taken away with a load on it"));
}

TEST(StagedRequirements, MotionsKnowLayersThatArePlacedOnly) {
  const auto study = box(1, stage("place", 1) + hold + "[motion]\ndisplacement = ['0', '0']\n");
  EXPECT_THAT(complaint_about(study), HasSubstr("formulas of a motion know stages that place layers only"));
}
