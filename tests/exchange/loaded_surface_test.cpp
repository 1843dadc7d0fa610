// What a stage loads: lines of a section, swept along y, and sides of a mesh in space.
#include "settle/exchange/loaded_surface.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gmsh_text.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

using namespace settle::exchange;
using settle::gmsh::Block;
using testing::HasSubstr;

namespace {

std::string load(const std::string& from, const std::string& to, const std::string& traction) {
  return fmt::format("[[stage]]\naction = \"load\"\nfrom = {}\nto = {}\ntraction = {}\n", from, to, traction);
}

const std::string placed = "[[stage]]\nlayer = 1\n[[stage]]\nlayer = 2\n";

/// Two rows of cells of 1 m, three side by side and two deep.
Case block(const std::string& stages, const std::vector<std::string>& overrides = {},
           const settle::gmsh::Place& place = {}) {
  const Block counts{.across = 3, .deep = 2};
  return parse_case(settle::gmsh::case_of(settle::gmsh::solid_block(counts, place).text(), counts, stages),
                    "block.toml", overrides);
}

/// Stage 3, after both layers.
double loaded(const Case& study) {
  return loaded_area(study, 3);
}

std::string complaint_about(const std::string& stages, const std::vector<std::string>& overrides = {}) {
  try {
    static_cast<void>(block(stages, overrides));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

Case embankment(const std::vector<std::string>& overrides) {
  return parse_case(R"(
format = 1
gravity = 10
[material.fill]
law = "rate"
youngs_modulus = 4e6
poissons_ratio = 0.25
density = 1720
[construction]
convention = "drop"
material = "fill"
layers = 2
[geometry]
shape = "embankment"
dimension = 3
[geometry.embankment]
height = 2
crest = 3
slopes = [2.0, 1.5]
)" + placed + load("[-1.5, 2]", "[-3.5, 1]", "[0, -1e4]"),
                    "bank.toml", overrides);
}

} // namespace

/// A valley 4 m wide at the upper end of the slope, 3 m at its lower one.
TEST(LoadedSurface, OfASectionIsALineSweptAlongTheDepth) {
  const double line = std::sqrt(5.0);
  EXPECT_NEAR(loaded(embankment({"geometry.dimension=2"})), line, 1e-14);
  EXPECT_NEAR(loaded(embankment({"geometry.depth=0.5"})), 0.5 * line, 1e-14);
  EXPECT_NEAR(loaded(embankment({"geometry.valley={ bottom = 2, slopes = [1.0, 0.0] }"})), 3.5 * line, 1e-14);
}

TEST(LoadedSurface, OfAMeshAreItsFreeSidesInABox) {
  EXPECT_NEAR(loaded(block(placed + load("[0, 0, 2]", "[3, 2, 2]", "[0, 0, -1]"))), 6.0, 1e-14);
  EXPECT_NEAR(loaded(block(placed + load("[3, 1, 2]", "[1, 0, 2]", "[0, 0, -1]"))), 2.0, 1e-14) << "any two corners";
  EXPECT_NEAR(loaded(block(placed + load("[0, 0, 0]", "[3, 2, 2]", "[0, 0, -1]"))), 6.0, 1e-14)
      << "all else is held, or within";
  EXPECT_NEAR(loaded(block(placed + load("[3, 0, 0]", "[3, 2, 2]", "[-1, 0, 0]"), {"geometry.mesh.roller=[]"})), 4.0,
              1e-14);
}

/// Under the second layer, before it is there.
TEST(LoadedSurface, IsThatOfWhatIsThereThen) {
  const Case study =
      block("[[stage]]\nlayer = 1\n" + load("[0, 0, 1]", "[1, 2, 1]", "[0, 0, -1]") + "[[stage]]\nlayer = 2\n");
  EXPECT_NEAR(loaded_area(study, 2), 2.0, 1e-14);
  const auto sides = sides_in_box(*study.geometry.mesh, study.stages[1], {1});
  ASSERT_EQ(sides.whole.size(), 2U);
  EXPECT_EQ(sides.whole.front().layer, 1);
  EXPECT_TRUE(sides.cut.empty());
  EXPECT_TRUE(sides_in_box(*study.geometry.mesh, study.stages[1], {1, 2}).whole.empty());
}

/// (0, 0), (3 + 0.5 y, 0) ... in plan: a trapezoid. On z = 2 + 0.75 x besides: 5/4 of it.
TEST(LoadedSurface, HasTheAreaOfSidesThatAreNoRectangles) {
  const auto widen = [](std::array<double, 3>& node) { node[0] *= 1.0 + node[1] / 6.0; };
  const auto tilt = [&](std::array<double, 3>& node) {
    widen(node);
    if (node[2] == 2.0) node[2] += 0.75 * node[0];
  };
  const std::vector<std::string> held{"geometry.mesh.fixed=[\"base\", \"right\"]",
                                      "geometry.mesh.roller=[\"left\", \"front\", \"back\"]"};
  EXPECT_NEAR(loaded(block(placed + load("[0, 0, 2]", "[4, 2, 2]", "[0, 0, -1]"), held, widen)), 7.0, 1e-13);
  EXPECT_NEAR(loaded(block(placed + load("[0, 0, 2]", "[4, 2, 5]", "[0, 0, -1]"), held, tilt)), 7.0 * 1.25, 1e-13);
}

TEST(LoadedSurface, IsToBeThereAsAWhole) {
  EXPECT_THAT(complaint_about(placed + load("[0, 0, 1]", "[3, 2, 1]", "[0, 0, -1]")),
              HasSubstr("stage.2.from loads no side of the mesh"));
  EXPECT_THAT(complaint_about(placed + load("[0, 0, 2]", "[1.5, 2, 2]", "[0, 0, -1]")),
              HasSubstr("stage.2.from cuts sides of the mesh: 2 of them"));
  EXPECT_THAT(complaint_about(placed + load("[0, 0]", "[1, 2]", "[0, -1]")),
              HasSubstr("stage.2.from has another number of coordinates than what is loaded"));
  EXPECT_THAT(complaint_about(placed + load("[0, 0, 2]", "[1, 2, 2]", "[0, -1]")), HasSubstr("[x, y, z]"));
  EXPECT_THAT(complaint_about(placed + load("[0, 0, 2]", "[0, 0, 2]", "[0, 0, -1]")),
              HasSubstr("a line without length"));
}
