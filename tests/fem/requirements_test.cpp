#include "settle/fem/requirements.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::fem::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// The text of the InputError that a case ends in; empty if it is accepted.
std::string complaint_about(const exchange::Case& study) {
  try {
    require_solvable(study);
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Requirements, CountCellsAlongEachAxis) {
  using Counts = std::array<unsigned, 3>;
  EXPECT_EQ(cells_along_axes(column({.layers = 5, .width = 0.25})), (Counts{2, 40, 1}));
  exchange::Case solid = column({.layers = 5, .dimension = 3, .width = 0.25});
  solid.geometry.depth = 0.5;
  EXPECT_EQ(cells_along_axes(solid), (Counts{2, 4, 40}));
}

TEST(Requirements, AcceptLengthsThatAreMultiplesOnlyUpToRoundOff) {
  EXPECT_EQ(complaint_about(column({.layers = 3, .element_size = 0.1, .width = 0.3, .height = 0.9})), "");
}

TEST(Requirements, ALayerHeightThatIsNoMultipleNamesTheNearestSizesThatFit) {
  exchange::Case study = column({.layers = 5, .element_size = 0.3, .width = 0.5});
  study.origins["fem.element_size"] = "column.toml:31:16";
  EXPECT_THAT(complaint_about(study), AllOf(HasSubstr("column.toml:31:16"), HasSubstr("layer height of 1 m"),
                                            HasSubstr("fem.element_size = 0.3"), HasSubstr("0.5 m or 0.25 m")));
}

TEST(Requirements, AWidthThatIsNoMultipleIsRefusedToo) {
  EXPECT_THAT(complaint_about(column({.element_size = 0.25, .width = 0.125})),
              AllOf(HasSubstr("width of 0.125 m"), HasSubstr("0.125 m")));
}

TEST(Requirements, ADepthThatIsNoMultipleIsRefusedInThreeDimensionsOnly) {
  exchange::Case study = column({.dimension = 3, .element_size = 0.25, .width = 0.25});
  study.geometry.depth = 0.3;
  EXPECT_THAT(complaint_about(study), AllOf(HasSubstr("depth of 0.3 m"), HasSubstr("0.05 m")));
  study.geometry.dimension = 2;
  EXPECT_EQ(complaint_about(study), "");
}

TEST(Requirements, AnElementLargerThanALayerIsRefused) {
  EXPECT_THAT(complaint_about(column({.layers = 10, .element_size = 1.0, .width = 1.0})),
              AllOf(HasSubstr("layer height of 0.5 m"), HasSubstr("0.5 m")));
}

TEST(Requirements, LengthsWithoutACommonDivisorAreSaidToHaveNone) {
  EXPECT_THAT(complaint_about(column({.layers = 1, .element_size = 0.5, .width = 0.7071067811865476, .height = 1.0})),
              HasSubstr("common divisor"));
}

exchange::Case at_finite_strain(exchange::Convention convention, int layers) {
  exchange::Case study = column({.layers = layers});
  study.fem.kinematics = exchange::Kinematics::finite;
  study.construction.convention = convention;
  study.origins["construction.convention"] = "column.toml:17:14";
  return study;
}

TEST(Requirements, RefillAtFiniteStrainIsRefusedWithWhyAndWhatToUse) {
  for (const int layers : {1, 5}) {
    const exchange::Case study = at_finite_strain(exchange::Convention::refill, layers);
    EXPECT_THAT(complaint_about(study),
                AllOf(HasSubstr("column.toml:17:14"), HasSubstr("a mesh takes no material during a stage"),
                      HasSubstr("construction.convention = \"refill\" with fem.kinematics = \"finite\""),
                      HasSubstr("\"level-up\""), HasSubstr("fem.kinematics = \"small\""), HasSubstr("settle-mpm")));
    EXPECT_THROW(Solver{study}, exchange::InputError);
  }
}

TEST(Requirements, DropAtFiniteStrainIsASingleLayerOnly) {
  EXPECT_THAT(complaint_about(at_finite_strain(exchange::Convention::drop, 5)),
              AllOf(HasSubstr("a mesh cannot close the gap"), HasSubstr("\"float\" or \"level-up\"")));
  EXPECT_EQ(complaint_about(at_finite_strain(exchange::Convention::drop, 1)), "");
}

TEST(Requirements, LayersOnTheSettledSurfaceAreAcceptedAtFiniteStrain) {
  EXPECT_EQ(complaint_about(at_finite_strain(exchange::Convention::floating, 5)), "");
  EXPECT_EQ(complaint_about(at_finite_strain(exchange::Convention::level_up, 5)), "");
}

class EveryConvention : public ::testing::TestWithParam<exchange::Convention> {};

TEST_P(EveryConvention, IsTheSameColumnWhereGeometryIsFrozen) {
  exchange::Case study = column({.layers = 2, .element_size = 0.5, .width = 0.5, .height = 2.0});
  const exchange::Stage refilled = solve(study).back();
  study.construction.convention = GetParam();
  EXPECT_EQ(solve(study).back().points.displacement, refilled.points.displacement);
}

INSTANTIATE_TEST_SUITE_P(All, EveryConvention,
                         ::testing::Values(exchange::Convention::level_up, exchange::Convention::floating,
                                           exchange::Convention::drop));

} // namespace
} // namespace settle::fem::testing
