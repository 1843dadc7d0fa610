#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/probe_points.hpp"

using namespace settle::exchange;

namespace {

const std::string head = R"(
format = 1
gravity = 9.81
[material.fill]
law = "rate"
youngs_modulus = 4e6
poissons_ratio = 0.25
density = 1720
[material.clay]
law = "tresca"
youngs_modulus = 1e7
poissons_ratio = 0.3
density = 1900
cohesion = 3e4
[geometry]
shape = "embankment"
dimension = 2
[geometry.embankment]
height = 5
crest = 4
slopes = [2.0, 1.5]
)";

Case embankment(const std::string& more, int layers) {
  return parse_case(
      head + more + "\n[construction]\nconvention = \"drop\"\nmaterial = \"fill\"\nlayers = " + std::to_string(layers),
      "embankment.toml");
}

const std::string ground = R"(
foundation_depth = 3
foundation_left = 6
foundation_right = 0
foundation_material = "clay"
)";

double area_of_all(const Case& study) {
  double sum = 0;
  for (int layer = 1; layer <= study.construction.layers; ++layer)
    sum += layer_area(study.geometry, layer);
  return sum;
}

} // namespace

TEST(Embankment, HasTheAreaOfItsSection) {
  const Case study = embankment("", 5);
  EXPECT_NEAR(area_of_all(study), 5.0 * 4.0 + 0.5 * 25.0 * (2.0 + 1.5), 1e-12);
  EXPECT_NEAR(study.geometry.width, 4.0 + 10.0 + 7.5, 1e-12);
  EXPECT_NEAR(study.geometry.height, 5.0, 1e-12);
  EXPECT_TRUE(study.geometry.drawn());
}

TEST(Embankment, StandsOnARoughBaseAlongAllItsWidth) {
  const Case study = embankment("", 5);
  ASSERT_EQ(study.supports.size(), 1U);
  EXPECT_EQ(study.supports[0].held, Held::both);
  EXPECT_THAT(study.supports[0].from, testing::ElementsAre(-12.0, 0.0));
  EXPECT_THAT(study.supports[0].to, testing::ElementsAre(9.5, 0.0));
}

TEST(Embankment, IsPlacedLayerByLayerWhereNoStagesAreGiven) {
  const Case study = embankment("", 3);
  ASSERT_EQ(study.n_stages(), 3);
  for (int stage = 1; stage <= 3; ++stage)
    EXPECT_EQ(study.layer_of_stage(stage), stage);
  EXPECT_THAT(study.layers_present(2), testing::ElementsAre(1, 2));
}

TEST(Embankment, WithAFoundationStandsOnExistingGround) {
  const Case study = embankment(ground, 6);
  EXPECT_EQ(study.stages.front().action, Action::ground);
  EXPECT_EQ(study.stages.at(1).action, Action::place);
  EXPECT_EQ(&study.material_of(1), &study.materials.at("clay"));
  EXPECT_EQ(&study.material_of(2), &study.materials.at("fill"));
  EXPECT_NEAR(layer_area(study.geometry, 1), 3.0 * (21.5 + 6.0), 1e-12);
  EXPECT_EQ(study.supports.size(), 3U);
}

TEST(Embankment, IsEchoedAsItWasGiven) {
  const Case study = embankment(ground, 6);
  const std::string text = to_toml(study);
  const Case again = parse_case(text, "echo.toml");
  EXPECT_EQ(to_toml(again), text);
  EXPECT_EQ(again.geometry.polygons.size(), study.geometry.polygons.size());
  EXPECT_EQ(text.find("[[geometry.polygon]]"), std::string::npos);
}

TEST(Embankment, InSpaceIsAsDeepAsWideIfItsDepthIsLeftOutAndProbedInItsMiddle) {
  const Case study = parse_case(to_toml(embankment("", 5)), "solid.toml", {"geometry.dimension=3"});
  EXPECT_EQ(study.geometry.depth, study.geometry.width);
  const auto points = probe_points(study, {.from = {0, 0}, .to = {0, 5}, .points = 2});
  ASSERT_EQ(points.size(), 2U);
  for (const ProbePoint& point : points)
    EXPECT_EQ(point.y, study.geometry.width / 2);
  EXPECT_EQ(points.back().design_height, 5.0);
}

TEST(Stages, ThatRemoveALayerLeaveTheOthers) {
  const Case study = embankment("\n[[stage]]\nlayer = 1\n[[stage]]\nlayer = 2\n"
                                "[[stage]]\naction = \"load\"\nfrom = [2, 5]\nto = [-2, 5]\ntraction = [0, -1e4]\n"
                                "[[stage]]\naction = \"remove\"\nlayer = 2\n[[stage]]\naction = \"hold\"\n",
                                2);
  EXPECT_EQ(study.n_stages(), 5);
  EXPECT_EQ(study.layer_of_stage(3), 2) << "a load names the layer placed last";
  EXPECT_THAT(study.layers_present(3), testing::ElementsAre(1, 2));
  EXPECT_THAT(study.layers_present(4), testing::ElementsAre(1));
  EXPECT_THAT(study.layers_present(5), testing::ElementsAre(1)) << "what holds brings nothing back";
}

TEST(Paths, GiveOneStageALegAndStrainWhereNothingElseIsSaid) {
  const Case study = parse_case(R"(
format = 1
gravity = 0
[material.soil]
law = "cam-clay"
youngs_modulus = 1e7
poissons_ratio = 0.3
density = 1900
critical_state_slope = 1.0
compression_index = 0.2
swelling_index = 0.04
void_ratio = 1.0
preconsolidation_pressure = 1e5
[construction]
layers = 1
convention = "drop"
material = "soil"
[geometry]
shape = "point"
dimension = 3
[initial]
stress = [-1e5, -1e5, -1e5, 0, 0, 0]
[[path]]
increment = [0, 0, -0.01, 0, 0, 0]
[[path]]
increment = [0, 0, -0.1, 0, 0, 0]
control = ["stress", "stress", "strain", "strain", "strain", "strain"]
increments = 50
)",
                                "point.toml");
  EXPECT_EQ(study.n_stages(), 2);
  EXPECT_THAT(study.paths[0].control, testing::Each("strain"));
  EXPECT_EQ(study.paths[1].control[0], "stress");
  EXPECT_EQ(study.fill().attraction, 0.0);
  EXPECT_EQ(to_toml(parse_case(to_toml(study), "echo.toml")), to_toml(study));
}
