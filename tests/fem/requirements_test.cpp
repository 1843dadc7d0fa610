#include "settle/fem/requirements.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.hpp"
#include "frozen_column.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::fem::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

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

/// A rectangle of two layers as polygons, rollers on its base.
exchange::Case polygons(const std::vector<std::string>& overrides = {}) {
  return exchange::parse_case(R"(
format = 1
title = "rectangle"
gravity = 9.81
[material.fill]
law = "hencky"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[construction]
layers = 2
convention = "drop"
material = "fill"
[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
layer = 1
corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
[[geometry.polygon]]
layer = 2
corners = [[0.0, 1.0], [1.0, 1.0], [0.5, 2.0]]
[[support]]
from = [0.0, 0.0]
to = [1.0, 0.0]
[fem]
element_size = 0.25
)",
                              "polygons.toml", overrides);
}

TEST(Requirements, PolygonsAreDividedIntoCells) {
  EXPECT_EQ(complaint_about(polygons()), "");
  EXPECT_EQ(number_of_cells(polygons()),
            6U * 4U + 3U * 3U * 3U); // a face of the triangle is sqrt(1.25)/0.25 = 4.5 long
  EXPECT_EQ(number_of_cells(column({.layers = 5, .width = 0.25})), 2U * 40U);
}

TEST(Requirements, LayersOfPolygonsAtFiniteStrainLieOnWhatHasSettled) {
  EXPECT_THAT(complaint_about(polygons({"fem.kinematics=finite"})),
              AllOf(HasSubstr("a mesh cannot close the gap"), HasSubstr("fem.kinematics = \"small\""),
                    HasSubstr("settle-mpm")));
  for (const char* convention : {"float", "level-up"})
    EXPECT_EQ(
        complaint_about(polygons({"fem.kinematics=finite", fmt::format("construction.convention={}", convention)})),
        "");
}

exchange::Case at_finite_strain_with(const std::string& second_layer) {
  return polygons(
      {"fem.kinematics=finite", "construction.convention=float",
       "geometry.polygon=[{layer = 1, corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]}, {layer = 2, "
       "corners = " +
           second_layer + "}]"});
}

TEST(Requirements, ALayerThatLeansOnAnotherIsRefusedAtFiniteStrain) {
  exchange::Case study = at_finite_strain_with("[[1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0]]");
  EXPECT_THAT(complaint_about(study), AllOf(HasSubstr("layer 2 leans on what was placed before"), HasSubstr("at (1, "),
                                            HasSubstr("fem.kinematics = \"small\"")));
  study.fem.kinematics = exchange::Kinematics::small;
  EXPECT_EQ(complaint_about(study), "");
}

TEST(Requirements, ALayerThatLiesOnAnotherInPartIsRefusedAtFiniteStrain) {
  EXPECT_THAT(complaint_about(at_finite_strain_with("[[0.0, 1.0], [1.0, 1.0], [1.5, 2.0], [0.0, 2.0]]")),
              AllOf(HasSubstr("layer 2 lies in part on what was placed before"), HasSubstr("divide the layer")));
}

exchange::Case with_stage(const std::string& stage, std::vector<std::string> overrides = {}) {
  overrides.push_back("stage=[{action = \"ground\", layer = 1}, {action = \"place\", layer = 2}, " + stage + "]");
  return polygons(overrides);
}

TEST(Requirements, ALoadHasToLieOnTheSurfaceThatIsThereAsAWhole) {
  const auto load = [](const char* from, const char* to) {
    return fmt::format("{{action = \"load\", from = {}, to = {}, traction = [0.0, -1e3]}}", from, to);
  };
  EXPECT_EQ(complaint_about(with_stage(load("[1.0, 1.0]", "[0.75, 1.5]"))), "");
  EXPECT_THAT(complaint_about(with_stage(load("[1.0, 1.0]", "[0.0, 1.0]"))), // between the layers
              AllOf(HasSubstr("stage.2 loads what is no surface of the body then"), HasSubstr("of which 0 m")));
  EXPECT_THAT(complaint_about(with_stage(load("[1.0, 1.5]", "[1.0, 0.5]"))),
              AllOf(HasSubstr("1 m, of which 0.5 m lie on the surface"), HasSubstr("boundary of what is there")));
  EXPECT_EQ(complaint_about(with_stage("{action = \"remove\", layer = 2}, " + load("[1.0, 1.0]", "[0.0, 1.0]"))), "");
}

TEST(Requirements, K0IsForLevelGroundAndForLawsThatKeepStress) {
  const auto ground = [](int layer, const std::vector<std::string>& overrides) {
    std::vector<std::string> all = overrides;
    all.push_back(fmt::format("stage=[{{action = \"ground\", layer = 1{}}}, {{action = \"ground\", layer = 2{}}}]",
                              layer == 1 ? ", k0 = 0.5" : "", layer == 2 ? ", k0 = 0.5" : ""));
    return complaint_about(polygons(all));
  };
  EXPECT_EQ(ground(1, {}), "");
  EXPECT_EQ(ground(1, {"fem.kinematics=finite", "construction.convention=float", "material.fill.law=rate"}), "");
  EXPECT_THAT(ground(1, {"fem.kinematics=finite", "construction.convention=float"}),
              AllOf(HasSubstr("\"hencky\" has no stress without strain"), HasSubstr("\"rate\"")));
  EXPECT_THAT(ground(2, {}), AllOf(HasSubstr("layer 2 is not level ground"), HasSubstr("0.5 m2 within 1 m by 1 m")));
}

TEST(Requirements, ASupportBesideTheBodyIsRefused) {
  exchange::Case study = polygons();
  study.supports[0].from = {0.0, -0.001};
  study.supports[0].to = {1.0, -0.001};
  EXPECT_THAT(complaint_about(study),
              AllOf(HasSubstr("support.0 holds no node of the mesh"), HasSubstr("from (0, -0.001) to (1, -0.001)"),
                    HasSubstr("corner to corner")));
}

TEST(Requirements, PolygonsThatCannotBeMeshedAreRefused) {
  exchange::Case study = polygons();
  study.geometry.polygons[1].corners = {{0, 1}, {1, 1}, {1, 1.5}, {0.5, 2}, {0, 1.5}};
  EXPECT_THAT(complaint_about(study), HasSubstr("divide it into triangles and quadrilaterals"));
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

TEST(Requirements, SoilsAreForSmallStrain) {
  exchange::Case study = column({});
  study.materials.at("fill").law = exchange::Law::tresca;
  study.materials.at("fill").cohesion = 10e3;
  EXPECT_EQ(complaint_about(study), "");
  study.fem.kinematics = exchange::Kinematics::finite;
  study.construction.convention = exchange::Convention::level_up;
  EXPECT_THAT(complaint_about(study), AllOf(HasSubstr("no law \"tresca\""), HasSubstr("\"small\"")));
}

TEST(Requirements, BBarIsForSmallStrain) {
  exchange::Case study = column({});
  study.fem.integration = exchange::FemIntegration::b_bar;
  EXPECT_EQ(complaint_about(study), "");
  study.fem.kinematics = exchange::Kinematics::finite;
  study.construction.convention = exchange::Convention::level_up;
  EXPECT_THAT(complaint_about(study), AllOf(HasSubstr("integrated in full"), HasSubstr("b-bar")));
}

TEST(Requirements, ABodyOfCamClayHasAttractionToStartFrom) {
  exchange::Case study = column({});
  exchange::Material& clay = study.materials.at("fill");
  clay.law = exchange::Law::cam_clay;
  clay.critical_state_slope = 1.2, clay.compression_index = 0.2, clay.swelling_index = 0.04;
  clay.void_ratio = 1.0, clay.preconsolidation_pressure = 50e3, clay.attraction = 0.0;
  EXPECT_THAT(complaint_about(study), HasSubstr("attraction = 0"));
  clay.attraction = 5e3;
  EXPECT_EQ(complaint_about(study), "");
}

} // namespace
} // namespace settle::fem::testing
