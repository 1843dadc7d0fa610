// Loads on the surface of bodies in space: a dam across a valley, meshes of hexahedra.
#include <cmath>

#include <gtest/gtest.h>

#include "dams.hpp"
#include "frozen_column.hpp"
#include "gmsh_text.hpp"
#include "settle/exchange/loaded_surface.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Stage;
using gmsh::Block;

constexpr const char* placed = "[[stage]]\nlayer = 1\n[[stage]]\nlayer = 2\n";

std::string load(const std::string& from, const std::string& to, const std::string& traction) {
  return fmt::format("[[stage]]\naction = \"load\"\nfrom = {}\nto = {}\ntraction = {}\n", from, to, traction);
}

exchange::Case block(const Block& counts, const std::string& more, const std::vector<std::string>& overrides = {}) {
  return exchange::parse_case(gmsh::case_of(gmsh::solid_block(counts).text(), counts, more), "block.toml", overrides);
}

} // namespace

/// Parts of the crest, 7 m along, and of a slope of cells in all directions, whose ends are lines of no cell.
TEST(LoadedDamInAValley, RestsOnFloorAndFlanksWithItsWeightAndItsLoads) {
  for (const exchange::Kinematics kinematics : {exchange::Kinematics::small, exchange::Kinematics::finite}) {
    exchange::Case study = dam({.kinematics = kinematics, .element_size = 1.0});
    study.stages.push_back({.action = exchange::Action::load,
                            .layer = 3,
                            .from = {0.83, 3.0},
                            .to = {-0.31, 3.0},
                            .traction = {0.0, -1e4}});
    study.stages.push_back({.action = exchange::Action::load,
                            .layer = 3,
                            .from = {-1.3, 2.8},
                            .to = {-4.9, 0.4},
                            .traction = {5e3, -1e4}});
    const double crest = 1.14 * 7.0, slope = std::hypot(3.6, 2.4) * 0.5 * (6.6 + 1.8);
    EXPECT_NEAR(exchange::loaded_area(study, 4), crest, 1e-12);
    EXPECT_NEAR(exchange::loaded_area(study, 5), slope, 1e-12);
    const std::vector<Stage> stages = solve(study);
    // tractions are per area as placed: at finite strain layers have settled when the next one comes
    const double tolerance = (kinematics == exchange::Kinematics::small ? 1e-9 : 1e-3) * stages[3].weight;
    EXPECT_NEAR(stages[3].base_reaction, stages[3].weight + 1e4 * crest, tolerance);
    EXPECT_NEAR(stages[4].base_reaction, stages[4].weight + 1e4 * (crest + slope), tolerance);
    EXPECT_NEAR(stages[4].support_reactions[0], -5e3 * slope, tolerance);
    EXPECT_NEAR(stages[4].support_reactions[1], 0.0, 1e-9 * stages[4].weight);
  }
}

/// Compressed by p/M besides.
TEST(LoadedMeshOfHexahedra, IsAColumnUnderAnEvenLoad) {
  const exchange::Case study =
      block({.across = 1, .deep = 1}, placed + load("[0, 0, 2]", "[1, 1, 2]", "[0, 0, -1e4]") +
                                          "[probes.axis]\nfrom = [0.5, 0.5, 0]\nto = [0.5, 0.5, 2]\npoints = 3\n");
  const std::vector<Stage> stages = solve(study);
  const auto &before = stages[1].probes.at("axis"), &after = stages[2].probes.at("axis");
  const double strain = 1e4 / 48e6;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double height = vertical(after.design_position, i, 3);
    EXPECT_NEAR(vertical(after.displacement, i, 3) - vertical(before.displacement, i, 3), -strain * height, 1e-14);
  }
  EXPECT_NEAR(stages[2].base_reaction, stages[2].weight + 1e4, 1e-8);
}

/// On the uppermost side only of a cell in the middle of nine, pushed along y; a layer on it takes no load off.
TEST(LoadedMeshOfHexahedra, CarriesALoadOnSomeOfItsSides) {
  const exchange::Case study =
      block({.across = 3, .deep = 3, .layers = 3},
            placed + load("[1, 1, 2]", "[2, 2, 2]", "[0, 3e3, -1e4]") + "[[stage]]\nlayer = 3\n",
            {"geometry.mesh.roller=[\"left\", \"right\", \"front\"]"});
  const std::vector<Stage> stages = solve(study);
  for (const std::size_t i : {2U, 3U}) {
    const Stage& stage = stages[i];
    EXPECT_NEAR(stage.base_reaction, stage.weight + 1e4, 1e-9 * stage.weight);
    double across = 0.0;
    for (std::size_t b = 0; b < 4; ++b)
      across += stage.support_reactions[3 * b + 1];
    EXPECT_NEAR(across, -3e3, 1e-9 * stage.weight);
  }
}

TEST(LoadedMeshOfHexahedra, IsItsSectionBetweenRollers) {
  const Block counts{.across = 2, .deep = 1};
  const exchange::Case solid = block(counts, placed + load("[1, 0, 2]", "[2, 1, 2]", "[1e3, 0, -1e4]") +
                                                 "[probes.axis]\nfrom = [0.5, 0.5, 0]\nto = [0.5, 0.5, 2]\n");
  const exchange::Case section =
      exchange::parse_case(gmsh::case_of(gmsh::plane_block({}).text(), {},
                                         placed + load("[2, 2]", "[1, 2]", "[1e3, -1e4]") +
                                             "[probes.axis]\nfrom = [0.5, 0]\nto = [0.5, 2]\n"),
                           "section.toml", {"geometry.dimension=3", "geometry.depth=1", "fem.element_size=1"});
  const Stage body = solve(solid).back(), extruded = solve(section).back();
  const auto &own = body.probes.at("axis"), &reference = extruded.probes.at("axis");
  ASSERT_EQ(own.size(), reference.size());
  for (std::size_t i = 0; i < own.displacement.size(); ++i)
    EXPECT_NEAR(own.displacement[i], reference.displacement[i], 1e-14);
}

} // namespace settle::fem::testing
