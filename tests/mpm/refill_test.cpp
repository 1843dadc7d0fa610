// Refill: when points are added, how many, where.

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>

#include "blocks.hpp"
#include "settle/mpm/refill.hpp"

namespace settle::mpm::test {
namespace {

using exchange::RefillRule;

constexpr double row = 0.5 / 6.0; ///< height of a full refilled row [m]

/// Three squares high, up to 1.5 m.
Body<TriangleSpace> body_below_gap(int columns = 1) {
  return block({.columns = columns, .rows = 6, .filled_rows = 3});
}

Refill refill_to(double level, RefillRule rule = RefillRule::sub_element) {
  return {.rule = rule, .layer = 4, .lower_level = 1.0, .design_level = level};
}

/// Of a stage at whose end nothing closes the gap.
Refill open_refill_to(double level) {
  Refill refill = refill_to(level);
  refill.ends_closed = false;
  return refill;
}

double mean_height(const Body<TriangleSpace>& body) {
  return total_volume(body.points) / body.space.width();
}

/// Rows added for a gap of so many.
int rows_added(double gap_in_rows, bool ends_closed) {
  auto body = body_below_gap();
  Refill refill = refill_to(1.5 + gap_in_rows * row);
  refill.ends_closed = ends_closed;
  return refill_where_due(body, refill) / 2;
}

TEST(RefillWhereDue, AddsTheRowsThatFitBelowTheDesignLevelWhereTheGapIsClosedInTheEnd) {
  EXPECT_EQ(rows_added(0.0, true), 0);
  EXPECT_EQ(rows_added(0.99, true), 0);
  EXPECT_EQ(rows_added(1.01, true), 1);
  EXPECT_EQ(rows_added(3.99, true), 3);
}

TEST(RefillWhereDue, AddsARowAsSoonAsTheGapExceedsHalfItsHeightWhereNothingClosesIt) {
  EXPECT_EQ(rows_added(0.0, false), 0);
  EXPECT_EQ(rows_added(0.49, false), 0);
  EXPECT_EQ(rows_added(0.51, false), 1);
  EXPECT_EQ(rows_added(1.49, false), 1);
  EXPECT_EQ(rows_added(1.51, false), 2);
  EXPECT_EQ(rows_added(3.51, false), 4);
}

TEST(RefillWhereDue, LeavesADeficitThatIsNeverMoreThanHalfARowAndZeroInTheMeanWhereNothingClosesIt) {
  double sum = 0;
  const int samples = 400;
  for (int k = 0; k < samples; ++k) {
    const double level = 1.5 + 4.0 * row * (k + 0.5) / samples;
    auto body = body_below_gap();
    refill_where_due(body, open_refill_to(level));
    const double deficit = level - mean_height(body);
    EXPECT_LE(std::abs(deficit), 0.5 * row * (1.0 + 1e-9));
    sum += deficit;
  }
  EXPECT_NEAR(sum / samples, 0.0, 1e-3 * row);
}

TEST(RefillWhereDue, SettlesOnceAndAddsNothingTheSecondTime) {
  auto body = body_below_gap();
  const auto refill = refill_to(1.5 + 2.3 * row);
  EXPECT_GT(refill_where_due(body, refill), 0);
  EXPECT_EQ(refill_where_due(body, refill), 0);
}

TEST(RefillWhereDue, FillsOnlyTheColumnsOfSquaresThatHaveSettled) {
  auto body = body_below_gap(3);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.space.column_of(body.points.cell[p]) == 1) body.points.volume[p] *= 0.85; // 1.275 m: 2.7 rows short
  EXPECT_EQ(refill_where_due(body, refill_to(1.5)), 4);
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.points.refilled[p] != 0) {
      EXPECT_EQ(body.space.column_of(body.points.cell[p]), 1);
    }
}

TEST(RefillWhereDue, StacksItsRowsOnTheSurface) {
  auto body = body_below_gap();
  refill_where_due(body, refill_to(1.5 + 2.7 * row));
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.points.refilled[p] != 0) {
      const double above = (body.points.position[1][p] - 1.5) / row;
      EXPECT_TRUE(std::abs(above - 0.5) < 1e-9 || std::abs(above - 1.5) < 1e-9) << above;
    }
}

TEST(RefillWhereDue, GivesPointsDomainsThatTouchThoseBelowAndEachOther) {
  auto body = block<GimpSpace<2>>({.columns = 2, .rows = 6, .filled_rows = 3});
  close_gap(body, {.rule = RefillRule::sub_element, .layer = 4, .lower_level = 1.0, .design_level = 1.5 + 1.6 * 0.25});
  std::map<long, double> top_of_row; // by lower side, both in thousandths of a row
  double volume = 0;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const Vector<2> half = body.points.half_lengths_of(p);
    const double y = body.points.position[1][p];
    top_of_row[std::lround(1e3 * (y - half[1]) / 0.25)] = 1e3 * (y + half[1]) / 0.25;
    volume += 4.0 * half.prod();
  }
  EXPECT_NEAR(volume / total_volume(body.points), 1.0, 1e-13);
  ASSERT_EQ(top_of_row.size(), 8U);
  for (auto here = top_of_row.begin(); std::next(here) != top_of_row.end(); ++here)
    EXPECT_NEAR(here->second, static_cast<double>(std::next(here)->first), 1e-6);
  EXPECT_NEAR(top_of_row.rbegin()->second, 1e3 * (6.0 + 1.6), 1e-6);
}

TEST(CloseGap, ClosesEveryColumnExactly) {
  auto body = body_below_gap(3);
  for (std::size_t p = 0; p < body.points.size(); ++p) // 0.3, 0.6 and 0.9 times a row and whole rows short
    body.points.volume[p] *= 1.0 - row * 1.3 * (1 + body.space.column_of(body.points.cell[p])) / 1.5;
  EXPECT_GT(close_gap(body, refill_to(1.5)), 0);
  for (const double height : column_heights(body))
    EXPECT_NEAR(height, 1.5, 1e-13);
}

TEST(CloseGap, PutsThePartialRowRightAboveTheFullOnes) {
  auto body = body_below_gap();
  EXPECT_EQ(close_gap(body, refill_to(1.5 + 2.6 * row)), 6);
  std::vector<double> heights; // of the middles of the rows above the surface, in rows
  for (std::size_t p = 0; p < body.points.size(); ++p)
    if (body.points.refilled[p] != 0) heights.push_back((body.points.position[1][p] - 1.5) / row);
  std::sort(heights.begin(), heights.end());
  EXPECT_THAT(heights, testing::Pointwise(testing::DoubleNear(1e-9), {0.5, 0.5, 1.5, 1.5, 2.3, 2.3}));
}

TEST(CloseGap, LeavesAGapOpenThatIsBelowHalfAPercentOfARow) {
  auto body = body_below_gap();
  EXPECT_EQ(close_gap(body, refill_to(1.5 + 0.004 * row)), 0);
  EXPECT_EQ(close_gap(body, refill_to(1.5 + 0.006 * row)), 2);
}

TEST(Refill, GivesNothingToAColumnAboveItsDesignLevel) {
  auto body = body_below_gap();
  EXPECT_EQ(refill_where_due(body, refill_to(1.2)), 0);
  EXPECT_EQ(close_gap(body, refill_to(1.2)), 0);
}

TEST(Refill, DoesNothingWithoutARule) {
  auto body = body_below_gap();
  Refill none = refill_to(2.0);
  none.rule.reset();
  EXPECT_EQ(refill_where_due(body, none), 0);
  EXPECT_EQ(close_gap(body, none), 0);
}

TEST(Refill, AddsTheMassOfTheVolumeItFillsAtTheDensityAsPlaced) {
  auto body = body_below_gap(2);
  const double mass = total_mass(body.points), volume = total_volume(body.points);
  const int added = close_gap(body, refill_to(1.5 + 1.7 * row));
  EXPECT_EQ(added, 8); // a whole and a partial row in both columns, two points each
  EXPECT_NEAR(total_volume(body.points) - volume, 1.7 * row * body.space.width(), 1e-13);
  EXPECT_NEAR((total_mass(body.points) - mass) / (block_density * 1.7 * row * body.space.width()), 1.0, 1e-11);
}

/// Compressed until only the lower left triangles of the top row of squares still hold points.
Body<TriangleSpace> body_with_empty_cells() {
  auto body = body_below_gap(2);
  for (double& y : body.points.position[1])
    y *= 0.72;
  body.sort();
  return body;
}

TEST(RefillByElement, FillsEveryEmptyCellOfTheLayerAndNoOther) {
  auto body = body_with_empty_cells();
  const auto empty_in = [&body](int first_row, int last_row) {
    int empty = 0;
    for (int cell = 2 * body.space.columns() * first_row; cell < 2 * body.space.columns() * last_row; ++cell)
      empty += body.cells.is_empty(cell) ? 1 : 0;
    return empty;
  };
  const int empty_cells = empty_in(2, 3), empty_above = empty_in(3, 6);
  ASSERT_GT(empty_cells, 0);
  EXPECT_EQ(refill_where_due(body, refill_to(1.5, RefillRule::element)), 3 * empty_cells);
  EXPECT_EQ(empty_in(2, 3), 0);
  EXPECT_EQ(empty_in(3, 6), empty_above);
  EXPECT_EQ(refill_where_due(body, refill_to(1.5, RefillRule::element)), 0);
}

TEST(RefillByElement, LeavesCellsThatHoldASinglePointAlone) {
  auto body = body_below_gap();
  for (double& y : body.points.position[1])
    y *= 0.99; // settled, but no cell is empty
  body.sort();
  EXPECT_EQ(refill_where_due(body, refill_to(1.5, RefillRule::element)), 0);
  EXPECT_EQ(close_gap(body, refill_to(1.5, RefillRule::element)), 0);
}

TEST(RefillByElement, DoesNotLookBelowTheLayerUnderConstruction) {
  auto body = body_with_empty_cells();
  Refill refill = refill_to(1.5, RefillRule::element);
  refill.lower_level = 1.5;
  EXPECT_EQ(refill_where_due(body, refill), 0);
}

} // namespace
} // namespace settle::mpm::test
