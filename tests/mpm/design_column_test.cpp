// What is designed over a column of squares, and what is there of it.

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"
#include "settle/mpm/design_column.hpp"
#include "settle/mpm/refill.hpp"

namespace settle::mpm::test {
namespace {

/// Squares of 0.5 m from x = -0.5 m on.
const GridBox<2> squares_beside_a_wedge{.counts = {6, 5}, .size = 0.5, .origin = Vector<2>(-0.5, 0.0)};

/// Layer 1: from a toe at x = 0 up to 1 m at x = 2 m. Layer 2: half a metre on its right half.
exchange::Geometry wedge() {
  exchange::Geometry geometry;
  geometry.polygons = {{.layer = 1, .corners = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}}},
                       {.layer = 2, .corners = {{1.0, 0.5}, {2.0, 1.0}, {2.0, 1.5}, {1.0, 1.0}}}};
  return geometry;
}

TEST(DesignColumns, HoldTheExactAreaOfTheLayersThatAreThere) {
  const auto one = design_columns(wedge(), {1}, squares_beside_a_wedge, 2);
  const auto both = design_columns(wedge(), {1, 2}, squares_beside_a_wedge, 2);
  const std::vector<double> first{0.0, 0.125, 0.375, 0.625, 0.875, 0.0}, second{0.0, 0.0, 0.0, 0.5, 0.5, 0.0};
  ASSERT_EQ(one.size(), first.size());
  for (std::size_t c = 0; c < first.size(); ++c) {
    EXPECT_NEAR(one[c].level, first[c], 1e-15) << c;
    EXPECT_NEAR(both[c].level, first[c] + second[c], 1e-15) << c;
  }
}

TEST(DesignColumns, KnowTheSurfaceInTheMiddleOfEachStrip) {
  const auto columns = design_columns(wedge(), {1, 2}, squares_beside_a_wedge, 2);
  EXPECT_EQ(columns[0].covered(), 0.0);
  EXPECT_EQ(columns[3].covered(), 1.0);
  EXPECT_NEAR(columns[1].strips[0]->top, 0.0625, 1e-15);
  EXPECT_NEAR(columns[1].strips[1]->top, 0.1875, 1e-15);
  EXPECT_NEAR(columns[3].strips[0]->top, 1.0625, 1e-15);
  EXPECT_NEAR(columns[3].strips[0]->foot, 0.0, 1e-15);
  EXPECT_NEAR(columns[3].mean_top(), 1.125, 1e-15);
  GridBox<2> shifted = squares_beside_a_wedge;
  shifted.origin[0] = -0.3; // its first column ends at 0.2 m: the toe is in its right half
  const auto toe = design_columns(wedge(), {1}, shifted, 2)[0];
  EXPECT_FALSE(toe.strips[0].has_value());
  EXPECT_NEAR(toe.mean_top(), 0.5 * (0.2 - 0.125), 1e-15);
  EXPECT_EQ(toe.covered(), 0.5);
}

TEST(DesignColumns, AreInSpaceThoseOfTheSectionAllAlongIt) {
  const GridBox<3> grid{.counts = {6, 3, 5}, .size = 0.5, .origin = Vector<3>(-0.5, 0.0, 0.0)};
  const auto section = design_columns(wedge(), {1, 2}, squares_beside_a_wedge, 2);
  const auto columns = design_columns(wedge(), {1, 2}, grid, 2);
  ASSERT_EQ(columns.size(), 3 * section.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const DesignColumn& reference = section[c % section.size()];
    EXPECT_EQ(columns[c].level, reference.level);
    ASSERT_EQ(columns[c].strips.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_EQ(columns[c].strips[i].has_value(), reference.strips[i % 2].has_value());
      if (columns[c].strips[i]) {
        EXPECT_EQ(columns[c].strips[i]->top, reference.strips[i % 2]->top);
      }
    }
  }
}

/// One layer of 1 m, the crest 1 m wide with slopes of 1:1, across a valley with a floor of 1 m and flanks of 1:1.
exchange::Geometry valley_dam() {
  exchange::Geometry geometry{.dimension = 3};
  geometry.embankment = exchange::Embankment{.height = 1.0, .crest = 1.0, .slopes = {1.0, 1.0}};
  geometry.valley = exchange::Valley{.bottom = 1.0, .slopes = {1.0, 1.0}};
  geometry.polygons = {{.layer = 1, .corners = {{-1.5, 0.0}, {1.5, 0.0}, {0.5, 1.0}, {-0.5, 1.0}}}};
  return geometry;
}

/// Its volume is the integral of (3 - 2 z)(1 + 2 z).
TEST(DesignColumns, OfADamHoldItsVolumeBetweenSlopesAndFlanks) {
  const GridBox<3> grid{.counts = {8, 8, 5}, .size = 0.5, .origin = Vector<3>(-2.0, -2.0, 0.0)};
  const auto columns = design_columns(valley_dam(), {1}, grid, 2);
  double volume = 0;
  for (const DesignColumn& column : columns)
    volume += 0.25 * column.level;
  EXPECT_NEAR(volume, 3.0 + 2.0 - 4.0 / 3.0, 1e-13);
  const BoxNumbering<2> plan{{8, 8}}, parts{{2, 2}};
  for (int c = 0; c < plan.size(); ++c)
    for (int part = 0; part < 4; ++part) {
      const auto at = [&](std::size_t axis) {
        return std::abs(-2.0 + 0.5 * plan.index(c)[axis] + 0.25 * parts.index(part)[axis] + 0.125);
      };
      const double top = 1.0 - std::max(0.0, at(0) - 0.5), foot = std::max(0.0, at(1) - 0.5);
      const auto& strip = columns[static_cast<std::size_t>(c)].strips[static_cast<std::size_t>(part)];
      ASSERT_EQ(strip.has_value(), top > foot) << c << ", " << part;
      if (!strip) continue;
      EXPECT_NEAR(strip->top, top, 1e-14);
      EXPECT_NEAR(strip->foot, foot, 1e-14);
    }
}

TEST(ExtendedColumnHeights, AreThoseOfTheColumnWhereNothingHasGoneSideways) {
  const auto body = block<QuadrilateralSpace>();
  const auto extended = extended_column_heights(body), counted = column_heights(body);
  for (std::size_t c = 0; c < counted.size(); ++c)
    EXPECT_NEAR(extended[c], counted[c], 1e-14);
}

/// Where all goes sideways by a share of a column, that share of each column goes to the next: points that have not
/// passed the side yet count as well, and those that have do not all count.
TEST(ExtendedColumnHeights, ChangeEvenlyWhilePointsPassFromColumnToColumn) {
  for (const double share : {0.1, 0.3, 0.6}) {
    auto body = block<QuadrilateralSpace>({.columns = 4, .rows = 4, .filled_rows = 3});
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      if (body.points.position[0][p] > 1.5) body.points.volume[p] = 0.0; // the last column is there for the material
      body.points.position[0][p] += share * body.space.size();
      if (body.points.position[0][p] > 2.0) body.points.position[0][p] = 1.99;
    }
    body.sort();
    const auto heights = extended_column_heights(body);
    const std::vector<double> expected{1.5 * (1.0 - share), 1.5, 1.5, 1.5 * share};
    for (std::size_t c = 0; c < 4; ++c)
      EXPECT_NEAR(heights[c], expected[c], 1e-14) << c << ", " << share;
  }
}

/// Along each axis as in the plane, and together by the product of the shares.
TEST(ExtendedColumnHeights, ChangeInSpaceByTheSharesAlongBothAxes) {
  auto body = block<HexahedronSpace>({.columns = 3, .deep = 3, .rows = 4, .filled_rows = 3});
  const double along_x = 0.3, along_y = 0.6;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    if (body.points.position[0][p] > 1.0 || body.points.position[1][p] > 1.0) body.points.volume[p] = 0.0;
    body.points.position[0][p] = std::min(body.points.position[0][p] + along_x * body.space.size(), 1.49);
    body.points.position[1][p] = std::min(body.points.position[1][p] + along_y * body.space.size(), 1.49);
  }
  body.sort();
  const auto heights = extended_column_heights(body);
  const std::array<double, 3> x{1.0 - along_x, 1.0, along_x}, y{1.0 - along_y, 1.0, along_y};
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(heights[i + 3 * j], 1.5 * x[i] * y[j], 1e-14) << i << ", " << j;
}

template <class Space>
void expect_all_volume_in_columns() {
  std::mt19937 random(7);
  auto body = block<Space>({.columns = 5});
  scatter_positions(body, random, 0.4);
  const auto heights = extended_column_heights(body);
  EXPECT_NEAR(std::accumulate(heights.begin(), heights.end(), 0.0) * body.space.column_area(),
              total_volume(body.points), 1e-13);
}

TEST(ExtendedColumnHeights, HoldAllVolumeWhereverPointsAre) {
  expect_all_volume_in_columns<QuadrilateralSpace>();
  expect_all_volume_in_columns<HexahedronSpace>();
}

/// A column under a slope of 1:5, one metre high in the middle, half a metre of it there.
Refill refill_below_a_slope() {
  DesignColumn design{.level = 1.0, .strips = {}};
  design.strips = {DesignColumn::Strip{0.975, 0.0}, DesignColumn::Strip{1.025, 0.0}};
  return {.rule = exchange::RefillRule::sub_element, .layer = 1, .columns = {design}};
}

TEST(RefillBelowASlope, ClosesTheGapByRowsParallelToTheDesignedSurface) {
  auto body = block<QuadrilateralSpace>({.columns = 1, .rows = 4, .filled_rows = 1});
  EXPECT_EQ(close_gap(body, refill_below_a_slope()), 4);
  EXPECT_NEAR(extended_column_heights(body)[0], 1.0, 1e-14);
  std::vector<double> heights;
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.points.refilled[p] != 0) heights.push_back(body.points.position[1][p]);
  EXPECT_EQ(heights.size(), 4U);
  std::sort(heights.begin(), heights.end());
  const std::vector<double> expected{0.6, 0.65, 0.85, 0.9}; // two rows of 0.25 m, each 0.05 m higher on the right
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(heights[i], expected[i], 1e-14);
  EXPECT_EQ(close_gap(body, refill_below_a_slope()), 0);
}

TEST(RefillBelowASlope, AddsNoPointWhereNothingIsDesignedAndTakesNoneAway) {
  Refill refill = refill_below_a_slope();
  refill.columns[0].strips[0].reset();
  refill.columns[0].level = 0.75; // of one strip of two: its gap is half a metre wide in height, a quarter in the mean
  auto body = block<QuadrilateralSpace>({.columns = 1, .rows = 4, .filled_rows = 1});
  EXPECT_EQ(close_gap(body, refill), 2);
  EXPECT_NEAR(extended_column_heights(body)[0], 0.75, 1e-14);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.points.refilled[p] != 0) {
      EXPECT_GT(body.points.position[0][p], 0.25);
    }
  refill.columns[0].strips[1].reset();
  EXPECT_EQ(close_gap(body, refill), 0);
  refill = refill_below_a_slope();
  refill.columns[0].level = 0.4;
  EXPECT_EQ(close_gap(body, refill), 0);
}

/// Where more is missing than a sliver at a toe is thick, its points still lie above what it stands on.
TEST(RefillBelowASlope, KeepsPointsAboveTheFootOfWhatIsDesigned) {
  Refill refill = refill_below_a_slope();
  refill.columns[0].level = 0.6;
  refill.columns[0].strips = {DesignColumn::Strip{0.55, 0.5}, DesignColumn::Strip{0.65, 0.5}};
  auto body = block<QuadrilateralSpace>({.columns = 1, .rows = 4, .filled_rows = 1});
  EXPECT_EQ(close_gap(body, refill), 2);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.points.refilled[p] != 0) {
      EXPECT_NEAR(body.points.position[1][p], body.points.position[0][p] < 0.25 ? 0.55 : 0.6, 1e-14);
    }
}

} // namespace
} // namespace settle::mpm::test
