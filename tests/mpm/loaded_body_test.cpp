// Loads on the surface of bodies in space: extruded sections, a dam across a valley, meshes of hexahedra.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_case.hpp"
#include "gmsh_text.hpp"
#include "settle/exchange/loaded_surface.hpp"

using namespace settle;
using namespace mpm::test;
using gmsh::Block;
using testing::HasSubstr;

namespace {

const std::string placed = stage("place", 1) + stage("place", 2);

Overrides in_space(Overrides overrides, const std::string& depth) {
  overrides.insert(overrides.end(), {"geometry.dimension=3", "geometry.depth=" + depth, "mpm.element=hexahedron",
                                     "mpm.points_per_element=8"});
  return overrides;
}

/// Of all supports, along an axis [N].
double reaction(const exchange::Stage& stage, std::size_t axis) {
  double sum = 0;
  for (std::size_t i = axis; i < stage.support_reactions.size(); i += 3)
    sum += stage.support_reactions[i];
  return sum;
}

/// Two layers, 1 m high, 1 m wide at the crest, in a valley with a floor of 1 m: 3 m along the crest.
exchange::Case dam(const std::string& stages, Overrides overrides = {}) {
  overrides.insert(overrides.end(),
                   {"geometry.dimension=3", "mpm.element=hexahedron",
                    "geometry.valley={ bottom = 1.0, slopes = [1.0, 1.0] }", "probes={}", "mpm.element_size=0.5"});
  return embankment(stages, overrides);
}

/// Of 1 m cells, on hexahedra of 0.5 m, drawn as designed.
exchange::Case block(const Block& counts, const std::string& stages, Overrides overrides = {},
                     const gmsh::Place& place = {}) {
  overrides.insert(overrides.end(), {"mpm.element=hexahedron", "construction.convention=drop"});
  return exchange::parse_case(
      gmsh::case_of(gmsh::solid_block(counts, place).text(), counts, "[mpm]\nelement_size = 0.5\n" + stages),
      "block.toml", overrides);
}

class LoadsInBothSchemes : public BothSchemes {};
INSTANTIATE_TEST_SUITE_P(Mpm, LoadsInBothSchemes,
                         testing::Values(SchemeOfTest{"quasi-static", 1e-7}, SchemeOfTest{"explicit", 1e-4}),
                         [](const auto& parameter) { return parameter.param.name.substr(0, 5); });

} // namespace

/// Part of the crest, ends within elements, and part of a slope; then built on: the load stays.
TEST_P(LoadsInBothSchemes, AnExtrudedBodyIsLoadedAsItsSection) {
  const std::string stages = stage("place", 1) + surface_load("[2e2, -2e3]", "[1.1, 0.5]", "[0.35, 0.5]") +
                             stage("place", 2) + surface_load("[0.0, -1e3]", "[-0.65, 0.9]", "[-1.7, 0.2]");
  for (const std::string depth : {"0.25", "0.75"}) {
    const auto section = stages_of(embankment(stages, scheme()));
    const auto body = stages_of(embankment(stages, in_space(scheme(), depth)));
    ASSERT_EQ(body.size(), section.size());
    const double on_crest = 2e3 * 0.75, on_slope = 1e3 * std::hypot(1.05, 0.7);
    const std::vector<double> loads{0.0, on_crest, on_crest, on_crest + on_slope};
    for (std::size_t i = 0; i < body.size(); ++i)
      expect_section_of(body[i], section[i], std::stod(depth), GetParam().balance, std::stod(depth) * loads[i]);
  }
}

/// Between smooth walls: p everywhere, and a compression of p/M; 2 m wide and 0.5 m deep.
TEST_P(LoadsInBothSchemes, AUniformLoadOnAColumnInSpaceIsFeltEverywhere) {
  Overrides overrides = in_space(scheme(), "0.5");
  overrides.emplace_back("material.fill.youngs_modulus=4e8"); // strains of 2e-5: small
  const auto stages = stages_of(box(2, placed + surface_load("[0.0, -1e4]") + hold, overrides));
  const exchange::SamplePoints &before = stages[1].points, &after = stages[2].points;
  for (std::size_t p = 0; p < before.size(); ++p)
    EXPECT_NEAR(after.stress[6 * p + 2] - before.stress[6 * p + 2], -1e4, 0.02 * 1e4);
  const double modulus = 4e8 * 0.75 / (1.25 * 0.5); // E (1 - nu)/((1 + nu)(1 - 2 nu))
  const double settled =
      stages[2].probes.at("middle").displacement.back() - stages[1].probes.at("middle").displacement.back();
  EXPECT_NEAR(settled, -1e4 / modulus, 0.01 * 1e4 / modulus);
  for (const std::size_t i : {2U, 3U})
    EXPECT_NEAR(stages[i].base_reaction, stages[i].weight + 1e4 * 2.0 * 0.5, GetParam().balance * stages[i].weight);
}

/// A crest of 1 m by 3 m; an upstream slope along which the valley narrows from 3 m to 1 m.
TEST_P(LoadsInBothSchemes, FloorAndFlanksCarryWhatIsOnADam) {
  const exchange::Case study = dam(placed + surface_load("[0.0, -2e3]", "[0.5, 1.0]", "[-0.5, 1.0]") +
                                       surface_load("[1e3, -5e2]", "[-0.5, 1.0]", "[-2.0, 0.0]"),
                                   scheme());
  const double slope = std::hypot(1.5, 1.0) * 2.0;
  EXPECT_NEAR(exchange::loaded_area(study, 3), 3.0, 1e-12);
  EXPECT_NEAR(exchange::loaded_area(study, 4), slope, 1e-12);
  const auto stages = stages_of(study);
  const double tolerance = GetParam().balance * stages[1].weight;
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight + 2e3 * 3.0, tolerance);
  EXPECT_NEAR(reaction(stages[2], 0), 0.0, tolerance);
  EXPECT_NEAR(stages[3].base_reaction, stages[3].weight + 2e3 * 3.0 + 5e2 * slope, tolerance);
  EXPECT_NEAR(reaction(stages[3], 0), -1e3 * slope, tolerance);
  EXPECT_NEAR(reaction(stages[3], 1), 0.0, tolerance);
}

/// One cell of 1 m2 of nine is loaded, pushed along y besides.
TEST_P(LoadsInBothSchemes, AMeshOfHexahedraCarriesALoadOnSomeOfItsSides) {
  Overrides overrides = scheme();
  overrides.insert(overrides.end(),
                   {"mpm.explicit.relaxation=viscous", "mpm.explicit.damping=0.9", "mpm.explicit.force_error=1e-5",
                    "mpm.explicit.energy_error=1e-5", "geometry.mesh.roller=[\"left\", \"right\", \"front\"]"});
  const Block counts{.across = 3, .deep = 3};
  const auto stages = stages_of(
      block(counts, placed + surface_load("[0.0, 3e3, -1e4]", "[1.0, 1.0, 2.0]", "[2.0, 2.0, 2.0]"), overrides));
  const double tolerance = GetParam().balance * stages[2].weight;
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight + 1e4, tolerance);
  EXPECT_NEAR(reaction(stages[2], 2), stages[2].base_reaction, tolerance);
  EXPECT_NEAR(reaction(stages[2], 1), -3e3, tolerance);
  EXPECT_NEAR(reaction(stages[2], 0), 0.0, tolerance);
}

/// Whole sides of cells that are whole elements: at nodes the loads are the same.
TEST(LoadedMeshOfHexahedra, IsItsSectionBetweenRollers) {
  const Overrides direct{"mpm.quasi_static.linear_solver=direct"};
  const Block counts{.across = 2, .deep = 1};
  const auto solid =
      stages_of(block(counts, placed + surface_load("[1e3, 0.0, -1e4]", "[1.0, 0.0, 2.0]", "[2.0, 1.0, 2.0]"), direct));
  Overrides extruded = in_space(direct, "1");
  extruded.emplace_back("construction.convention=drop");
  const auto section = stages_of(exchange::parse_case(
      gmsh::case_of(gmsh::plane_block({}).text(), {},
                    "[mpm]\nelement_size = 0.5\n" + placed + surface_load("[1e3, -1e4]", "[2.0, 2.0]", "[1.0, 2.0]")),
      "section.toml", extruded));
  const auto sizes = [](const exchange::Stage& stage) { // points come in another order
    std::vector<double> lengths;
    for (std::size_t p = 0; p < stage.points.size(); ++p) {
      const double* moved = &stage.points.displacement[3 * p];
      lengths.push_back(std::hypot(moved[0], moved[1], moved[2]));
    }
    std::sort(lengths.begin(), lengths.end());
    return lengths;
  };
  EXPECT_LT(relative_difference(sizes(solid[2]), sizes(section[2])), 1e-8);
  EXPECT_GT(relative_difference(sizes(solid[1]), sizes(section[2])), 0.1) << "the load is felt";
}

/// Sides at an angle to the grid, on one that cuts them.
TEST(LoadedMeshOfHexahedra, CarriesALoadOnASlope) {
  const auto form = [](std::array<double, 3>& node) { node[0] = (node[0] - 1.5) * (1.4 - 0.3 * node[2]); };
  const Block counts{.across = 3, .deep = 2};
  const exchange::Case study =
      block(counts, placed + surface_load("[0.0, 0.0, -1e4]", "[2.1, 0.0, 0.0]", "[1.2, 2.0, 2.0]"),
            {"mpm.element_size=0.4", "geometry.mesh.roller=[\"front\", \"back\"]"}, form);
  const double area = 2.0 * std::hypot(0.9, 2.0);
  EXPECT_NEAR(exchange::loaded_area(study, 3), area, 1e-12);
  const auto stages = stages_of(study);
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight + 1e4 * area, 1e-7 * stages[2].weight);
}

TEST(LoadedMeshOfHexahedra, KeepsTheLayersThatCarryALoad) {
  const exchange::Case study =
      block({.across = 1, .deep = 1},
            placed + surface_load("[0.0, 0.0, -1.0]", "[0.0, 0.0, 2.0]", "[1.0, 1.0, 2.0]") + stage("remove", 2));
  EXPECT_THAT(complaint_about(study), HasSubstr("layer 2 is taken away with a load on it"));
}
