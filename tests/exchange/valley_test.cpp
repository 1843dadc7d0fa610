#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/probe_points.hpp"
#include "settle/exchange/valley.hpp"

using namespace settle::exchange;

namespace {

/// 5 m high, 4 m wide at the crest; the floor 2 m wide.
Case dam(const std::vector<std::string>& overrides = {}) {
  return parse_case(R"(
format = 1
gravity = 9.81
[material.fill]
law = "rate"
youngs_modulus = 4e6
poissons_ratio = 0.25
density = 1720
[construction]
convention = "drop"
material = "fill"
layers = 5
[geometry]
shape = "embankment"
dimension = 3
[geometry.embankment]
height = 5
crest = 4
slopes = [2.0, 1.5]
[geometry.valley]
bottom = 2
slopes = [1.0, 0.5]
[probes.crest]
from = [0, -6, 4.5]
to = [0, 3.75, 4.5]
points = 40
)",
                    "dam.toml", overrides);
}

/// The integral of (c + S (H - z)) (b + s z), S and s the sums of both slopes.
double volume_up_to(double height) {
  const double c = 4.0 + 3.5 * 5.0, b = 2.0, big = 3.5, small = 1.5;
  return c * b * height + (c * small - big * b) * height * height / 2 - big * small * height * height * height / 3;
}

} // namespace

TEST(Valley, HasTheVolumeOfItsDamLayerByLayer) {
  const Case study = dam();
  for (int layer = 1; layer <= 5; ++layer)
    EXPECT_NEAR(layer_volume(study.geometry, layer), volume_up_to(layer) - volume_up_to(layer - 1), 1e-12);
}

TEST(Valley, IsAsDeepAsItsCrestIsLongAndRemembersNothingElse) {
  const Case study = dam();
  EXPECT_NEAR(study.geometry.depth.value(), 2.0 + 5.0 * 1.5, 1e-12);
  const std::string text = to_toml(study);
  EXPECT_EQ(text.find("depth ="), text.find("foundation_depth =") + 11) << "the only depth is that of no foundation";
  EXPECT_EQ(to_toml(parse_case(text, "echo.toml")), text);
  EXPECT_EQ(middle_of_depth(study.geometry), 0.0);
}

TEST(Valley, IsProbedWhereTheLineRunsBetweenTheFlanksOnly) {
  const Case study = dam();
  const auto points = probe_points(study, study.probes.at("crest"));
  ASSERT_EQ(points.size(), 36U); // at a height of 4.5 m the flank stands at -5.5 and at 3.25
  EXPECT_NEAR(points.front().y, -5.5, 1e-9);
  EXPECT_NEAR(points.back().y, 3.25, 1e-9);
  for (const ProbePoint& point : points) {
    EXPECT_EQ(point.layer, 5);
    EXPECT_EQ(point.x, 0.0);
    EXPECT_EQ(point.design_height, 4.5);
  }
}

TEST(Valley, MeasuresTheWayAlongItsProbesInSpace) {
  const Probes line{.from = {1, 2, 0}, .to = {3, 5, 6}};
  EXPECT_DOUBLE_EQ(length_of(line), 7.0);
  EXPECT_DOUBLE_EQ(distance_from_start(line, {.x = 3, .y = 5, .design_height = 6}), 7.0);
  const Probes in_section{.from = {1, 2}, .to = {4, 6}};
  EXPECT_DOUBLE_EQ(length_of(in_section), 5.0);
  EXPECT_DOUBLE_EQ(distance_from_start(in_section, {.x = 4, .y = 99, .design_height = 6}), 5.0);
}

TEST(Valley, MayBeAVWithoutAFloorAndHaveAVerticalFlank) {
  const Case study = dam({"geometry.valley.bottom=0", "geometry.valley.slopes=[0.0, 1.0]"});
  EXPECT_EQ(valley_at(*study.geometry.valley, 0.0).width(), 0.0);
  EXPECT_EQ(valley_at(*study.geometry.valley, 5.0).from, 0.0);
  EXPECT_EQ(study.geometry.depth, 5.0);
}
