// Refill of what is drawn, from the case to the stages.

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "refilled_bodies.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::mpm::test {
namespace {

using testing::HasSubstr;

constexpr double designed_area = 2.0 * (2.0 + 8.0) / 2.0; // [m2]

class DrawnRefillInEveryScheme : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Mpm, DrawnRefillInEveryScheme, testing::Values("quasi-static", "explicit"),
                         [](const auto& scheme) { return scheme.param.substr(0, 5); });

/// Points come in the same order: polygons are filled row by row, as columns are.
TEST_P(DrawnRefillInEveryScheme, ADrawnRectangleIsRefilledAsAColumn) {
  for (const std::string basis : {"linear", "gimp"})
    for (const std::string law : {"rate", "hencky"}) {
      const Overrides overrides{"mpm.basis=" + basis, "mpm.scheme=" + GetParam()};
      const auto drawn = stages_of(refilled_rectangle(law, overrides)),
                 level = stages_of(refilled_column(law, overrides));
      ASSERT_EQ(drawn.size(), level.size());
      for (std::size_t i = 0; i < level.size(); ++i) {
        EXPECT_EQ(drawn[i].steps, level[i].steps);
        EXPECT_GT(level[i].mass_refilled, 0.0);
        EXPECT_NEAR(drawn[i].mass_refilled, level[i].mass_refilled, 1e-12 * level[i].mass);
        EXPECT_EQ(drawn[i].points.id, level[i].points.id);
        EXPECT_EQ(drawn[i].points.refilled, level[i].points.refilled);
        EXPECT_LT(relative_difference(drawn[i].points.position, level[i].points.position), 1e-12);
        EXPECT_LT(relative_difference(drawn[i].points.stress, level[i].points.stress), 1e-10);
      }
    }
}

/// The crest is flat; a row is an eighth of a metre high, and the gap that is left below half a percent of it. On the
/// slopes and beyond the toes there is more than designed where material has spread: nothing is taken away.
TEST_P(DrawnRefillInEveryScheme, AnEmbankmentStaysAtItsDesignedSurface) {
  const auto stages = stages_of(refilled_embankment("", {"mpm.scheme=" + GetParam()}));
  expect_audited(stages, GetParam() == "explicit" ? 1e-3 : 1e-9);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_GT(stages[i].mass_refilled, 0.0);
    EXPECT_NEAR(stages[i].surface_height, 0.5 * static_cast<double>(i + 1), 5e-3);
  }
  EXPECT_NEAR(volume_of(stages.back()), designed_area, 5e-3 * designed_area);
  const auto left_low =
      stages_of(refilled_embankment("", {"construction.convention=float", "mpm.scheme=" + GetParam()}));
  EXPECT_LT(left_low.back().surface_height, 1.9);
}

TEST(DrawnRefill, IsTheSameOnBothSidesOfASymmetricBody) {
  const exchange::SamplePoints points = stages_of(refilled_embankment("")).back().points;
  double moment = 0, mass = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    moment += points.density[p] * points.volume[p] * points.position[2 * p];
    mass += points.density[p] * points.volume[p];
  }
  EXPECT_NEAR(moment / mass, 0.0, 1e-4);
}

/// What brings no material is not refilled, though the surface settles; and what later stages add is theirs.
TEST(DrawnRefill, IsPartOfStagesThatBringMaterial) {
  const auto stages = stages_of(refilled_embankment(R"(
[[stage]]
action = "place"
layer = 1
[[stage]]
action = "place"
layer = 2
[[stage]]
action = "load"
from = [0.5, 1.0]
to = [-0.5, 1.0]
traction = [0.0, -2e3]
[[stage]]
action = "hold"
[[stage]]
action = "place"
layer = 3
[[stage]]
action = "place"
layer = 4
[[stage]]
action = "remove"
layer = 4
)",
                                                    {"material.fill.youngs_modulus=400e3"}));
  EXPECT_GT(stages[1].mass_refilled, 0.0);
  EXPECT_EQ(stages[2].mass_refilled, 0.0);
  EXPECT_EQ(stages[3].mass_refilled, 0.0);
  EXPECT_LT(volume_of(stages[2]), volume_of(stages[1]));
  EXPECT_GT(stages[4].mass_refilled, 0.0);
  EXPECT_EQ(stages[6].mass_refilled, 0.0);
  EXPECT_NEAR(stages[6].mass_placed, -(stages[5].mass_placed + stages[5].mass_refilled), 1e-9);
  double before = 0;
  for (const exchange::Stage& stage : stages) {
    EXPECT_NEAR(before + stage.mass_placed + stage.mass_refilled, stage.mass, 1e-12 * stage.mass);
    before = stage.mass;
  }
}

/// Probes are of the material placed with a layer: it settles under what is refilled above it.
TEST(DrawnRefill, LeavesProbesToWhatWasPlaced) {
  const auto drawn = stages_of(refilled_rectangle(
      "rate", {"probes.middle.from=[0.5, 0.0]", "probes.middle.to=[0.5, 2.0]", "probes.middle.points=9"}));
  const auto level = stages_of(refilled_column("rate", {"probes.middle.points_per_layer=3"}));
  const auto &own = drawn.back().probes.at("middle"), &reference = level.back().probes.at("middle");
  ASSERT_EQ(own.layer, reference.layer);
  EXPECT_LT(relative_difference(own.displacement, reference.displacement), 0.03);
  EXPECT_LT(relative_difference(own.stress, reference.stress), 0.03);
}

TEST(DrawnRefill, IsByRowsOfPoints) {
  EXPECT_THAT(complaint_about(refilled_embankment("", {"mpm.refill=element"})),
              HasSubstr("set mpm.refill = \"sub-element\""));
}

TEST(DrawnRefill, OfGroundIsItsOwn) {
  const auto stages = stages_of(exchange::parse_case(head_of_refilled("hencky") + R"(layers = 3
[geometry]
shape = "embankment"
dimension = 2
[geometry.embankment]
height = 1.0
crest = 2.0
slopes = [1.5, 1.5]
foundation_depth = 1.0
foundation_left = 1.0
foundation_right = 1.0
foundation_material = "fill"
)",
                                                     "foundation.toml", {}));
  expect_audited(stages, 1e-9);
  EXPECT_NEAR(stages[0].surface_height, 0.0, 1e-3);
  EXPECT_NEAR(volume_of(stages[0]), 7.0, 1e-3 * 7.0);
  EXPECT_NEAR(stages[2].surface_height, 1.0, 5e-3);
  for (const double displacement : stages[0].points.displacement)
    ASSERT_EQ(displacement, 0.0);
}

} // namespace
} // namespace settle::mpm::test
