// Bands along the boundary of bodies that vary along y: a dam across a valley, a mesh of hexahedra.
#include "boundary_band.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gmsh_text.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using exchange::SolidPoint;

/// 4 m high in two layers, 2 m wide at the crest; a floor of 2 m, flanks of 1:1 and an upright wall.
exchange::Case valley(const std::vector<std::string>& overrides = {}) {
  return exchange::parse_case(R"(
format = 1
gravity = 9.81
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
height = 4
crest = 2
slopes = [2.0, 2.0]
[geometry.valley]
bottom = 2
slopes = [1.0, 0.0]
)",
                              "dam.toml", overrides);
}

/// 3 by 2 by 2 cells of 1 m; the base and the right side are fixed, the others are rollers.
exchange::Case block(const std::vector<std::string>& overrides = {}) {
  const gmsh::Block counts{.across = 3, .deep = 2};
  std::vector<std::string> all{"geometry.mesh.fixed=[\"base\", \"right\"]",
                               "geometry.mesh.roller=[\"left\", \"front\"]"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return exchange::parse_case(gmsh::case_of(gmsh::solid_block(counts).text(), counts), "block.toml", all);
}

/// By the widest band that does not hold the point.
double distance_to(const SolidPoint& point, const std::vector<BoundarySide>& sides) {
  double least = HUGE_VAL;
  for (const BoundarySide& side : sides)
    least = std::min(least, distance(side, point));
  return least;
}

} // namespace

TEST(BoundarySides, AreAsFarAsTheirNearestPointIs) {
  const BoundarySide square{{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};
  EXPECT_NEAR(distance(square, {0.5, 1.5, 3.0}), 2.0, 1e-14);
  EXPECT_NEAR(distance(square, {1.0, -3.0, 5.0}), 5.0, 1e-14) << "from an edge";
  EXPECT_NEAR(distance(square, {4.0, 3.0, 3.0}), 3.0, 1e-14) << "from a corner";
  const BoundarySide edge{{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}}};
  EXPECT_NEAR(distance(edge, {1.0, 3.0, 4.0}), 5.0, 1e-14) << "a floor without a width";
}

/// The plane of a flank of 1:1 is (1 + z + y)/sqrt(2) away, the crest at 4 m 4 - z.
TEST(BoundarySides, OfAValleyAreItsFloorItsFlanksAndWhatIsFreeBetweenThem) {
  const std::vector<BoundarySide> base = base_sides(valley()), free = free_sides(valley(), 2);
  EXPECT_NEAR(distance_to({0.0, -1.0, 1.5}, base), 1.5 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(distance_to({0.0, 0.8, 0.5}, base), 0.5, 1e-12) << "the floor; the wall is none";
  EXPECT_NEAR(distance_to({0.0, 0.9, 2.0}, base), 2.0, 1e-12);
  EXPECT_NEAR(distance_to({0.0, -4.0, 3.5}, free), 0.5, 1e-12) << "the crest reaches from flank to flank";
  EXPECT_NEAR(distance_to({0.0, -1.0, 0.0}, free), 4.0, 1e-12) << "the foot of a flank is not free";
  EXPECT_NEAR(distance_to({7.0, 0.0, 0.0}, free), 2.0 / std::sqrt(5.0), 1e-12) << "the slope of 1:2";
}

TEST(BoundarySides, OfAMeshAreHeldFromBelowOrFree) {
  const std::vector<BoundarySide> base = base_sides(block()), free = free_sides(block(), 2);
  EXPECT_EQ(base.size(), 6U) << "neither rollers nor the fixed side";
  EXPECT_EQ(free.size(), 6U + 6U) << "the top, and the back, which is in no group";
  EXPECT_NEAR(distance_to({2.9, 0.5, 0.7}, base), 0.7, 1e-14);
  EXPECT_NEAR(distance_to({2.9, 0.5, 0.7}, free), 1.3, 1e-14);
  EXPECT_NEAR(distance_to({2.9, 1.8, 0.7}, free), 0.2, 1e-14);
}

/// A flank at 45 degrees is part of the base.
TEST(BoundarySides, OfAMeshAreItsFlanksToo) {
  const auto open = [](std::array<double, 3>& node) { node[1] += node[1] == 0.0 ? -node[2] : 0.0; };
  const gmsh::Block counts{.across = 1, .deep = 2};
  const exchange::Case study =
      exchange::parse_case(gmsh::case_of(gmsh::solid_block(counts, open).text(), counts), "wedge.toml",
                           {"geometry.mesh.fixed=[\"base\", \"front\"]", "geometry.mesh.roller=[]"});
  EXPECT_NEAR(distance_to({0.5, 0.0, 1.5}, base_sides(study)), 1.5 / std::sqrt(2.0), 1e-12);
}

TEST(BoundaryBand, GrowsWithWhatIsBuilt) {
  for (const exchange::Case& study : {valley(), block()}) {
    const double top = study.geometry.height;
    const SolidPoint middle{0.5, 0.5, 0.5 * top};
    const BoundaryBand early = BoundaryBand::along_free_surface(study, 1, 0.2);
    const BoundaryBand late = BoundaryBand::along_free_surface(study, 2, 0.2);
    EXPECT_TRUE(early.holds(middle));
    EXPECT_FALSE(late.holds(middle));
    EXPECT_TRUE(late.holds({0.5, 0.5, top - 0.19}));
    EXPECT_FALSE(late.holds({0.5, 0.5, top - 0.21}));
    EXPECT_TRUE(BoundaryBand::along_base(study, 0.2).holds({0.5, 0.5, 0.1}));
    EXPECT_FALSE(BoundaryBand::along_base(study, 0.2).empty());
  }
}

TEST(BoundaryBand, OfAnExtrudedSectionIsThatOfItsSection) {
  exchange::Case section = valley();
  section.geometry.valley.reset();
  const BoundaryBand band = BoundaryBand::along_free_surface(section, 2, 0.3);
  EXPECT_TRUE(band.holds({0.0, 17.0, 3.8}));
  EXPECT_FALSE(band.holds({0.0, 17.0, 3.6}));
}

} // namespace settle::compare::test
