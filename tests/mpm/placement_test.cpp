// Where points are placed, and how much of the body each stands for.

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "blocks.hpp"

namespace settle::mpm::test {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Pointwise;

/// Different heights, from below.
std::vector<double> row_heights(const Points<2>& points, std::size_t first = 0) {
  std::vector<double> heights(points.position[1].begin() + static_cast<std::ptrdiff_t>(first),
                              points.position[1].end());
  std::sort(heights.begin(), heights.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
  return heights;
}

TEST(Placement, RowsOfASquareLieAtOneTwoFourAndFiveSixths) {
  const auto body = block({.columns = 2, .rows = 2, .filled_rows = 1, .size = 0.6});
  EXPECT_THAT(row_heights(body.points), Pointwise(DoubleNear(1e-14), {0.1, 0.2, 0.4, 0.5}));
  EXPECT_EQ(body.points.size(), 12U);
}

TEST(Placement, PointsOfAQuadrilateralLieOnARegularLatticeWithAShareOfTheSquareEach) {
  for (const int per_side : {2, 3, 4}) {
    auto body = block<QuadrilateralSpace>({.columns = 1, .rows = 2, .filled_rows = 1, .size = 0.6});
    body.points = {};
    body.layout = lattice_layout<2>(per_side);
    place_layer(body, {.layer = 1, .base = 0.0, .thickness = 0.6});
    const auto rows = row_heights(body.points);
    ASSERT_EQ(rows.size(), static_cast<std::size_t>(per_side));
    for (int j = 0; j < per_side; ++j)
      EXPECT_NEAR(rows[static_cast<std::size_t>(j)], 0.6 * (j + 0.5) / per_side, 1e-14);
    EXPECT_THAT(body.points.volume, Each(DoubleNear(0.36 / (per_side * per_side), 1e-15)));
    EXPECT_NEAR(refill_row_height(body), rows[1] - rows[0], 1e-14);
  }
}

TEST(Placement, PointsOfATriangleIntegrateEveryQuadraticExactly) {
  const auto body = block({.columns = 1, .rows = 2, .filled_rows = 1, .size = 1.0});
  double x2 = 0, xy = 0, y2 = 0; // over the lower left triangle of the unit square
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    if (body.points.cell[p] != 0) continue;
    const auto x = body.points.position_of(p);
    x2 += body.points.volume[p] * x[0] * x[0];
    xy += body.points.volume[p] * x[0] * x[1];
    y2 += body.points.volume[p] * x[1] * x[1];
  }
  EXPECT_NEAR(x2, 1.0 / 12.0, 1e-15);
  EXPECT_NEAR(xy, 1.0 / 24.0, 1e-15);
  EXPECT_NEAR(y2, 1.0 / 12.0, 1e-15);
}

TEST(Placement, PointsStandForTheWholeLayerAndNoMore) {
  const auto body = block({.columns = 3, .rows = 5, .filled_rows = 4, .size = 0.25});
  EXPECT_NEAR(total_volume(body.points), 3 * 0.25 * 4 * 0.25, 1e-14);
  EXPECT_NEAR(total_mass(body.points), block_density * 0.75, 1e-10);
}

TEST(Placement, APlacedPointIsStressFreeAtRestAndWhereItWasPlaced) {
  const auto body = block();
  for (const auto& component : body.points.stress)
    EXPECT_THAT(component, Each(0.0));
  for (const auto& component : body.points.velocity)
    EXPECT_THAT(component, Each(0.0));
  EXPECT_EQ(body.points.placed, body.points.position);
  EXPECT_THAT(body.points.refilled, Each(0));
}

TEST(Placement, PointsAreNumberedFromOneInOrderOfPlacement) {
  auto body = block({.columns = 2, .rows = 4, .filled_rows = 1});
  std::set<std::uint64_t> ids(body.points.id.begin(), body.points.id.end());
  EXPECT_EQ(ids.size(), 12U);
  EXPECT_EQ(*ids.begin(), 1U);
  EXPECT_EQ(*ids.rbegin(), 12U);
  place_layer(body, {.layer = 2, .base = 0.5, .thickness = 0.5});
  EXPECT_EQ(body.points.id.back(), 24U);
}

TEST(Placement, ALayerWhoseThicknessIsNoMultipleIsDividedIntoTheNearestNumberOfRows) {
  auto body = block({.columns = 1, .rows = 5, .filled_rows = 1, .size = 0.5});
  const auto before = body.points.size();
  place_layer(body, {.layer = 2, .base = 0.4, .thickness = 1.2}); // 2.4 squares: two rows, each 0.6 m high
  EXPECT_THAT(row_heights(body.points, before), Pointwise(DoubleNear(1e-14), {0.5, 0.6, 0.8, 0.9, 1.1, 1.2, 1.4, 1.5}));
  EXPECT_EQ(body.points.size() - before, 12U);
  EXPECT_NEAR(total_volume(body.points), 0.5 * (0.5 + 1.2), 1e-14);
}

TEST(Placement, TheNearestNumberOfRowsMayBeTheLargerOne) {
  auto body = block({.columns = 1, .rows = 5, .filled_rows = 1, .size = 0.5});
  place_layer(body, {.layer = 2, .base = 0.4, .thickness = 1.3}); // 2.6 squares
  EXPECT_EQ(body.points.size(), 6U + 18U);
}

TEST(Placement, ALayerThinnerThanHalfASquareStillHasOneRowOfSquares) {
  auto body = block({.columns = 1, .rows = 3, .filled_rows = 1, .size = 0.5});
  place_layer(body, {.layer = 2, .base = 0.5, .thickness = 0.06});
  EXPECT_EQ(body.points.size(), 12U);
  EXPECT_NEAR(total_volume(body.points), 0.5 * 0.56, 1e-14);
}

TEST(Placement, ColumnHeightsOfAFreshLayerAreItsThickness) {
  const auto body = block({.columns = 4, .rows = 4, .filled_rows = 3, .size = 0.5});
  EXPECT_THAT(column_heights(body), Pointwise(DoubleNear(1e-14), {1.5, 1.5, 1.5, 1.5}));
}

TEST(Placement, ARefilledCellGetsTheInitialPointsOfThatCellMarkedAsRefilled) {
  auto body = block({.columns = 2, .rows = 2, .filled_rows = 1, .size = 0.6});
  const int cell = 5; // upper right triangle of the first square of the second row
  const auto before = body.points.size();
  refill_cell(body, cell, 7);
  body.sort();
  ASSERT_EQ(body.points.size(), before + 3);
  for (std::size_t p = before; p < body.points.size(); ++p) {
    EXPECT_EQ(body.points.cell[p], cell);
    EXPECT_EQ(body.points.layer[p], 7);
    EXPECT_EQ(body.points.refilled[p], 1);
    EXPECT_NEAR(body.points.volume[p], body.space.cell_volume() / 3.0, 1e-15);
    EXPECT_NEAR(body.points.density(p), block_density, 1e-9);
  }
}

TEST(Placement, ARefilledRowFillsItsHeightAcrossOneColumnOfSquares) {
  auto body = block({.columns = 2, .rows = 2, .filled_rows = 1, .size = 0.6});
  EXPECT_NEAR(refill_row_height(body), 0.1, 1e-15);
  const auto before = body.points.size();
  refill_row(body, {.layer = 3, .column = 1, .top = 0.7, .height = 0.08});
  ASSERT_EQ(body.points.size(), before + 2);
  for (std::size_t p = before; p < before + 2; ++p) {
    EXPECT_EQ(body.points.refilled[p], 1);
    EXPECT_EQ(body.points.layer[p], 3);
    EXPECT_NEAR(body.points.position[1][p], 0.66, 1e-14);
    EXPECT_NEAR(body.points.volume[p], 0.5 * 0.6 * 0.08, 1e-15);
  }
  EXPECT_NEAR(body.points.position[0][before], 0.75, 1e-14);
  EXPECT_NEAR(body.points.position[0][before + 1], 1.05, 1e-14);
}

TEST(Placement, ALayerPlacedOnALoadedBodyIsStressFreeAndChangesNothingBelow) {
  auto body = block({.columns = 2, .rows = 5, .filled_rows = 2});
  for (auto& component : body.points.stress)
    std::fill(component.begin(), component.end(), -7e3);
  place_layer(body, {.layer = 2, .base = 0.9, .thickness = 1.0}); // some of it in cells that are occupied already
  body.sort();
  for (std::size_t p = 0; p < body.points.size(); ++p)
    for (const auto& component : body.points.stress)
      EXPECT_EQ(component[p], body.points.layer[p] == 1 ? -7e3 : 0.0);
}

} // namespace
} // namespace settle::mpm::test
