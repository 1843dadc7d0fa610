// A dam across a valley, from the case to the stages.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/valley.hpp"
#include "solved_body.hpp"

using namespace settle;
using namespace mpm::test;
using testing::HasSubstr;

namespace {

using Overrides = std::vector<std::string>;

constexpr double density = 1720.0, gravity = 10.0; // kg/m3, m/s2

/// Two layers, 1 m high, 1 m wide at the crest, in a valley with a floor of 1 m.
exchange::Case dam(const Overrides& overrides = {}, const std::string& stages = {}) {
  return exchange::parse_case(R"(
format = 1
gravity = 10.0
[geometry]
shape = "embankment"
dimension = 3
[geometry.embankment]
height = 1.0
crest = 1.0
slopes = [1.5, 1.5]
[geometry.valley]
bottom = 1.0
slopes = [1.0, 1.0]
[material.fill]
law = "rate"
youngs_modulus = 4e6
poissons_ratio = 0.25
density = 1720.0
[mpm]
element = "hexahedron"
element_size = 0.25
[mpm.quasi_static]
increments = 2
[mpm.explicit]
relaxation = "viscous"
damping = 0.9
force_error = 1e-5
energy_error = 1e-5
[construction]
convention = "float"
material = "fill"
layers = 2
[probes.axis]
from = [0.0, 0.0, 0.0]
to = [0.0, 0.0, 1.0]
points = 5
[probes.across]
from = [0.0, -1.2, 0.7]
to = [0.0, 1.2, 0.7]
points = 7
[probes.along]
from = [-0.9, 0.0, 0.7]
to = [0.9, 0.0, 0.7]
points = 7
)" + stages,
                              "dam.toml", overrides);
}

/// The displacements of a line, from its end to its start, one component turned round.
std::vector<double> mirrored(const std::vector<double>& displacement, std::size_t turned) {
  std::vector<double> other;
  for (std::size_t i = displacement.size() / 3; i-- > 0;)
    for (std::size_t c = 0; c < 3; ++c)
      other.push_back((c == turned ? -1.0 : 1.0) * displacement[3 * i + c]);
  return other;
}

/// Sum of volume times displacement along an axis [m4].
double moment(const exchange::Stage& stage, std::size_t axis) {
  double sum = 0;
  for (std::size_t p = 0; p < stage.points.size(); ++p)
    sum += stage.points.volume[p] * stage.points.displacement[3 * p + axis];
  return sum;
}

/// x, z and displacement of the points nearest to a plane y, in the order of their sections [m].
std::vector<std::array<double, 4>> section_at(const exchange::Stage& stage, double y, double reach) {
  std::vector<std::array<double, 4>> section;
  const exchange::SamplePoints& points = stage.points;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double* placed = &points.placed_position[3 * p];
    const double* moved = &points.displacement[3 * p];
    if (placed[1] > y && placed[1] < y + reach) section.push_back({placed[0], placed[2], moved[0], moved[2]});
  }
  std::sort(section.begin(), section.end(), [](const auto& a, const auto& b) {
    return std::lround(1e6 * a[0]) != std::lround(1e6 * b[0]) ? a[0] < b[0] : a[1] < b[1];
  });
  return section;
}

} // namespace

/// As drawn, the volume is that of the design to round-off; what holds the dam carries its weight.
TEST(DamAcrossAValley, WeighsWhatItsVolumeDoesAndStandsOnFloorAndFlanks) {
  for (const Overrides& overrides :
       {Overrides{}, Overrides{"geometry.valley.bottom=0", "geometry.valley.slopes=[1.5, 0.7]", "mpm.element_size=0.2"},
        Overrides{"geometry.embankment.slopes=[1.0, 0.0]", "mpm.basis=gimp",
                  "mpm.quasi_static.linear_solver=direct"}}) {
    Overrides drawn = overrides;
    drawn.emplace_back("construction.convention=drop");
    const exchange::Case study = dam(drawn);
    const auto stages = stages_of(study);
    double mass = 0.0;
    for (int layer = 1; layer <= 2; ++layer) {
      const exchange::Stage& stage = stages.at(static_cast<std::size_t>(layer - 1));
      mass += density * exchange::layer_volume(study.geometry, layer);
      EXPECT_NEAR(stage.mass, mass, 1e-12 * mass);
      EXPECT_NEAR(stage.weight, gravity * mass, 1e-12 * stage.weight);
      EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-7 * stage.weight);
      EXPECT_NEAR(stage.support_reactions.at(2), stage.weight, 1e-7 * stage.weight);
      EXPECT_NEAR(stage.support_reactions.at(0), 0.0, 1e-7 * stage.weight) << "nothing pushes it downstream";
      EXPECT_NEAR(stage.support_reactions.at(1), 0.0, 1e-7 * stage.weight);
    }
  }
}

/// Probes and layers are fitted through so many nearest points, of which equal ones may lie on one side.
TEST(DamAcrossAValley, IsSymmetricWhereItsDesignIs) {
  const auto drawn = stages_of(dam({"construction.convention=drop"})).back();
  EXPECT_LT(std::abs(moment(drawn, 0)) + std::abs(moment(drawn, 1)), 1e-6 * std::abs(moment(drawn, 2)));
  const auto stage = stages_of(dam()).back();
  const auto &across = stage.probes.at("across").displacement, &along = stage.probes.at("along").displacement;
  EXPECT_LT(relative_difference(mirrored(across, 1), across), 1e-3);
  EXPECT_LT(relative_difference(mirrored(along, 0), along), 1e-3);
}

/// Settles by 1 % of its height. Probes are fits: they smooth where the surface is curved.
TEST(DamAcrossAValley, PlacesLayersOnWhatHasSettledAndUpToTheirLevel) {
  const exchange::Case design = dam();
  const double second = density * exchange::layer_volume(design.geometry, 2);
  const auto top = [&](const std::string& convention) {
    const exchange::Stage stage = stages_of(dam({"construction.convention=" + convention, "gravity=200.0"})).back();
    const exchange::ProbeSamples& axis = stage.probes.at("axis");
    return std::pair(axis.placed_position.back(), stage.mass_placed);
  };
  const auto [as_drawn, mass_as_drawn] = top("drop");
  const auto [floating, mass_floating] = top("float");
  const auto [level, mass_level] = top("level-up");
  EXPECT_NEAR(as_drawn, 1.0, 1e-12);
  EXPECT_NEAR(mass_as_drawn, second, 1e-12 * second);
  const exchange::Stage first = stages_of(dam({"gravity=200.0"})).front();
  const double settled = -first.probes.at("axis").displacement.back();
  EXPECT_GT(settled, 0.003);
  EXPECT_NEAR(level, 1.0, 1e-3 * settled);
  EXPECT_NEAR(floating, 1.0 - settled, 0.03 * settled);
  EXPECT_NEAR(mass_floating, second, 0.1 * (mass_level - second)) << "moved, not stretched";
  EXPECT_GT(mass_level, second * (1.0 + 0.2 * settled / 0.5)) << "settled most in the middle, not at the flanks";
  EXPECT_LT(mass_level, second * (1.0 + settled / 0.5));
}

/// Eight times as wide as high, between rough walls: in the middle they are not felt. Point by point, where both have
/// the same points.
TEST(DamAcrossAValley, IsItsSectionFarFromVerticalFlanks) {
  const exchange::Case wide = dam({"geometry.valley.bottom=8.0", "geometry.valley.slopes=[0.0, 0.0]",
                                   "geometry.embankment.slopes=[1.0, 1.0]", "construction.convention=drop"});
  exchange::Case extruded = wide;
  extruded.geometry.valley.reset();
  extruded.geometry.depth = 0.5;
  extruded.probes.clear();
  const auto body = stages_of(wide), section = stages_of(extruded);
  for (std::size_t stage = 0; stage < 2; ++stage) {
    const auto own = section_at(body[stage], 0.0, 0.125), reference = section_at(section[stage], 0.25, 0.125);
    ASSERT_EQ(own.size(), reference.size());
    std::vector<double> moved, reference_moved;
    for (std::size_t i = 0; i < own.size(); ++i) {
      ASSERT_NEAR(own[i][0], reference[i][0], 1e-9);
      ASSERT_NEAR(own[i][1], reference[i][1], 1e-9);
      moved.insert(moved.end(), {own[i][2], own[i][3]});
      reference_moved.insert(reference_moved.end(), {reference[i][2], reference[i][3]});
    }
    EXPECT_LT(relative_difference(moved, reference_moved), 1e-3);
    EXPECT_NEAR(body[stage].mass, 16.0 * section[stage].mass, 1e-10 * body[stage].mass);
  }
}

TEST(DamAcrossAValley, ComesToTheSameRestExplicitly) {
  const auto quasi_static = stages_of(dam());
  const auto in_time = stages_of(dam({"mpm.scheme=explicit"}));
  const auto &value = in_time.back().probes.at("axis"), &reference = quasi_static.back().probes.at("axis");
  EXPECT_LT(relative_difference(value.displacement, reference.displacement), 2e-3);
  EXPECT_NEAR(in_time.back().base_reaction, in_time.back().weight, 1e-4 * in_time.back().weight);
}

TEST(DamAcrossAValley, IsWithoutItsLastLayerWhatItWasBefore) {
  const std::string stages = "[[stage]]\nlayer = 1\n[[stage]]\nlayer = 2\n[[stage]]\naction = \"remove\"\nlayer = 2\n";
  const auto states = stages_of(dam({"material.fill.youngs_modulus=4e9"}, stages));
  EXPECT_NEAR(states[2].mass, states[0].mass, 1e-12 * states[0].mass);
  EXPECT_LT(relative_difference(states[2].probes.at("axis").displacement, states[0].probes.at("axis").displacement),
            1e-4);
}

TEST(DamAcrossAValley, IsOfHexahedra) {
  EXPECT_THAT(complaint_about(dam({"mpm.element=tetrahedron"})), HasSubstr("hexahedron"));
}
