#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gmsh_text.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/probe_points.hpp"

using namespace settle::exchange;
using settle::gmsh::Block;
using settle::gmsh::case_of;
using settle::gmsh::plane_block;
using settle::gmsh::solid_block;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

Case read(const settle::gmsh::File& mesh, const Block& counts, const std::vector<std::string>& overrides = {},
          const std::string& more = {}) {
  return parse_case(case_of(mesh.text(), counts, more), "block.toml", overrides);
}

/// Slopes of 1:1 on both sides of a block 4 cells wide, and nodes within it that are out of line.
void make_bank(std::array<double, 3>& node) {
  const double half = 2.0 - 0.5 * node[1];
  node[0] = (node[0] - 2.0) * half / 2.0 + (node[1] == 1.0 && std::abs(node[0] - 2.0) < 1.5 ? 0.1 : 0.0);
}

double area_of(const Case& study, int layer) {
  return layer_area(study.geometry, layer);
}

/// Every second cell of a ring of eight cells around a hole is another layer, or all of them are one.
settle::gmsh::File ring() {
  settle::gmsh::File file = plane_block({.across = 3, .layers = 3});
  std::erase_if(file.elements, [](const settle::gmsh::Element& element) {
    return element.type == 1 && element.group != 11; // the sides
  });
  for (settle::gmsh::Element& element : file.elements)
    if (element.type == 3) element.group = 1;
  std::erase_if(file.elements, [](const settle::gmsh::Element& element) {
    return element.type == 3 && element.nodes[0] == 6; // the middle
  });
  return file;
}

/// What the case is refused with.
std::string complaint_about(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(parse_case(text, "folder/block.toml", overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string complaint_about(const settle::gmsh::File& mesh, const Block& counts = {}) {
  return complaint_about(case_of(mesh.text(), counts));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

} // namespace

TEST(Mesh, IsTheSameInBothVersionsOfTheFormat) {
  const settle::gmsh::File mesh = plane_block({});
  const Case old = parse_case(case_of(mesh.text(), {}), "old.toml");
  const Case now = parse_case(case_of(mesh.text_of_version_4(), {}), "now.toml");
  EXPECT_EQ(old.geometry.mesh->nodes, now.geometry.mesh->nodes);
  ASSERT_EQ(old.geometry.mesh->cells.size(), 4U);
  ASSERT_EQ(now.geometry.mesh->cells.size(), 4U);
  for (std::size_t c = 0; c < 4; ++c) {
    EXPECT_EQ(old.geometry.mesh->cells[c].nodes, now.geometry.mesh->cells[c].nodes);
    EXPECT_EQ(old.geometry.mesh->cells[c].layer, now.geometry.mesh->cells[c].layer);
    EXPECT_EQ(old.geometry.mesh->cells[c].layer, c < 2 ? 1 : 2);
  }
  EXPECT_EQ(old.supports.size(), now.supports.size());
}

TEST(Mesh, LayersAreConvexPolygonsOfTheirOutlines) {
  const Case study = read(plane_block({.across = 4}, make_bank), {.across = 4}, {"geometry.mesh.roller=[]"});
  ASSERT_EQ(study.geometry.polygons.size(), 2U);
  using Corners = std::vector<std::vector<double>>;
  EXPECT_EQ(study.geometry.polygons[0].corners, (Corners{{-2, 0}, {2, 0}, {1.5, 1}, {-1.5, 1}}));
  EXPECT_EQ(study.geometry.polygons[1].corners, (Corners{{-1.5, 1}, {1.5, 1}, {1, 2}, {-1, 2}}));
  EXPECT_EQ(study.geometry.width, 4.0);
  EXPECT_EQ(study.geometry.height, 2.0);
  EXPECT_NEAR(study.fem.element_size, std::sqrt(6.0 / 8.0), 1e-12);
}

TEST(Mesh, OutlinesWithACornerInwardBecomeFewConvexParts) {
  settle::gmsh::File mesh = plane_block({.across = 4, .layers = 4});
  for (settle::gmsh::Element& element : mesh.elements) // an L of layer 1, the rest layer 2
    if (element.type == 3) element.group = element.group == 1 || (element.nodes[0] - 1) % 5 == 0 ? 1 : 2;
  mesh.names = {{{2, 1}, "lift-1"}, {{2, 2}, "lift-2"}, {{1, 11}, "base"}, {{1, 12}, "left"}, {{1, 13}, "right"}};
  const Case study = read(mesh, {});
  EXPECT_EQ(area_of(study, 1), 7.0);
  EXPECT_EQ(area_of(study, 2), 9.0);
  EXPECT_EQ(study.geometry.polygons.size(), 3U); // two of the L
  EXPECT_THAT(layers_at(study.geometry, {0.5, 3.5}, 0.0), ElementsAre(1));
  EXPECT_THAT(layers_at(study.geometry, {3.5, 0.5}, 0.0), ElementsAre(1));
  EXPECT_THAT(layers_at(study.geometry, {1.5, 1.5}, 0.0), ElementsAre(2));
}

TEST(Mesh, OutlinesAroundAHoleAreFilledButForTheHole) {
  settle::gmsh::File mesh = ring();
  const Block counts{.layers = 1};
  const Case study = read(mesh, counts, {"geometry.mesh.roller=[]"});
  EXPECT_EQ(area_of(study, 1), 8.0);
  EXPECT_LE(study.geometry.polygons.size(), 4U);
  EXPECT_THAT(layers_at(study.geometry, {1.5, 1.5}, 0.0), IsEmpty());
}

TEST(Mesh, BoundariesAreStraightSupportsWithTheBodyOnTheirLeft) {
  const Case study = read(plane_block({}), {});
  ASSERT_EQ(study.supports.size(), 3U);
  const Support &base = study.supports[0], &left = study.supports[1], &right = study.supports[2];
  EXPECT_EQ(base.boundary, "base");
  EXPECT_EQ(base.held, Held::both);
  EXPECT_THAT(base.from, ElementsAre(0, 0));
  EXPECT_THAT(base.to, ElementsAre(2, 0));
  EXPECT_EQ(left.held, Held::x);
  EXPECT_THAT(left.from, ElementsAre(0, 2));
  EXPECT_THAT(left.to, ElementsAre(0, 0));
  EXPECT_EQ(right.held, Held::x);
  EXPECT_THAT(right.from, ElementsAre(2, 0));
  EXPECT_THAT(right.to, ElementsAre(2, 2));
}

TEST(Mesh, ABoundaryWithACornerIsASupportForEachOfItsSides) {
  settle::gmsh::File mesh = plane_block({});
  for (settle::gmsh::Element& element : mesh.elements)
    if (element.type == 1) element.group = 11;
  const Case study = read(mesh, {}, {"geometry.mesh.roller=[]"});
  ASSERT_EQ(study.supports.size(), 3U);
  EXPECT_THAT(study.supports[0].to, ElementsAre(0, 0)); // down the left, along the base, up the right
  EXPECT_THAT(study.supports[1].to, ElementsAre(2, 0));
  EXPECT_THAT(study.supports[2].to, ElementsAre(2, 2));
}

TEST(Mesh, CellsThatRunClockwiseAreTurnedRound) {
  settle::gmsh::File mesh = plane_block({});
  const Case straight = read(mesh, {});
  for (settle::gmsh::Element& element : mesh.elements)
    if (element.type == 3) std::swap(element.nodes[1], element.nodes[3]);
  const Case turned = read(mesh, {});
  for (std::size_t c = 0; c < 4; ++c)
    EXPECT_EQ(turned.geometry.mesh->cells[c].nodes, straight.geometry.mesh->cells[c].nodes);
  settle::gmsh::File solid = solid_block({.deep = 1});
  for (settle::gmsh::Element& element : solid.elements)
    if (element.type == 5)
      std::swap_ranges(element.nodes.begin(), element.nodes.begin() + 4, element.nodes.begin() + 4);
  const Case upside_down = read(solid, {.deep = 1});
  EXPECT_NEAR(layer_volume(*upside_down.geometry.mesh, 1), 2.0, 1e-14);
}

TEST(Mesh, GroundComesFirstAndIsThereAtTheStart) {
  const std::vector<std::string> overrides{"geometry.mesh.ground=[\"lift-1\"]", "geometry.mesh.layers=[\"lift-2\"]"};
  const Case study = read(plane_block({}), {}, overrides);
  ASSERT_EQ(study.stages.size(), 2U);
  EXPECT_EQ(study.stages[0].action, Action::ground);
  EXPECT_EQ(study.stages[1].action, Action::place);
  const Case rock =
      read(plane_block({}), {}, {"geometry.mesh.materials.lift-1=rock"},
           "[material.rock]\nlaw = \"rate\"\nyoungs_modulus = 1e9\npoissons_ratio = 0.2\ndensity = 2600\n");
  EXPECT_EQ(rock.material_of(1).density, 2600.0);
  EXPECT_EQ(rock.material_of(2).density, 2000.0);
}

TEST(Mesh, ACaseThatIsWrittenHoldsItsMeshAndChangesWithIt) {
  const Case study = read(plane_block({}), {}, {}, "[probes.axis]\nfrom = [1, 0]\nto = [1, 2]\n");
  const std::string text = to_toml(study);
  const Case again = parse_case(text, "elsewhere/case.toml");
  EXPECT_EQ(to_toml(again), text);
  EXPECT_EQ(again.geometry.mesh->nodes, study.geometry.mesh->nodes);
  EXPECT_EQ(again.supports.size(), 3U);
  const auto widen = [](std::array<double, 3>& node) { node[0] *= 1.0 + 1e-12; };
  EXPECT_NE(to_toml(read(plane_block({}, widen), {})), to_toml(read(plane_block({}), {})));
  const Case solid = read(solid_block({.deep = 1}), {.deep = 1});
  EXPECT_EQ(to_toml(parse_case(to_toml(solid), "solid.toml")), to_toml(solid));
}

TEST(Mesh, HexahedraHaveTheVolumeOfTheirTrilinearMap) {
  const auto distort = [](std::array<double, 3>& node) {
    const auto [x, y, z] = node;
    node = {x + 0.1 * y * z, y + 0.07 * x * z - 0.1 * z, z + 0.15 * x * y};
  };
  const Case study = read(solid_block({.across = 1, .deep = 1, .layers = 1}, distort),
                          {.across = 1, .deep = 1, .layers = 1}, {"geometry.mesh.roller=[]"});
  double volume = 0.0; // of the map above, whose Jacobian two Gauss points an axis integrate
  for (int q = 0; q < 8; ++q) {
    const auto at = [&](int axis) { return 0.5 + ((q >> axis) & 1 ? 0.5 : -0.5) / std::numbers::sqrt3; };
    const double x = at(0), y = at(1), z = at(2);
    const double a[3][3] = {{1, 0.1 * z, 0.1 * y}, {0.07 * z, 1, 0.07 * x - 0.1}, {0.15 * y, 0.15 * x, 1}};
    volume +=
        0.125 * (a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                 a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]));
  }
  EXPECT_NEAR(layer_volume(*study.geometry.mesh, 1), volume, 1e-14);
  EXPECT_NEAR(study.fem.element_size, std::cbrt(volume), 1e-14);
}

TEST(Mesh, ProbesOfAMeshInSpaceRunThroughItsCells) {
  const Block counts{.deep = 2};
  const auto lean = [](std::array<double, 3>& node) { node[0] += node[2] * node[1] / 4; };
  const Case study = read(solid_block(counts, lean), counts, {"geometry.mesh.roller=[\"front\", \"back\"]"},
                          "[probes.up]\nfrom = [0.25, 2, 0]\nto = [0.25, 2, 2]\npoints = 5\n");
  const std::vector<ProbePoint> points = probe_points(study, study.probes.at("up"));
  ASSERT_EQ(points.size(), 1U + 1U); // x is above z / 2 there
  EXPECT_EQ(points[0].design_height, 0.0);
  EXPECT_EQ(points[1].design_height, 0.5);
  EXPECT_EQ(points[1].y, 2.0);
  EXPECT_EQ(study.geometry.depth, 2.0);
}

TEST(Mesh, TheLowerSideOfALayerIsFoundAnywhereInPlan) {
  const Block counts{.deep = 2};
  const auto raise = [](std::array<double, 3>& node) { node[2] += 0.25 * node[0]; };
  const Case study = read(solid_block(counts, raise), counts);
  const LayerOfMesh upper(*study.geometry.mesh, 2);
  EXPECT_NEAR(upper.lower_side(0.7, 1.9).value(), 1.175, 1e-14);
  EXPECT_NEAR(upper.lower_side(2.0, 2.0).value(), 1.5, 1e-14);
  EXPECT_FALSE(upper.lower_side(2.1, 1.0).has_value());
}

TEST(Mesh, FilesThatAreNoMeshAreRefusedWithTheirLine) {
  const std::string text = plane_block({}).text();
  const auto refused = [&](const std::string& from, const std::string& to) {
    return complaint_about(case_of(replaced(text, from, to), {}));
  };
  EXPECT_THAT(refused("$MeshFormat", "solid ascii"), HasSubstr("folder/block.msh:1: the file is no mesh of Gmsh"));
  EXPECT_THAT(refused("2.2 0 8", "4 0 8"), AllOf(HasSubstr("block.msh:2: "), HasSubstr("2.2 or 4.1")));
  EXPECT_THAT(refused("2.2 0 8", "2.2 1 8"), HasSubstr("set Mesh.Binary = 0"));
  EXPECT_THAT(refused("4 0 1 0", "4 0 one 0"), HasSubstr("holds a word where a number belongs"));
  EXPECT_THAT(refused("$EndNodes", "1 2"), HasSubstr("does not end where it should"));
  EXPECT_THAT(refused("$Nodes\n9", "$Nodes\n999999"), HasSubstr("the mesh ends too early"));
  EXPECT_THAT(refused("1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 5 77"), HasSubstr("node 77"));
  EXPECT_THAT(refused("1 3 2 1 1 1 2 5 4", "1 10 2 1 1 1 2 5 4 1 2 5 4 7"),
              AllOf(HasSubstr("Gmsh's type 10"), HasSubstr("Mesh.ElementOrder = 1")));
}

TEST(Mesh, AFileThatIsNotThereIsNamedWithItsPath) {
  const std::string text = replaced(case_of("", {}), "text = '''\n'''\n", "");
  EXPECT_THAT(complaint_about(text), AllOf(HasSubstr("the mesh cannot be read"), HasSubstr("folder/block.msh")));
}

TEST(Mesh, AnOverrideOfTheFileDoesNotTakeTheTextOfAnother) {
  EXPECT_THAT(complaint_about(case_of(plane_block({}).text(), {}), {"geometry.mesh.file=other.msh"}),
              HasSubstr("folder/other.msh"));
}

TEST(Mesh, CellsThatCannotBeUsedAreRefused) {
  settle::gmsh::File triangles = plane_block({});
  triangles.elements[0] = {2, 1, {1, 2, 5}};
  EXPECT_THAT(complaint_about(triangles), AllOf(HasSubstr("is no quadrilateral"), HasSubstr("Mesh.RecombineAll = 1")));
  settle::gmsh::File tetrahedra = solid_block({.deep = 1});
  tetrahedra.elements[0] = {4, 1, {1, 2, 3, 7}};
  EXPECT_THAT(complaint_about(tetrahedra, {.deep = 1}),
              AllOf(HasSubstr("is no hexahedron"), HasSubstr("Mesh.SubdivisionAlgorithm = 2")));
  settle::gmsh::File inverted = plane_block({});
  inverted.nodes[4] = {-0.5, -0.5, 0.0};
  EXPECT_THAT(complaint_about(inverted), HasSubstr("element 1 is inverted, or not convex"));
  settle::gmsh::File upright = plane_block({}, [](std::array<double, 3>& node) { std::swap(node[1], node[2]); });
  EXPECT_NE(complaint_about(upright), "");
  settle::gmsh::File lifted = plane_block({}, [](std::array<double, 3>& node) { node[2] = 0.5; });
  EXPECT_THAT(complaint_about(lifted), HasSubstr("z = 0"));
}

TEST(Mesh, CellsThatDoNotMeetInWholeSidesAreRefused) {
  settle::gmsh::File split = plane_block({.across = 1, .layers = 2});
  split.nodes.push_back(split.nodes[2]);
  split.elements[3].nodes[0] = 7; // the upper cell has a node of its own in that place
  EXPECT_THAT(complaint_about(split), AllOf(HasSubstr("lie in one place"), HasSubstr("Coherence")));
  settle::gmsh::File hanging = plane_block({.across = 2, .layers = 2});
  hanging.elements[4] = {3, 2, {4, 6, 9, 7}}; // one cell above two
  std::erase_if(hanging.elements, [&](const auto& e) {
    return e.type == 3 && e.nodes == std::vector<int>{5, 6, 9, 8};
  });
  std::erase_if(hanging.elements, [](const auto& e) { return e.type == 1 && e.group != 11; });
  EXPECT_THAT(complaint_about(case_of(hanging.text(), {}), {"geometry.mesh.roller=[]"}),
              HasSubstr("lies within a side of a cell"));
  settle::gmsh::File twice = plane_block({});
  twice.elements.push_back(twice.elements[0]);
  EXPECT_THAT(complaint_about(twice), HasSubstr("lie over one another"));
}

TEST(Mesh, BoundariesInsideTheBodyAreRefused) {
  settle::gmsh::File inside = plane_block({});
  inside.elements.push_back({1, 11, {4, 5}});
  EXPECT_THAT(complaint_about(inside), AllOf(HasSubstr("\"base\" is no side of the body"), HasSubstr("2 cells")));
}

TEST(Mesh, GroupsThatDoNotFitTheCaseAreRefused) {
  const std::string text = case_of(plane_block({}).text(), {});
  const auto refused = [&](const std::vector<std::string>& overrides) { return complaint_about(text, overrides); };
  EXPECT_THAT(refused({"geometry.mesh.layers=[\"lift-1\", \"lfit-2\"]"}),
              AllOf(HasSubstr("lfit-2"), HasSubstr("lift-1, lift-2"), HasSubstr("did you mean lift-2?")));
  EXPECT_THAT(refused({"geometry.mesh.fixed=[\"bottom\"]"}),
              AllOf(HasSubstr("--set geometry.mesh.fixed"), HasSubstr("base, left, right")));
  EXPECT_THAT(refused({"geometry.mesh.layers=[\"lift-1\"]", "construction.layers=1"}),
              AllOf(HasSubstr("belongs to no layer"), HasSubstr("physical group lift-2")));
  EXPECT_THAT(refused({"geometry.mesh.layers=[\"lift-1\", \"lift-1\"]"}), HasSubstr("a second time"));
  EXPECT_THAT(refused({"construction.layers=3"}), HasSubstr("set construction.layers = 2"));
  EXPECT_THAT(refused({"geometry.mesh.fixed=[]", "geometry.mesh.roller=[]"}), HasSubstr("geometry.mesh.fixed"));
  EXPECT_THAT(refused({"geometry.mesh.materials.lift-1=clay"}), HasSubstr("not in the case"));
  EXPECT_THAT(refused({"geometry.mesh.materials.base=fill"}), HasSubstr("no layer"));
  settle::gmsh::File empty = plane_block({});
  std::erase_if(empty.elements, [](const auto& element) { return element.type == 3 && element.group == 2; });
  EXPECT_THAT(complaint_about(case_of(empty.text(), {}), {"geometry.mesh.roller=[]"}),
              HasSubstr("\"lift-2\" has no elements"));
  settle::gmsh::File nameless = plane_block({});
  nameless.names.clear();
  EXPECT_THAT(complaint_about(nameless), HasSubstr("none: the file has no such group with a name"));
  settle::gmsh::File slanted = plane_block({}, [](std::array<double, 3>& node) { node[0] += 0.1 * node[1]; });
  EXPECT_THAT(complaint_about(slanted), HasSubstr("the roller \"left\" does not lie across an axis"));
}

TEST(Mesh, KeysThatAMeshSaysByItselfAreRefused) {
  const std::string text = case_of(plane_block({}).text(), {});
  const std::string solid = case_of(solid_block({.deep = 1}).text(), {.deep = 1});
  EXPECT_THAT(complaint_about(text, {"fem.element_size=0.25"}), HasSubstr("fem.element_size"));
  EXPECT_THAT(complaint_about(text, {"geometry.width=3"}), HasSubstr("geometry.width"));
  EXPECT_THAT(complaint_about(text + "[converge]\nelement_size = [1, 0.5, 0.25]\n"), HasSubstr("geometry.mesh.file"));
  EXPECT_THAT(complaint_about(solid, {"geometry.depth=3"}), HasSubstr("geometry.depth"));
  EXPECT_THAT(complaint_about(solid, {"geometry.dimension=2"}), HasSubstr("set geometry.dimension = 3"));
  EXPECT_THAT(complaint_about(text + "[[support]]\nfrom = [0, 0]\nto = [2, 0]\n"), HasSubstr("support"));
  const std::string ground = "[[stage]]\nlayer = 1\naction = \"ground\"\nk0 = 0.5\n[[stage]]\nlayer = 2\n";
  EXPECT_EQ(complaint_about(solid + ground), "");
  const auto lean = [](std::array<double, 3>& node) { node[1] += node[1] > 0.5 ? 0.1 * node[2] : 0.0; };
  EXPECT_THAT(complaint_about(case_of(solid_block({.deep = 1}, lean).text(), {.deep = 1}, ground),
                              {"geometry.mesh.roller=[\"left\", \"right\"]"}),
              HasSubstr("a layer of a mesh that fills no upright box"));
}

TEST(Mesh, OfASectionIsExtrudedInSpace) {
  const Case study = read(plane_block({}), {}, {"geometry.dimension=3", "geometry.depth=1", "fem.element_size=0.5"});
  EXPECT_FALSE(study.geometry.varies_along_y());
  EXPECT_EQ(study.fem.element_size, 0.5); // of the slices
  EXPECT_EQ(study.geometry.depth, 1.0);
}
