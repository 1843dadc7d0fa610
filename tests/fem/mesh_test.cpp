// Meshes by Gmsh, from the case to the stages.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.hpp"
#include "frozen_column.hpp"
#include "gmsh_text.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/mesh_geometry.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Stage;
using gmsh::Block;
using gmsh::plane_block;
using gmsh::solid_block;
using ::testing::HasSubstr;
using Position = std::array<double, 3>;

constexpr double unit_weight = 20e3, constrained_modulus = 48e6; // N/m3, Pa

constexpr const char* axis_in_plane = "[probes.axis]\nfrom = [0.5, 0]\nto = [0.5, 2]\npoints = 9\n";
constexpr const char* axis_in_space = "[probes.axis]\nfrom = [0.5, 0.5, 0]\nto = [0.5, 0.5, 2]\npoints = 9\n";

exchange::Case read(const gmsh::File& mesh, const Block& counts, const std::vector<std::string>& overrides = {},
                    const std::string& more = {}) {
  return exchange::parse_case(gmsh::case_of(mesh.text(), counts, more), "block.toml", overrides);
}

/// 4 cells wide at the base, with slopes.
void make_bank(Position& node) {
  node[0] = (node[0] - 2.0) * (1.0 - 0.2 * node[1]);
}

const std::vector<std::string> without_rollers{"geometry.mesh.roller=[]"};

/// The same cells, each as a polygon.
exchange::Case drawn(exchange::Case study) {
  const exchange::Mesh mesh = *study.geometry.mesh;
  study.geometry.shape = exchange::Shape::polygons;
  study.geometry.mesh.reset();
  study.geometry.polygons.clear();
  study.fem.element_size = 10.0;
  for (const exchange::MeshCell& cell : mesh.cells) {
    exchange::Polygon polygon{.layer = cell.layer};
    for (std::size_t c = 0; c < 4; ++c)
      polygon.corners.push_back({mesh.nodes[cell.nodes[c]][0], mesh.nodes[cell.nodes[c]][1]});
    study.geometry.polygons.push_back(polygon);
  }
  return study;
}

void expect_same(const std::vector<double>& one, const std::vector<double>& other, double tolerance) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_NEAR(one[i], other[i], tolerance);
}

/// Two layers of 1 m between rollers, each compressed by its own weight and by what comes on it.
void expect_column(const std::vector<Stage>& stages, int dim) {
  ASSERT_EQ(stages.size(), 2U);
  const double unit = unit_weight / constrained_modulus;
  const exchange::ProbeSamples& axis = stages.back().probes.at("axis");
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const double height = vertical(axis.design_position, i, dim);
    const double y = height - (axis.layer[i] - 1);
    if (std::abs(y - std::round(y)) > 1e-12) continue; // nodes are exact
    const double own = y * (1.0 - y / 2.0), above = axis.layer[i] == 1 ? y : 1.0;
    EXPECT_NEAR(vertical(axis.displacement, i, dim), -unit * (own + above), 1e-14);
  }
}

} // namespace

TEST(MeshOfQuadrilaterals, IsAColumnBetweenRollers) {
  expect_column(solve(read(plane_block({.across = 1}), {.across = 1}, {}, axis_in_plane)), 2);
}

TEST(MeshOfHexahedra, IsAColumnBetweenRollers) {
  const Block counts{.across = 1, .deep = 1};
  const std::vector<Stage> stages = solve(read(solid_block(counts), counts, {}, axis_in_space));
  expect_column(stages, 3);
  const Stage& last = stages.back();
  ASSERT_EQ(last.support_reactions.size(), 3U * 5U);
  EXPECT_NEAR(last.support_reactions[2], 2.0 * unit_weight, 1e-8);
  EXPECT_NEAR(last.support_reactions[3 * 1 + 0], -last.support_reactions[3 * 2 + 0], 1e-8); // left and right
  EXPECT_NEAR(last.support_reactions[3 * 3 + 1], -last.support_reactions[3 * 4 + 1], 1e-8); // front and back
  EXPECT_GT(last.support_reactions[3 * 1 + 0], 0.2 * unit_weight);
  EXPECT_GT(last.support_reactions[3 * 3 + 1], 0.2 * unit_weight);
}

class MeshOfABank : public ::testing::TestWithParam<exchange::Kinematics> {};

TEST_P(MeshOfABank, IsTheSameAsItsCellsDrawn) {
  const std::string kinematics = fmt::format("fem.kinematics={}", exchange::name_of(GetParam()));
  const exchange::Case study = read(plane_block({.across = 4}, make_bank), {.across = 4},
                                    {"geometry.mesh.roller=[]", kinematics}, axis_in_plane);
  const std::vector<Stage> meshed = solve(study), polygons = solve(drawn(study));
  ASSERT_EQ(meshed.size(), polygons.size());
  for (std::size_t k = 0; k < meshed.size(); ++k) {
    expect_same(meshed[k].points.displacement, polygons[k].points.displacement, 1e-14);
    expect_same(meshed[k].points.stress, polygons[k].points.stress, 1e-7);
    EXPECT_NEAR(meshed[k].base_reaction, meshed[k].weight, 1e-9 * meshed[k].weight);
  }
  EXPECT_NEAR(meshed[0].mass, 2000.0 * 3.6, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, MeshOfABank, ::testing::Values(exchange::Kinematics::small, exchange::Kinematics::finite),
                         [](const auto& parameter) { return std::string(exchange::name_of(parameter.param)); });

/// Hexahedra one deep between rollers against the section, extruded by the program.
TEST(MeshOfHexahedra, IsItsSectionBetweenRollers) {
  const Block counts{.across = 4, .deep = 1};
  const auto bank = [](Position& node) { node[0] = (node[0] - 2.0) * (1.0 - 0.2 * node[2]); };
  for (const std::string element : {"fem.element=Q1", "fem.element=Q2", "fem.kinematics=finite"}) {
    const exchange::Case solid =
        read(solid_block(counts, bank), counts, {"geometry.mesh.roller=[\"front\", \"back\"]", element},
             "[probes.axis]\nfrom = [0.5, 0.5, 0]\nto = [0.5, 0.5, 2]\n");
    const exchange::Case section =
        read(plane_block({.across = 4}, make_bank), {.across = 4},
             {"geometry.mesh.roller=[]", "geometry.dimension=3", "geometry.depth=1", "fem.element_size=1", element},
             axis_in_plane);
    const std::vector<Stage> body = solve(solid), extruded = solve(section);
    for (std::size_t k = 0; k < 2; ++k) {
      expect_same(body[k].probes.at("axis").displacement, extruded[k].probes.at("axis").displacement, 1e-13);
      expect_same(body[k].probes.at("axis").stress, extruded[k].probes.at("axis").stress, 1e-6);
    }
  }
}

/// Two strata of their own ratios; cells within the ground may have any form.
class GroundOfHexahedra : public ::testing::TestWithParam<std::string> {};

TEST_P(GroundOfHexahedra, StartsWithTheStressOfItsDepthAndDoesNotMove) {
  const Block counts{.across = 3, .deep = 2};
  const auto distort = [](Position& node) {
    const auto [x, y, z] = node;
    if (x > 0 && x < 3) node[0] += 0.1 * y - 0.05 * z;
    if (y > 0 && y < 2) node[1] += 0.1 * x * z - 0.2;
  };
  const exchange::Case study = read(solid_block(counts, distort), counts, {GetParam()},
                                    "[[stage]]\naction = \"ground\"\nlayer = 1\nk0 = 0.7\n"
                                    "[[stage]]\naction = \"ground\"\nlayer = 2\nk0 = 0.4\n"
                                    "[[stage]]\naction = \"hold\"\n");
  const std::vector<Stage> stages = solve(study);
  for (const std::size_t k : {1U, 2U}) {
    const exchange::SamplePoints& points = stages[k].points;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double upward = -unit_weight * (2.0 - points.position[3 * p + 2]);
      const double across = (points.layer[p] == 1 ? 0.7 : 0.4) * upward;
      const std::vector<double> expected{across, across, upward, 0.0, 0.0, 0.0};
      for (std::size_t c = 0; c < 6; ++c)
        EXPECT_NEAR(points.stress[6 * p + c], expected[c], 1e-10 * 2.0 * unit_weight);
    }
    expect_same(points.displacement, std::vector<double>(points.displacement.size()), 1e-15);
    EXPECT_NEAR(stages[k].base_reaction, stages[k].weight, 1e-10 * stages[k].weight);
  }
}

INSTANTIATE_TEST_SUITE_P(All, GroundOfHexahedra,
                         ::testing::Values("fem.element=Q1", "fem.element=Q2", "fem.kinematics=finite"),
                         [](const auto& parameter) { return parameter.param.substr(parameter.param.find('=') + 1); });

TEST(GroundOfHexahedraAtFiniteStrain, KeepsItsStressByALawInRates) {
  const Block counts{.deep = 1};
  EXPECT_THAT(complaint_about(read(solid_block(counts), counts, {"fem.kinematics=finite", "material.fill.law=hencky"},
                                   "[[stage]]\naction = \"ground\"\nlayer = 1\nk0 = 0.7\n[[stage]]\nlayer = 2\n")),
              HasSubstr("has no stress without strain"));
}

TEST(MeshOfHexahedra, OfAnyFormRestsOnWhatIsFixedWithItsWholeWeight) {
  const Block counts{.across = 3, .deep = 2, .layers = 2};
  const auto distort = [](Position& node) {
    const auto [x, y, z] = node;
    node = {x + 0.15 * y * z - 0.1 * z, 1.3 * y + 0.1 * x * z, z + 0.1 * x * y};
  };
  const exchange::Case study = read(solid_block(counts, distort), counts, without_rollers);
  double mass = 0.0;
  for (const Stage& stage : solve(study)) {
    mass += 2000.0 * exchange::layer_volume(*study.geometry.mesh, stage.layer);
    EXPECT_NEAR(stage.mass, mass, 1e-12 * mass);
    EXPECT_NEAR(stage.base_reaction, stage.weight, 1e-9 * stage.weight);
    for (const std::size_t axis : {0U, 1U})
      EXPECT_NEAR(stage.support_reactions[axis], 0.0, 1e-9 * stage.weight);
  }
}

/// A layer that touches the fixed base at an edge only is held there too.
TEST(MeshOfHexahedra, IsHeldAtEdgesOfFixedSides) {
  const Block counts{.across = 2, .deep = 1, .layers = 1};
  gmsh::File mesh = solid_block(counts);
  mesh.elements.erase(std::find_if(mesh.elements.begin(), mesh.elements.end(), [](const gmsh::Element& element) {
    return element.type == 3 && element.group == 11 && element.nodes.front() == 2; // of the right cell
  }));
  const exchange::Case study =
      read(mesh, counts, without_rollers, "[probes.foot]\nfrom = [0, 1, 0]\nto = [2, 1, 0]\npoints = 3\n");
  const auto foot = solve(study).back().probes.at("foot");
  EXPECT_EQ(vertical(foot.displacement, 1, 3), 0.0);
  EXPECT_LT(vertical(foot.displacement, 2, 3), -1e-6);
}

TEST(MeshOfHexahedra, BulgesWhereItIsFree) {
  const Block counts{.across = 1, .deep = 1};
  const auto stages = solve(read(solid_block(counts), counts, {"geometry.mesh.roller=[\"left\", \"right\"]"},
                                 "[probes.through]\nfrom = [0.5, 0, 1]\nto = [0.5, 1, 1]\npoints = 2\n"));
  const std::vector<double> through = stages.front().probes.at("through").displacement;
  EXPECT_LT(through[1], -1e-6);
  EXPECT_NEAR(through[4], -through[1], 1e-12);
}

TEST(MeshOfHexahedra, AtFiniteStrainLiesAsAWholeOnWhatWasPlacedBefore) {
  const Block counts{.deep = 1};
  const std::vector<std::string> finite{"fem.kinematics=finite", "geometry.mesh.roller=[]"};
  gmsh::File beside = solid_block(counts);
  const auto layer_of_column = [&](int row_of_left, int row_of_right) {
    for (gmsh::Element& element : beside.elements)
      if (element.type == 5) {
        const bool left = (element.nodes[0] - 1) % 3 == 0;
        const int row = (element.nodes[0] - 1) / 6;
        element.group = row == 0 ? (left ? 1 : row_of_right) : (left ? row_of_left : 2);
      }
  };
  EXPECT_EQ(complaint_about(read(beside, counts, finite)), "");
  layer_of_column(1, 2); // one beside the other
  EXPECT_THAT(complaint_about(read(beside, counts, finite)), HasSubstr("layer 2 leans on what was placed before"));
  gmsh::File wide = solid_block(counts);
  std::erase_if(wide.elements, [](const gmsh::Element& element) { // nothing below the right half of layer 2
    return (element.type == 5 && element.nodes[0] == 2) || (element.group == 11 && element.nodes[0] == 2);
  });
  EXPECT_THAT(complaint_about(read(wide, counts, finite)), HasSubstr("in part beside it"));
  EXPECT_EQ(complaint_about(read(wide, counts, without_rollers)), "");
}

} // namespace settle::fem::testing
