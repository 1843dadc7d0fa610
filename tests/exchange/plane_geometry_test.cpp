#include "settle/exchange/plane_geometry.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/probe_points.hpp"

using namespace settle::exchange;
using testing::ElementsAre;

namespace {

/// Two layers of a wedge whose faces fall at 45 degrees: a triangle and the strip that covers it.
Geometry wedge() {
  Geometry geometry{.shape = Shape::polygons, .height = 2.0, .width = 2.0};
  geometry.polygons = {{.layer = 1, .corners = {{0, 0}, {1, 0}, {0, 1}}},
                       {.layer = 2, .corners = {{1, 0}, {2, 0}, {0, 2}, {0, 1}}}};
  return geometry;
}

} // namespace

TEST(PlaneGeometry, AreaIsPositiveWhereCornersRunAnticlockwise) {
  EXPECT_DOUBLE_EQ(area(wedge().polygons[0]), 0.5);
  EXPECT_DOUBLE_EQ(area(wedge().polygons[1]), 1.5);
  EXPECT_DOUBLE_EQ(area({.corners = {{0, 0}, {0, 1}, {1, 0}}}), -0.5);
  EXPECT_DOUBLE_EQ(layer_area(wedge(), 2), 1.5);
}

TEST(PlaneGeometry, TheBoxHoldsAllPolygons) {
  const PlaneBox box = bounding_box(wedge());
  EXPECT_THAT(box.lowest, ElementsAre(0.0, 0.0));
  EXPECT_THAT(box.highest, ElementsAre(2.0, 2.0));
}

TEST(PlaneGeometry, APointOnAnInterfaceBelongsToBothLayers) {
  EXPECT_THAT(layers_at(wedge(), {0.5, 0.5}, 1e-9), ElementsAre(1, 2));
  EXPECT_THAT(layers_at(wedge(), {0.2, 0.2}, 1e-9), ElementsAre(1));
  EXPECT_THAT(layers_at(wedge(), {1.5, 1.5}, 1e-9), ElementsAre());
}

TEST(PlaneGeometry, PolygonsThatTouchDoNotOverlap) {
  const Polygon square{.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const auto at = [](double x, double y) {
    return Polygon{.corners = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
  };
  for (const Polygon& beside : {at(1, 0), at(0.5, 1), at(-1, -1), at(1 - 1e-12, 0), at(3, 0.5)}) {
    EXPECT_FALSE(overlap(square, beside, 1e-9));
    EXPECT_FALSE(overlap(beside, square, 1e-9));
  }
  EXPECT_FALSE(overlap(wedge().polygons[0], wedge().polygons[1], 1e-9));
}

TEST(PlaneGeometry, PolygonsOverlapAcrossACornerAcrossEachOtherAndOneWithinTheOther) {
  const Polygon square{.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const Polygon corner{.corners = {{0.9, 0.9}, {2, 0.9}, {2, 2}, {0.9, 2}}};
  const Polygon beam{.corners = {{-1, 0.4}, {2, 0.4}, {2, 0.6}, {-1, 0.6}}}; // no corner of either in the other
  const Polygon inside{.corners = {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}};
  for (const Polygon& other : {corner, beam, inside, square}) {
    EXPECT_TRUE(overlap(square, other, 1e-9));
    EXPECT_TRUE(overlap(other, square, 1e-9));
  }
}

TEST(PlaneGeometry, TheNearestLayerIsKnownAlsoOutside) {
  EXPECT_EQ(nearest_layer(wedge(), {-0.1, 0.5}), 1);
  EXPECT_EQ(nearest_layer(wedge(), {2.0, 2.0}), 2);
}

TEST(PlaneGeometry, TheBodyLiesToTheLeftOfASupport) {
  const Support base{.from = {0, 0}, .to = {2, 0}};
  EXPECT_DOUBLE_EQ(height_above(base, {0.3, 0.25}), 0.25);
  EXPECT_DOUBLE_EQ(height_above(base, {0.3, -0.25}), -0.25);
  EXPECT_DOUBLE_EQ(share_along(base, {0.5, 7.0}), 0.25);
}

TEST(ProbePoints, AcrossPolygonsStandInEveryLayerThatHoldsThem) {
  Case study;
  study.geometry = wedge();
  study.construction.layers = 2;
  const auto points = probe_points(study, {.from = {0, 0}, .to = {0, 2}, .points = 5});
  ASSERT_EQ(points.size(), 6U);
  std::vector<int> layers;
  std::vector<double> heights;
  for (const ProbePoint& point : points) {
    layers.push_back(point.layer);
    heights.push_back(point.design_height);
  }
  EXPECT_THAT(layers, ElementsAre(1, 1, 1, 2, 2, 2));
  EXPECT_THAT(heights, ElementsAre(0.0, 0.5, 1.0, 1.0, 1.5, 2.0));
}
