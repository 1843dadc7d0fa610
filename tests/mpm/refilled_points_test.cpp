// Refilling goes on while gravity comes, not only at the end of a stage.

#include <algorithm>

#include <gtest/gtest.h>

#include "paper_column.hpp"

namespace settle::mpm::test {
namespace {

/// Largest settlement of the points refilled while 5 m are built in one layer [m].
double largest_settlement_of_refilled(const std::string& scheme) {
  const auto points = stages_of(paper_column({"construction.layers=1", "mpm.scheme=" + scheme})).back().points;
  double largest = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points.refilled[p] != 0) largest = std::max(largest, -points.displacement[2 * p + 1]);
  return largest;
}

TEST(RefilledPoints, SettleUnderTheGravityThatComesAfterThem) {
  // Measured 0.47 and 0.48 m; refilled only at full gravity, they would settle by 0.08 m.
  EXPECT_GT(largest_settlement_of_refilled("quasi-static"), 0.4);
  EXPECT_GT(largest_settlement_of_refilled("explicit"), 0.4);
}

TEST(RefilledPoints, CarryLessThanThePointsPlacedBelowThem) {
  const auto points = stages_of(paper_column({"construction.layers=1"})).back().points;
  double base = 0, refilled = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    auto& largest = points.refilled[p] != 0 ? refilled : base;
    largest = std::max(largest, -points.stress[6 * p + 1]);
  }
  EXPECT_GT(refilled, 0.0);
  EXPECT_LT(refilled, 0.2 * base);
}

} // namespace
} // namespace settle::mpm::test
