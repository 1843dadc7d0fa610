#include "embankment_mesh.hpp"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "drawn_bodies.hpp"
#include "polygon_mesh.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::fem::testing {
namespace {

using exchange::PlanePoint;

PlanePoint corner(const PlaneMesh& mesh, const PlaneMesh::Cell& cell, std::size_t i) {
  return mesh.vertices[cell.vertices[i]];
}

/// Of a quadrilateral in the order of the unit square.
double area(const PlaneMesh& mesh, const PlaneMesh::Cell& cell) {
  const PlanePoint a = corner(mesh, cell, 0), b = corner(mesh, cell, 1), c = corner(mesh, cell, 3),
                   d = corner(mesh, cell, 2);
  return ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])) / 2;
}

bool is_upright_rectangle(const PlaneMesh& mesh, const PlaneMesh::Cell& cell) {
  std::set<long> x, y;
  for (std::size_t v = 0; v < 4; ++v) {
    x.insert(std::lround(corner(mesh, cell, v)[0] * 1e9));
    y.insert(std::lround(corner(mesh, cell, v)[1] * 1e9));
  }
  return x.size() == 2 && y.size() == 2;
}

TEST(EmbankmentMesh, FillsEveryLayerWithCellsOfPositiveArea) {
  for (const double depth : {0.0, 1.3}) {
    const exchange::Case study = embankment({.foundation_depth = depth});
    const PlaneMesh mesh = mesh_polygons(study);
    std::map<int, double> areas;
    for (const PlaneMesh::Cell& cell : mesh.cells) {
      EXPECT_GT(area(mesh, cell), 0.0);
      areas[cell.layer] += area(mesh, cell);
    }
    for (int layer = 1; layer <= study.construction.layers; ++layer)
      EXPECT_NEAR(areas[layer], exchange::layer_area(study.geometry, layer), 1e-12);
  }
}

/// Sizes that go into the layers as the slope of 2 needs it: 1 m / (n / sqrt(2)).
TEST(EmbankmentMesh, HasCellsOfTheSizeAskedForOnAverage) {
  for (const double rows : {2.0, 4.0, 8.0}) {
    const exchange::Case study = embankment({.element_size = std::sqrt(2.0) / rows});
    const PlaneMesh mesh = mesh_polygons(study);
    const double section = 3.0 * 2.0 + 9.0 * 3.5 / 2;
    const double asked = section / (study.fem.element_size * study.fem.element_size);
    EXPECT_NEAR(static_cast<double>(mesh.cells.size()), asked, 0.25 * asked) << rows;
    for (const PlaneMesh::Cell& cell : mesh.cells)
      for (std::size_t v = 1; v < 4; ++v)
        EXPECT_LE(std::abs(corner(mesh, cell, v)[1] - corner(mesh, cell, 0)[1]), 4.0 / 3.0 * study.fem.element_size)
            << "the three parts of a triangle meet in its middle";
  }
}

TEST(EmbankmentMesh, IsOfRectanglesButAtTheSlopes) {
  const exchange::Case study = embankment({.foundation_depth = 1.0});
  const PlaneMesh mesh = mesh_polygons(study);
  std::size_t others = 0;
  for (const PlaneMesh::Cell& cell : mesh.cells)
    if (!is_upright_rectangle(mesh, cell)) ++others;
  EXPECT_EQ(others, 12U * 2U * 3U); // edges of four parts: twelve cells in the triangle at each end of each lift
  EXPECT_GT(mesh.cells.size(), 5 * others);
}

TEST(EmbankmentMesh, HasNoMoreVerticesThanItsPartsShare) {
  const PlaneMesh mesh = mesh_polygons(embankment({.foundation_depth = 1.0}));
  std::set<std::pair<long, long>> places;
  for (const PlanePoint& vertex : mesh.vertices)
    places.insert({std::lround(vertex[0] * 1e9), std::lround(vertex[1] * 1e9)});
  EXPECT_EQ(places.size(), mesh.vertices.size());
}

/// A wall on one side has no triangles there.
TEST(EmbankmentMesh, TakesUprightSidesAndAFoundationThatEndsAtTheToe) {
  const exchange::Case study = embankment(
      {.foundation_depth = 1.0}, {"geometry.embankment.slopes=[0.0, 0.4]", "geometry.embankment.foundation_left=0.0"});
  const PlaneMesh mesh = mesh_polygons(study);
  double whole = 0.0;
  for (const PlaneMesh::Cell& cell : mesh.cells)
    whole += area(mesh, cell);
  EXPECT_NEAR(whole, 3.0 * 2.0 + 9.0 * 0.4 / 2 + 1.0 * (2.0 + 3.0 * 0.4 + 3.0), 1e-12);
}

TEST(EmbankmentMesh, IsDividedInHalvesWhereTheSizeIsHalved) {
  const std::size_t coarse = mesh_polygons(embankment({.element_size = 0.75})).cells.size();
  EXPECT_EQ(mesh_polygons(embankment({.element_size = 0.375})).cells.size(), 4 * coarse);
}

} // namespace
} // namespace settle::fem::testing
