// Meshes by Gmsh, from the case to the stages.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gmsh_text.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "solved_body.hpp"

using namespace settle;
using namespace mpm::test;
using gmsh::Block;
using testing::HasSubstr;

namespace {

using Overrides = std::vector<std::string>;
using Position = std::array<double, 3>;

constexpr double unit_weight = 20e3, constrained_modulus = 48e6; // N/m3, Pa

constexpr const char* of_mpm = R"(
[mpm]
element_size = 0.5
[mpm.quasi_static]
increments = 2
)";

exchange::Case read(const gmsh::File& mesh, const Block& counts, Overrides overrides = {},
                    const std::string& more = {}) {
  overrides.push_back(counts.deep > 0 ? "mpm.element=hexahedron" : "mpm.element=quadrilateral");
  return exchange::parse_case(gmsh::case_of(mesh.text(), counts, of_mpm + more), "block.toml", overrides);
}

/// 4 m wide at the base, with slopes; its cells are nothing to the material point method.
void make_bank(Position& node) {
  node[0] = (node[0] - 2.0) * (1.0 - 0.2 * node[1]) + (node[0] == 1.0 && node[1] == 1.0 ? 0.2 : 0.0);
}

const std::string axis_in_plane = "[probes.axis]\nfrom = [0.5, 0]\nto = [0.5, 2]\npoints = 9\n";
const std::string axis_in_space = "[probes.axis]\nfrom = [0.5, 0.5, 0]\nto = [0.5, 0.5, 2]\npoints = 9\n";

/// Two layers of 1 m between rollers, each compressed by its own weight and by what comes on it.
void expect_column(const exchange::Stage& last, std::size_t dim) {
  const double unit = unit_weight / constrained_modulus;
  const exchange::ProbeSamples& axis = last.probes.at("axis");
  ASSERT_GT(axis.size(), 4U);
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const double y = axis.design_position[dim * i + dim - 1] - (axis.layer[i] - 1);
    const double own = y * (1.0 - y / 2.0), above = axis.layer[i] == 1 ? y : 1.0;
    EXPECT_NEAR(axis.displacement[dim * i + dim - 1], -unit * (own + above), 0.03 * 2.0 * unit);
  }
}

} // namespace

TEST(MeshOfAColumn, SettlesAsTheClosedForm) {
  expect_column(stages_of(read(gmsh::plane_block({}), {}, {"mpm.element_size=0.125"}, axis_in_plane)).back(), 2);
  const Block counts{.across = 1, .deep = 1};
  expect_column(stages_of(read(gmsh::solid_block(counts), counts, {"mpm.element_size=0.25"}, axis_in_space)).back(), 3);
}

/// By convention of construction.
class MeshOfABank : public ::testing::TestWithParam<std::string> {};

TEST_P(MeshOfABank, IsTheSameAsItsOutlineDrawn) {
  const exchange::Case study =
      read(gmsh::plane_block({.across = 4}, make_bank), {.across = 4},
           {"geometry.mesh.roller=[]", "construction.convention=" + GetParam(), "material.fill.youngs_modulus=1e5"},
           axis_in_plane);
  exchange::Case drawn = study;
  drawn.geometry.shape = exchange::Shape::polygons;
  drawn.geometry.mesh.reset();
  drawn.geometry.polygons = {{.layer = 1, .corners = {{-2, 0}, {2, 0}, {1.6, 1}, {-1.6, 1}}},
                             {.layer = 2, .corners = {{-1.6, 1}, {1.6, 1}, {1.2, 2}, {-1.2, 2}}}};
  drawn.supports = {{.from = {-2, 0}, .to = {2, 0}}};
  const auto meshed = stages_of(study), polygons = stages_of(drawn);
  ASSERT_EQ(meshed.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(relative_difference(meshed[k].points.volume, polygons[k].points.volume), 1e-12);
    EXPECT_LT(relative_difference(meshed[k].points.displacement, polygons[k].points.displacement), 1e-9);
    EXPECT_LT(relative_difference(meshed[k].points.stress, polygons[k].points.stress), 1e-9);
    EXPECT_NEAR(meshed[k].base_reaction, meshed[k].weight, 1e-8 * meshed[k].weight);
  }
  EXPECT_NEAR(meshed[0].mass_placed, 2000.0 * 3.6, 1e-9);
  EXPECT_EQ(meshed[1].mass_refilled > 0.0, GetParam() == "refill");
}
INSTANTIATE_TEST_SUITE_P(All, MeshOfABank, ::testing::Values("level-up", "refill"), [](const auto& parameter) {
  return parameter.param == "refill" ? std::string("refilled") : std::string("levelled");
});

/// Displacements of all points, by the places where they were placed.
std::vector<double> in_order(const exchange::SamplePoints& points) {
  std::map<std::array<long, 3>, std::size_t> order;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto at = [&](std::size_t axis) { return std::lround(1e5 * points.placed_position[3 * p + axis]); };
    order[{at(0), at(1), at(2)}] = p;
  }
  std::vector<double> displacement;
  for (const auto& [place, p] : order)
    displacement.insert(displacement.end(), points.displacement.begin() + static_cast<std::ptrdiff_t>(3 * p),
                        points.displacement.begin() + static_cast<std::ptrdiff_t>(3 * p + 3));
  return displacement;
}

/// By convention of construction.
class MeshOfACuboid : public ::testing::TestWithParam<std::string> {};

/// One metre deep between rollers: the same points as of the section that is extruded, in another order.
TEST_P(MeshOfACuboid, IsItsSectionBetweenRollers) {
  const Block counts{.across = 2, .deep = 1};
  const Overrides direct{"mpm.quasi_static.linear_solver=direct", "construction.convention=" + GetParam(),
                         "mpm.element=hexahedron", "material.fill.youngs_modulus=1e6"};
  const exchange::Case solid = read(gmsh::solid_block(counts), counts, direct);
  Overrides extruded = direct;
  extruded.insert(extruded.end(), {"geometry.dimension=3", "geometry.depth=1"});
  const exchange::Case section =
      exchange::parse_case(gmsh::case_of(gmsh::plane_block({}).text(), {}, of_mpm), "section.toml", extruded);
  const auto body = stages_of(solid), drawn = stages_of(section);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(body[k].points.size(), drawn[k].points.size());
    EXPECT_NEAR(body[k].mass, drawn[k].mass, 1e-11 * drawn[k].mass);
    EXPECT_LT(relative_difference(in_order(body[k].points), in_order(drawn[k].points)), 1e-9);
    EXPECT_EQ(body[k].mass_refilled > 0.0, GetParam() == "refill");
  }
}
INSTANTIATE_TEST_SUITE_P(All, MeshOfACuboid, ::testing::Values("drop", "refill"),
                         [](const auto& parameter) { return parameter.param; });

/// Two strata of their own ratios; then nothing moves.
TEST(MeshOfHexahedra, StartsAsGroundWithTheStressOfItsDepth) {
  const Block counts{.across = 2, .deep = 1};
  for (const std::string scheme : {"mpm.scheme=quasi-static", "mpm.scheme=explicit"}) {
    const auto stages = stages_of(read(gmsh::solid_block(counts), counts, {scheme},
                                       "[[stage]]\naction = \"ground\"\nlayer = 1\nk0 = 0.7\n"
                                       "[[stage]]\naction = \"ground\"\nlayer = 2\nk0 = 0.4\n"
                                       "[[stage]]\naction = \"hold\"\n"));
    const exchange::SamplePoints& points = stages[2].points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double upward = -unit_weight * (2.0 - points.placed_position[3 * p + 2]);
      const double across = (points.layer[p] == 1 ? 0.7 : 0.4) * upward;
      const std::vector<double> expected{across, across, upward, 0.0, 0.0, 0.0};
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(points.stress[6 * p + c], expected[c], 1e-9 * 2.0 * unit_weight);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(points.displacement[3 * p + c], 0.0, 1e-13);
    }
    EXPECT_NEAR(stages[2].base_reaction, stages[2].weight, 1e-9 * stages[2].weight);
  }
}

TEST(MeshOfHexahedra, BulgesWhereItIsFree) {
  const Block counts{.across = 1, .deep = 1, .layers = 1};
  const auto stages = stages_of(read(gmsh::solid_block(counts), counts, {"geometry.mesh.roller=[\"left\", \"right\"]"},
                                     "[probes.through]\nfrom = [0.5, 0, 0.75]\nto = [0.5, 1, 0.75]\npoints = 2\n"));
  const std::vector<double> through = stages.back().probes.at("through").displacement;
  EXPECT_LT(through[1], -1e-6);
  EXPECT_NEAR(through[4], -through[1], 1e-3 * std::abs(through[1]));
}

class MeshInSpace : public ::testing::TestWithParam<std::string> {
protected:
  /// Slopes along x and flanks along y, all of them at an angle to the grid.
  static exchange::Case study(const std::string& convention) {
    const Block counts{.across = 3, .deep = 2};
    const auto form = [](Position& node) {
      const auto [x, y, z] = node;
      node = {(x - 1.5) * (1.4 - 0.3 * z), (y - 1.0) * (1.0 + 0.4 * z), z};
    };
    return read(gmsh::solid_block(counts, form), counts,
                {"geometry.mesh.fixed=[\"base\", \"front\", \"back\"]", "geometry.mesh.roller=[]",
                 "construction.convention=" + convention, "mpm.element_size=0.4"},
                "[probes.axis]\nfrom = [0, 0, 0]\nto = [0, 0, 2]\n");
  }
};

TEST_P(MeshInSpace, HasItsMassAndRestsOnWhatIsFixed) {
  const exchange::Case body = study(GetParam());
  double drawn = 0.0;
  for (const exchange::Stage& stage : stages_of(body)) {
    drawn += 2000.0 * exchange::layer_volume(*body.geometry.mesh, stage.layer);
    EXPECT_NEAR(stage.mass, drawn, (GetParam() == "drop" ? 1e-12 : 1e-3) * drawn);
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-7 * stage.weight);
    double upward = 0.0;
    for (std::size_t b = 0; b < 3; ++b)
      upward += stage.support_reactions[3 * b + 2];
    EXPECT_NEAR(upward, stage.weight, 1e-7 * stage.weight);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshInSpace, ::testing::Values("drop", "float", "level-up", "refill"),
                         [](const auto& parameter) {
                           return parameter.param == "level-up" ? std::string("levelled") : parameter.param;
                         });

/// What has settled is made up for, so that the top is level, up to the strain of the layer itself.
TEST(MeshInSpaceLevelledUp, IsHeavierByWhatHasSettledBelow) {
  const Block counts{.across = 2, .deep = 2};
  const Overrides soft{"construction.convention=level-up", "material.fill.youngs_modulus=4e5"};
  const auto stages = stages_of(read(gmsh::solid_block(counts), counts, soft, axis_in_space));
  const double settled = unit_weight / (constrained_modulus / 100.0) / 2.0; // of the first layer, by itself
  EXPECT_NEAR(stages[1].mass_placed, stages[0].mass_placed * (1.0 + settled), 1e-2 * settled * stages[0].mass_placed);
}
