#include "settle/mpm/mesh_fill.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "gmsh_text.hpp"
#include "pieces.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/valley.hpp"
#include "settle/mpm/valley_fill.hpp"

using namespace settle;
using namespace settle::mpm;
using mpm::test::sum;

namespace {

using Position = std::array<double, 3>;

exchange::Mesh mesh_of(const gmsh::Place& place, const gmsh::Block& counts = {.across = 3, .deep = 2, .layers = 2}) {
  const std::string text = gmsh::case_of(gmsh::solid_block(counts, place).text(), counts);
  return *exchange::parse_case(text, "block.toml", {"geometry.mesh.roller=[]"}).geometry.mesh;
}

void shear_and_twist(Position& node) {
  const auto [x, y, z] = node;
  node = {x + 0.3 * z + 0.05 * y * z, 1.1 * y + 0.1 * x * z, z + 0.2 * x + 0.05 * x * y};
}

} // namespace

TEST(MeshFill, KeepsTheVolumeOnAnyLattice) {
  const exchange::Mesh mesh = mesh_of(shear_and_twist);
  for (const int layer : {1, 2})
    for (const double size : {2.0, 0.5, 0.21}) {
      const Piece<3> filled = sum(cut_mesh(mesh, layer, {{-0.2, 0.017, 0.05}, size, 2}));
      EXPECT_NEAR(filled.volume, exchange::layer_volume(mesh, layer), 1e-12 * filled.volume) << size;
    }
}

/// A block that is sheared is a parallelepiped, with its centroid in the middle.
TEST(MeshFill, KeepsTheFirstMomentButForSlivers) {
  const exchange::Mesh mesh = mesh_of([](Position& node) { node[0] += 0.3 * node[2] - 0.2 * node[1]; });
  const Piece<3> filled = sum(cut_mesh(mesh, 1, {{0.013, 0.02, 0.0}, 0.1, 2}));
  EXPECT_NEAR((filled.centroid - Vector<3>(1.5 + 0.15 - 0.2, 1.0, 0.5)).norm(), 0.0, 1e-4);
}

/// Slopes along x and flanks along y, whose pieces are known in closed form. Which of two pieces that are as far away
/// gets the volume of a sliver is round-off.
TEST(MeshFill, OfADamInAValleyIsWhatItsClosedFormCuts) {
  exchange::Geometry dam{.dimension = 3};
  dam.embankment = exchange::Embankment{.height = 2.0, .crest = 1.3, .slopes = {2.03, 1.27}};
  dam.valley = exchange::Valley{.bottom = 0.91, .slopes = {0.63, 1.11}};
  const auto form = [&](Position& node) {
    const exchange::Span x = exchange::fill_at(*dam.embankment, node[2]), y = exchange::valley_at(*dam.valley, node[2]);
    node = {x.from + node[0] / 3.0 * x.width(), y.from + node[1] / 2.0 * y.width(), node[2]};
  };
  const Lattice<3> lattice{{-6.017, -3.013, 0.0}, 0.37, 2};
  std::vector<Piece<3>> meshed = cut_mesh(mesh_of(form), 2, lattice), exact = cut_dam(dam, {1.0, 2.0}, lattice);
  ASSERT_EQ(meshed.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i)
    EXPECT_NEAR((meshed[i].centroid - exact[i].centroid).norm(), 0.0, 1e-9);
  for (std::vector<Piece<3>>* pieces : {&meshed, &exact})
    std::sort(pieces->begin(), pieces->end(), [](const auto& a, const auto& b) { return a.volume < b.volume; });
  for (std::size_t i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(meshed[i].volume, exact[i].volume, 1e-12);
}

TEST(MeshFill, OfAlignedCubesIsTheLattice) {
  const std::vector<Piece<3>> pieces = cut_mesh(mesh_of({}), 2, {Vector<3>::Zero(), 1.0, 2});
  ASSERT_EQ(pieces.size(), 6U * 8U);
  for (const Piece<3>& piece : pieces) {
    EXPECT_NEAR(piece.volume, 0.125, 1e-14);
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(std::abs(std::remainder(piece.centroid[d], 0.5)), 0.25, 1e-13);
  }
}
