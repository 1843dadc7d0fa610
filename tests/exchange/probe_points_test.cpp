#include "settle/exchange/probe_points.hpp"

#include <gtest/gtest.h>

using namespace settle::exchange;

namespace {

Case column(int layers, int dimension) {
  Case study;
  study.geometry = {.height = 5.0, .width = 0.5, .depth = 0.25, .dimension = dimension};
  study.construction.layers = layers;
  return study;
}

} // namespace

TEST(ProbePoints, IncludeBothEndsOfEveryLayer) {
  const auto points = probe_points(column(5, 2), {.x = 0.1, .points_per_layer = 3});
  ASSERT_EQ(points.size(), 15U);
  EXPECT_EQ(points.front().design_height, 0.0);
  EXPECT_EQ(points.back().design_height, 5.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].layer, static_cast<int>(i / 3) + 1);
    EXPECT_EQ(points[i].relative_height, 0.5 * static_cast<double>(i % 3));
    EXPECT_DOUBLE_EQ(points[i].design_height, points[i].layer - 1 + points[i].relative_height);
  }
}

TEST(ProbePoints, OfTwoLayersMeetExactlyAtTheirInterface) {
  const auto points = probe_points(column(7, 2), {.points_per_layer = 2});
  for (std::size_t i = 1; i + 1 < points.size(); i += 2)
    EXPECT_EQ(points[i].design_height, points[i + 1].design_height);
}

TEST(ProbePoints, StandWhereTheLineStandsOrInTheMiddle) {
  EXPECT_EQ(probe_points(column(1, 2), {.x = 0.1})[0].x, 0.1);
  EXPECT_EQ(probe_points(column(1, 2), {})[0].x, 0.25);
  EXPECT_EQ(probe_points(column(1, 2), {.y = 0.2})[0].y, 0.0);
  EXPECT_EQ(probe_points(column(1, 3), {.y = 0.2})[0].y, 0.2);
  EXPECT_EQ(probe_points(column(1, 3), {})[0].y, 0.125);
}
