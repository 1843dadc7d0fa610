#include "settle/exchange/fitting_size.hpp"

#include <gmock/gmock.h>

#include "settle/exchange/errors.hpp"

using namespace settle::exchange;
using testing::HasSubstr;

namespace {

/// Layers of 1 m.
Case column(double width, int dimension = 2) {
  Case study;
  study.geometry = {.height = 5.0, .width = width, .depth = 0.75, .dimension = dimension};
  study.construction.layers = 5;
  return study;
}

std::string complaint_about(const Case& study, double size) {
  try {
    static_cast<void>(count_elements(study, "mpm.element_size", size));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

} // namespace

TEST(FittingSize, CountsTheElementsOfALayerAndOfTheColumnsSides) {
  const ElementCounts plane = count_elements(column(0.5), "mpm.element_size", 0.125);
  EXPECT_EQ(plane.per_layer, 8);
  EXPECT_EQ(plane.across, 4);
  EXPECT_EQ(plane.deep, 1);
  EXPECT_EQ(count_elements(column(0.5, 3), "fem.element_size", 0.25).deep, 3);
}

TEST(FittingSize, MayBeADecimalNumberThatDividesOnlyUpToItsDigits) {
  EXPECT_EQ(count_elements(column(1.0 / 3.0), "mpm.element_size", 0.33333333).per_layer, 3);
}

TEST(FittingSize, ThatDividesALengthOnlyNearlyIsRefusedWithTheSizesThatFit) {
  EXPECT_THAT(complaint_about(column(0.5), 0.124), testing::AllOf(HasSubstr("layer height"), HasSubstr("0.125 m")));
  EXPECT_THAT(complaint_about(column(0.45), 0.125), HasSubstr("the width of 0.45 m is no multiple"));
  EXPECT_THAT(complaint_about(column(0.5, 3), 0.5), HasSubstr("the depth of 0.75 m is no multiple"));
}

TEST(FittingSize, ThatIsLargerThanALengthIsRefused) {
  EXPECT_THAT(complaint_about(column(0.5), 1.0), HasSubstr("the width of 0.5 m is no multiple"));
  EXPECT_THAT(complaint_about(column(0.5), 4.0), HasSubstr("layer height"));
}
