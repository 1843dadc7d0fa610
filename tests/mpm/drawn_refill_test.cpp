// Refill of what is drawn, from the case to the stages.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "settle/exchange/case_io.hpp"
#include "solved_body.hpp"

namespace settle::mpm::test {
namespace {

using Overrides = std::vector<std::string>;
using testing::HasSubstr;

std::string head(const std::string& law) {
  return "format = 1\ngravity = 10.0\n[material.fill]\nlaw = \"" + law + R"("
youngs_modulus = 120e3
poissons_ratio = 0.25
density = 1720.0
[mpm]
element = "quadrilateral"
element_size = 0.25
[mpm.quasi_static]
increments = 10
[mpm.explicit]
relaxation = "viscous"
damping = 0.9
force_error = 1e-4
energy_error = 1e-4
[construction]
convention = "refill"
material = "fill"
)";
}

/// One metre wide, four layers of half a metre, between rollers.
exchange::Case column(const std::string& law, const Overrides& overrides) {
  return exchange::parse_case(head(law) + R"(layers = 4
[geometry]
shape = "column"
dimension = 2
height = 2.0
width = 1.0
)",
                              "column.toml", overrides);
}

/// The same, drawn.
exchange::Case drawn_column(const std::string& law, const Overrides& overrides) {
  std::string text = head(law) + "layers = 4\n[geometry]\nshape = \"polygons\"\ndimension = 2\n";
  for (int layer = 1; layer <= 4; ++layer) {
    const std::string low = std::to_string(0.5 * (layer - 1)), high = std::to_string(0.5 * layer);
    text += "[[geometry.polygon]]\nlayer = " + std::to_string(layer) + "\ncorners = [[0.0, " + low + "], [1.0, " + low +
            "], [1.0, " + high + "], [0.0, " + high + "]]\n";
  }
  return exchange::parse_case(text + R"(
[[support]]
from = [0.0, 2.0]
to = [0.0, 0.0]
held = "x"
[[support]]
from = [0.0, 0.0]
to = [1.0, 0.0]
held = "y"
[[support]]
from = [1.0, 0.0]
to = [1.0, 2.0]
held = "x"
)",
                              "polygons.toml", overrides);
}

/// 2 m high, 2 m wide at the crest, slopes of 1:1.5, on a rough base.
exchange::Case embankment(const std::string& stages, const Overrides& overrides = {}) {
  return exchange::parse_case(head("hencky") + R"(layers = 4
[geometry]
shape = "embankment"
dimension = 2
[geometry.embankment]
height = 2.0
crest = 2.0
slopes = [1.5, 1.5]
[probes.axis]
from = [0.0, 0.0]
to = [0.0, 2.0]
points = 9
)" + stages,
                              "embankment.toml", overrides);
}

constexpr double designed_area = 2.0 * (2.0 + 8.0) / 2.0; // [m2]

double area_of(const exchange::Stage& stage) {
  double area = 0;
  for (const double volume : stage.points.volume)
    area += volume;
  return area;
}

void expect_audited(const std::vector<exchange::Stage>& stages, double balance) {
  double before = 0;
  for (const exchange::Stage& stage : stages) {
    EXPECT_NEAR(before + stage.mass_placed + stage.mass_refilled, stage.mass, 1e-12 * stage.mass);
    EXPECT_NEAR(stage.base_reaction, stage.weight, balance * stage.weight);
    EXPECT_NEAR(stage.weight, 10.0 * stage.mass, 1e-12 * stage.weight);
    before = stage.mass;
  }
}

class DrawnRefillInEveryScheme : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Mpm, DrawnRefillInEveryScheme, testing::Values("quasi-static", "explicit"),
                         [](const auto& scheme) { return scheme.param.substr(0, 5); });

/// Points come in the same order: polygons are filled row by row, as columns are.
TEST_P(DrawnRefillInEveryScheme, ADrawnRectangleIsRefilledAsAColumn) {
  for (const std::string basis : {"linear", "gimp"})
    for (const std::string law : {"rate", "hencky"}) {
      const Overrides overrides{"mpm.basis=" + basis, "mpm.scheme=" + GetParam()};
      const auto drawn = stages_of(drawn_column(law, overrides)), level = stages_of(column(law, overrides));
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
  const auto stages = stages_of(embankment("", {"mpm.scheme=" + GetParam()}));
  expect_audited(stages, GetParam() == "explicit" ? 1e-3 : 1e-9);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_GT(stages[i].mass_refilled, 0.0);
    EXPECT_NEAR(stages[i].surface_height, 0.5 * static_cast<double>(i + 1), 5e-3);
  }
  EXPECT_NEAR(area_of(stages.back()), designed_area, 5e-3 * designed_area);
  const auto left_low = stages_of(embankment("", {"construction.convention=float", "mpm.scheme=" + GetParam()}));
  EXPECT_LT(left_low.back().surface_height, 1.9);
}

TEST(DrawnRefill, IsTheSameOnBothSidesOfASymmetricBody) {
  const exchange::SamplePoints points = stages_of(embankment("")).back().points;
  double moment = 0, mass = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    moment += points.density[p] * points.volume[p] * points.position[2 * p];
    mass += points.density[p] * points.volume[p];
  }
  EXPECT_NEAR(moment / mass, 0.0, 1e-4);
}

/// What brings no material is not refilled, though the surface settles; and what later stages add is theirs.
TEST(DrawnRefill, IsPartOfStagesThatBringMaterial) {
  const auto stages = stages_of(embankment(R"(
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
  EXPECT_LT(area_of(stages[2]), area_of(stages[1]));
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
  const auto drawn = stages_of(
      drawn_column("rate", {"probes.middle.from=[0.5, 0.0]", "probes.middle.to=[0.5, 2.0]", "probes.middle.points=9"}));
  const auto level = stages_of(column("rate", {"probes.middle.points_per_layer=3"}));
  const auto &own = drawn.back().probes.at("middle"), &reference = level.back().probes.at("middle");
  ASSERT_EQ(own.layer, reference.layer);
  EXPECT_LT(relative_difference(own.displacement, reference.displacement), 0.03);
  EXPECT_LT(relative_difference(own.stress, reference.stress), 0.03);
}

TEST(DrawnRefill, IsByRowsOfPoints) {
  EXPECT_THAT(complaint_about(embankment("", {"mpm.refill=element"})), HasSubstr("set mpm.refill = \"sub-element\""));
}

TEST(DrawnRefill, OfGroundIsItsOwn) {
  const auto stages = stages_of(exchange::parse_case(head("hencky") + R"(layers = 3
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
  EXPECT_NEAR(area_of(stages[0]), 7.0, 1e-3 * 7.0);
  EXPECT_NEAR(stages[2].surface_height, 1.0, 5e-3);
  for (const double displacement : stages[0].points.displacement)
    ASSERT_EQ(displacement, 0.0);
}

} // namespace
} // namespace settle::mpm::test
