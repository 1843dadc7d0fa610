// Polygons, supports that follow a motion, body forces: whole cases through `solve`, against their own formulas.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/mpm/solver.hpp"

using namespace settle;
using testing::HasSubstr;

namespace {

/// A square of 1 m, what is left of its tables to be given.
std::string square(const std::string& rest, const std::string& gravity = "0.0") {
  return "format = 1\ngravity = " + gravity + R"(
[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
[material.block]
law = "neo-hookean"
youngs_modulus = 1e6
poissons_ratio = 0.3
density = 1000.0
[construction]
layers = 1
convention = "drop"
material = "block"
[mpm]
element = "quadrilateral"
element_size = 0.25
)" + rest;
}

std::string side(const std::string& from, const std::string& to, const std::string& rest) {
  return "[[support]]\nfrom = " + from + "\nto = " + to + "\n" + rest + "\n";
}

/// All four sides of the square, held the same way.
std::string all_sides(const std::string& rest) {
  return side("[0.0, 0.0]", "[1.0, 0.0]", rest) + side("[1.0, 0.0]", "[1.0, 1.0]", rest) +
         side("[1.0, 1.0]", "[0.0, 1.0]", rest) + side("[0.0, 1.0]", "[0.0, 0.0]", rest);
}

/// The oedometer.
const std::string rollers = side("[0.0, 1.0]", "[0.0, 0.0]", "held = 'x'") +
                            side("[0.0, 0.0]", "[1.0, 0.0]", "held = 'y'") +
                            side("[1.0, 0.0]", "[1.0, 1.0]", "held = 'x'");

std::vector<exchange::Stage> stages_of(const exchange::Case& study) {
  std::vector<exchange::Stage> stages;
  mpm::solve(study, [&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

/// Largest difference of the points' displacement from the case's formulas at the end of the last stage [m].
double largest_error(const exchange::Case& study) {
  const auto stages = stages_of(study);
  const exchange::SamplePoints& points = stages.back().points;
  const exchange::Formulas formulas(study);
  double largest = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto exact = formulas.displacement({.x = points.placed_position[2 * p],
                                              .y = points.placed_position[2 * p + 1],
                                              .time = study.motion->duration.value_or(0.0),
                                              .layer = points.layer[p],
                                              .stage = static_cast<int>(stages.size())});
    for (std::size_t d = 0; d < 2; ++d)
      largest = std::max(largest, std::abs(points.displacement[2 * p + d] - exact[d]));
  }
  return largest;
}

std::string complaint_about(const exchange::Case& study) {
  try {
    mpm::solve(study, [](const exchange::Stage&) {});
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return {};
}

class BothIntegrations : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Mpm, BothIntegrations, testing::Values("mixed", "points"),
                         [](const auto& parameter) { return parameter.param; });

} // namespace

/// Supports move with the increments in space, so a linear field of the placed position is exact where it is small:
/// what is left is its square, 1e-12 of lengths of 1 m.
TEST_P(BothIntegrations, ALinearMotionOfAllSidesIsReproducedInside) {
  const auto study = exchange::parse_case(
      square(all_sides("motion = 'exact'") + "[motion]\ndisplacement = ['1e-6 * (2 * X + Y)', '1e-6 * (X - 3 * Y)']\n"),
      "patch.toml", {"mpm.integration=" + GetParam()});
  EXPECT_LT(largest_error(study), 2e-11);
}

/// Each stage turns what is placed by the same small angle, so a layer has turned once for every stage it has seen.
TEST_P(BothIntegrations, SupportsOfLayersMoveAStageByWhatTheirMotionGrowsInIt) {
  const auto study = exchange::parse_case(square(all_sides("motion = 'exact'") +
                                                 "[motion]\nlet = ['angle = 1e-6 * (stage - layer + 1)']\n"
                                                 "displacement = ['-angle * Y', 'angle * X']\n"),
                                          "turn.toml",
                                          {"mpm.integration=" + GetParam(), "construction.layers=2",
                                           "geometry.polygon=[{corners=[[0.0,0.0],[1.0,0.0],[1.0,0.5],[0.0,0.5]]},"
                                           "{layer=2,corners=[[0.0,0.5],[1.0,0.5],[1.0,1.0],[0.0,1.0]]}]"});
  EXPECT_LT(largest_error(study), 2e-11);
}

/// A free bar in uniform motion keeps its velocity to round-off, across cells and whatever the step.
TEST_P(BothIntegrations, AUniformVelocityIsKept) {
  const auto study = exchange::parse_case(
      square(side("[0.0, 0.0]", "[1.0, 0.0]", "held = 'y'") +
             "[motion]\ndisplacement = ['3 * t', '0']\nvelocity = ['3', '0']\nduration = 0.05\n"),
      "flight.toml", {"mpm.integration=" + GetParam(), "mpm.scheme=explicit", "mpm.explicit.damping=0"});
  EXPECT_LT(largest_error(study), 1e-12);
}

/// A body force that is the same everywhere is gravity: u = b t^2 / 2, exact for velocities of half steps.
TEST(PolygonMotion, AUniformBodyForceGivesTheParabolaOfFreeFallExactly) {
  const auto study = exchange::parse_case(
      square(side("[0.0, 0.0]", "[1.0, 0.0]", "held = 'y'") +
             "[motion]\ndisplacement = ['2 * t^2 / 2', '0']\nbody_force = ['2', '0']\nduration = 0.2\n"),
      "fall.toml", {"mpm.scheme=explicit", "mpm.explicit.damping=0"});
  EXPECT_LT(largest_error(study), 1e-12);
}

/// Self-weight between rollers: the column's small-strain settlement, by gravity or by a body force that replaces it.
TEST(PolygonMotion, ABodyForceIsRampedLikeGravity) {
  const auto by_gravity = stages_of(exchange::parse_case(square(rollers, "10.0"), "g.toml"));
  const auto by_force = stages_of(exchange::parse_case(
      square(rollers + "[motion]\ndisplacement = ['0', '0']\nbody_force = ['0', '-10']\n"), "b.toml"));
  ASSERT_EQ(by_gravity.back().points.size(), by_force.back().points.size());
  for (std::size_t i = 0; i < by_gravity.back().points.displacement.size(); ++i)
    EXPECT_NEAR(by_force.back().points.displacement[i], by_gravity.back().points.displacement[i], 1e-15);
  EXPECT_NEAR(by_gravity.back().base_reaction, 1e4, 1e-4);
}

/// Body force less acceleration is gravity: the same state but for the path to it, strains of 5e-5 in one step or
/// twenty.
TEST(PolygonMotion, TheQuasiStaticSchemeTakesTheAccelerationOffTheBodyForce) {
  const std::string stiff = "material.block.youngs_modulus=1e8";
  const auto by_gravity = stages_of(exchange::parse_case(square(rollers, "10.0"), "g.toml", {stiff}));
  const auto by_force = stages_of(exchange::parse_case(
      square(rollers + "[motion]\ndisplacement = ['0', '0']\nbody_force = ['7 * X', '2 + Y - 10']\n"
                       "acceleration = ['7 * X', '2 + Y']\nduration = 1.0\n"),
      "b.toml", {stiff}));
  const auto &expected = by_gravity.back().points.displacement, &given = by_force.back().points.displacement;
  const double largest = std::abs(*std::min_element(expected.begin(), expected.end()));
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(given[i], expected[i], 1e-4 * largest);
}

TEST(PolygonMotion, ProbesSeeLinearFieldsExactly) {
  const auto study = exchange::parse_case(square(all_sides("motion = 'exact'") +
                                                 "[motion]\ndisplacement = ['1e-6 * Y', '2e-6 * X']\n"
                                                 "[probes.diagonal]\nfrom = [0.0, 0.0]\nto = [1.0, 1.0]\npoints = 5\n"),
                                          "probes.toml");
  const exchange::ProbeSamples probes = stages_of(study).back().probes.at("diagonal");
  ASSERT_EQ(probes.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(probes.displacement[2 * i], 1e-6 * 0.25 * static_cast<double>(i), 2e-11);
    EXPECT_NEAR(probes.displacement[2 * i + 1], 2e-6 * 0.25 * static_cast<double>(i), 2e-11);
  }
}

/// Its nodes stand still in space: once what the plate has pressed is below their elements, nothing holds the block.
TEST(PolygonMotion, APlateThatHasLeftTheElementsAtItsNodesIsReported) {
  const auto study =
      exchange::parse_case(square(rollers + side("[1.0, 1.0]", "[0.0, 1.0]", "held = 'y'\nmotion = 'exact'") +
                                  "[motion]\ndisplacement = ['0', '-0.5 * Y']\n"),
                           "press.toml", {"mpm.element_size=0.125", "mpm.quasi_static.increments=4"});
  try {
    stages_of(study);
    FAIL() << "the block sprang back unseen";
  } catch (const exchange::NotConverged& error) {
    EXPECT_THAT(error.what(), HasSubstr("the supports that move have lost the body"));
  }
}

/// Two layers on a slope of any angle weigh what their polygons weigh, and the base carries it.
TEST(PolygonMotion, MassAndReactionAreThoseOfThePolygons) {
  auto study = exchange::parse_case(square(side("[0.0, 0.0]", "[1.0, 0.0]", ""), "10.0"), "wedge.toml",
                                    {"construction.layers=2",
                                     "geometry.polygon=[{corners=[[0.0,0.0],[1.0,0.0],[0.0,0.7]]},"
                                     "{layer=2,corners=[[1.0,0.0],[1.6,0.0],[0.0,1.12],[0.0,0.7]]}]",
                                     "support.0.to=[1.6,0.0]"});
  const auto stages = stages_of(study);
  EXPECT_NEAR(stages[0].mass, 1000 * 0.35, 1e-9);
  EXPECT_NEAR(stages[1].mass, 1000 * 0.5 * 1.6 * 1.12, 1e-9);
  EXPECT_NEAR(stages[1].base_reaction, stages[1].weight, 1e-6 * stages[1].weight);
}

TEST(PolygonRequirements, TrianglesAreRefusedWithTheElementThatFits) {
  const auto study =
      exchange::parse_case(square(side("[0.0, 0.0]", "[1.0, 0.0]", ""), "1.0"), "t.toml", {"mpm.element=triangle"});
  EXPECT_THAT(complaint_about(study), HasSubstr("set mpm.element = \"quadrilateral\""));
}

TEST(PolygonRequirements, TheExplicitSchemeHoldsSupportsStill) {
  const auto study =
      exchange::parse_case(square(all_sides("motion = 'exact'") + "[motion]\ndisplacement = ['0', '0']\n"), "s.toml",
                           {"mpm.scheme=explicit"});
  EXPECT_THAT(complaint_about(study), HasSubstr("support.0.motion = \"exact\" with mpm.scheme = \"explicit\""));
}
