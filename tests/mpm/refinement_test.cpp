// What refining the mesh does to the error.

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "paper_column.hpp"

namespace settle::mpm::test {
namespace {

RelativeErrors error_of_float(double element_size) {
  const auto study =
      paper_column_meshed(element_size, {"construction.convention=float", "mpm.quasi_static.increments=5"});
  return errors_of(study, stages_of(study));
}

TEST(Refinement, LowersTheErrorsOfAFloatingColumnAtFirstOrder) {
  // Measured at 0.125, 0.0625, 0.03125 m: settlement 0.140, 0.064, 0.030 %, stress 0.60, 0.29, 0.16 %. Stress is
  // constant in a triangle: first order.
  RelativeErrors coarse = error_of_float(0.125);
  for (const double size : {0.0625, 0.03125}) {
    const RelativeErrors fine = error_of_float(size);
    EXPECT_NEAR(std::log2(coarse.settlement / fine.settlement), 1.0, 0.3) << size;
    EXPECT_NEAR(std::log2(coarse.vertical_stress / fine.vertical_stress), 1.0, 0.3) << size;
    coarse = fine;
  }
}

TEST(Refinement, WithItsIncrementsRefinedTooTheSettlementErrorStaysAtHalfAPercent) {
  // Known, and bounded from both sides: with three points a triangle, points that cross cells one by one in many small
  // increments leave an error that does not fall with the mesh. Measured: 0.41, 0.51, 0.51 %.
  int increments = 80;
  for (const double size : {0.125, 0.0625, 0.03125}) {
    const auto study = paper_column_meshed(
        size, {"construction.convention=float", fmt::format("mpm.quasi_static.increments={}", increments)});
    EXPECT_NEAR(errors_of(study, stages_of(study)).settlement, 0.0046, 0.0012) << size;
    increments *= 2;
  }
}

TEST(Refinement, RefillByWholeElementsIsWorseThanBySubElementByAnOrderOfMagnitude) {
  const auto by_element = paper_column({"mpm.refill=element"}), by_row = paper_column();
  const double coarse_rule = errors_of(by_element, stages_of(by_element)).settlement;
  const double fine_rule = errors_of(by_row, stages_of(by_row)).settlement;
  EXPECT_GT(coarse_rule, 10.0 * fine_rule);
  EXPECT_LT(coarse_rule, 0.15); // the column is wrong by less than its elements are coarse
}

} // namespace
} // namespace settle::mpm::test
