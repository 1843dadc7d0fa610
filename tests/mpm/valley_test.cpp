// A dam across a valley, from the case to the stages.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/valley.hpp"
#include "settle/mpm/solver.hpp"

using namespace settle;
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

std::vector<exchange::Stage> solved(const exchange::Case& study) {
  std::vector<exchange::Stage> stages;
  mpm::solve(study, [&](const exchange::Stage& stage) { stages.push_back(stage); });
  return stages;
}

/// Relative difference in the Euclidean norm.
double relative_difference(const std::vector<double>& value, const std::vector<double>& reference) {
  EXPECT_EQ(value.size(), reference.size());
  double sum = 0, scale = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    sum += std::pow(value[i] - reference[i], 2);
    scale += std::pow(reference[i], 2);
  }
  return std::sqrt(sum / scale);
}

std::string refusal_of(const exchange::Case& study) {
  try {
    static_cast<void>(solved(study));
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return {};
}

/// The displacements of a line, from its end to its start, one component turned round.
std::vector<double> mirrored(const std::vector<double>& displacement, std::size_t turned) {
  std::vector<double> other;
  for (std::size_t i = displacement.size() / 3; i-- > 0;)
    for (std::size_t c = 0; c < 3; ++c)
      other.push_back((c == turned ? -1.0 : 1.0) * displacement[3 * i + c]);
  return other;
}

} // namespace

/// As drawn, the volume is that of the design to round-off; what holds the dam carries its weight.
TEST(DamAcrossAValley, WeighsWhatItsVolumeDoesAndStandsOnFloorAndFlanks) {
  for (const Overrides& overrides :
       {Overrides{}, Overrides{"geometry.valley.bottom=0", "geometry.valley.slopes=[1.5, 0.7]", "mpm.element_size=0.2"},
        Overrides{"geometry.embankment.slopes=[1.0, 0.0]", "mpm.basis=gimp"}}) {
    Overrides drawn = overrides;
    drawn.emplace_back("construction.convention=drop");
    const exchange::Case study = dam(drawn);
    const auto stages = solved(study);
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

TEST(DamAcrossAValley, IsSymmetricWhereItsDesignIs) {
  const auto stage = solved(dam()).back();
  const auto &across = stage.probes.at("across").displacement, &along = stage.probes.at("along").displacement;
  EXPECT_LT(relative_difference(mirrored(across, 1), across), 1e-6);
  EXPECT_LT(relative_difference(mirrored(along, 0), along), 1e-6);
}

/// Of the settlement of 2e-3 of the height.
TEST(DamAcrossAValley, PlacesLayersOnWhatHasSettledAndUpToTheirLevel) {
  const exchange::Case design = dam();
  const double second = density * exchange::layer_volume(design.geometry, 2);
  const auto top = [&](const std::string& convention) {
    const exchange::Stage stage = solved(dam({"construction.convention=" + convention, "gravity=200.0"})).back();
    const exchange::ProbeSamples& axis = stage.probes.at("axis");
    return std::pair(axis.placed_position.back(), stage.mass_placed);
  };
  const auto [as_drawn, mass_as_drawn] = top("drop");
  const auto [floating, mass_floating] = top("float");
  const auto [level, mass_level] = top("level-up");
  EXPECT_NEAR(as_drawn, 1.0, 1e-12);
  EXPECT_NEAR(mass_as_drawn, second, 1e-12 * second);
  EXPECT_NEAR(level, 1.0, 1e-9);
  const exchange::Stage first = solved(dam({"gravity=200.0"})).front();
  const double settled = -first.probes.at("axis").displacement.back();
  EXPECT_GT(settled, 0.003);
  EXPECT_NEAR(floating, 1.0 - settled, 0.01 * settled);
  EXPECT_NEAR(mass_floating, second, 0.1 * (mass_level - second)) << "moved, not stretched";
  EXPECT_GT(mass_level, second * (1.0 + 0.2 * settled / 0.5)) << "settled most in the middle, not at the flanks";
  EXPECT_LT(mass_level, second * (1.0 + settled / 0.5));
}

/// Eight times as wide as high, between rough walls: in the middle they are not felt.
TEST(DamAcrossAValley, IsItsSectionFarFromVerticalFlanks) {
  const Overrides wide{"geometry.valley.bottom=8.0", "geometry.valley.slopes=[0.0, 0.0]"};
  const auto body = solved(dam(wide));
  const exchange::Case study = dam(wide);
  exchange::Case section = study;
  section.geometry.valley.reset();
  section.geometry.depth = 0.5;
  section.probes = {{"axis", {.from = {0.0, 0.0}, .to = {0.0, 1.0}, .points = 5}}};
  const auto reference = solved(section);
  for (std::size_t stage = 0; stage < 2; ++stage) {
    EXPECT_LT(relative_difference(body[stage].probes.at("axis").displacement,
                                  reference[stage].probes.at("axis").displacement),
              1e-3);
    EXPECT_NEAR(body[stage].mass, 16.0 * reference[stage].mass, 1e-3 * body[stage].mass);
  }
}

TEST(DamAcrossAValley, ComesToTheSameRestExplicitly) {
  const auto quasi_static = solved(dam());
  const auto in_time = solved(dam({"mpm.scheme=explicit"}));
  const auto &value = in_time.back().probes.at("axis"), &reference = quasi_static.back().probes.at("axis");
  EXPECT_LT(relative_difference(value.displacement, reference.displacement), 2e-3);
  EXPECT_NEAR(in_time.back().base_reaction, in_time.back().weight, 1e-4 * in_time.back().weight);
}

TEST(DamAcrossAValley, IsWithoutItsLastLayerWhatItWasBefore) {
  const std::string stages = "[[stage]]\nlayer = 1\n[[stage]]\nlayer = 2\n[[stage]]\naction = \"remove\"\nlayer = 2\n";
  const auto states = solved(dam({"material.fill.youngs_modulus=4e9"}, stages));
  EXPECT_NEAR(states[2].mass, states[0].mass, 1e-12 * states[0].mass);
  EXPECT_LT(relative_difference(states[2].probes.at("axis").displacement, states[0].probes.at("axis").displacement),
            1e-4);
}

TEST(DamAcrossAValley, IsOfHexahedraAndItsSurfaceIsNotLoaded) {
  const std::string stages = "[[stage]]\nlayer = 1\n[[stage]]\nlayer = 2\n";
  const std::string load =
      "[[stage]]\naction = \"load\"\nfrom = [0.5, 1.0]\nto = [-0.5, 1.0]\ntraction = [0.0, -1e3]\n";
  EXPECT_THAT(refusal_of(dam({"mpm.element=tetrahedron"})), HasSubstr("hexahedron"));
  EXPECT_THAT(refusal_of(dam({}, stages + load)), HasSubstr("leave the stage out"));
}
