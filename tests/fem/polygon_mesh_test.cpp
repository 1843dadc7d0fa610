#include "polygon_mesh.hpp"

#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/errors.hpp"

namespace settle::fem::testing {
namespace {

using exchange::PlanePoint;
using exchange::Polygon;
using ::testing::AllOf;
using ::testing::HasSubstr;

exchange::Case case_of(std::vector<Polygon> polygons, double element_size) {
  exchange::Case study;
  study.geometry.shape = exchange::Shape::polygons;
  study.geometry.polygons = std::move(polygons);
  study.fem.element_size = element_size;
  return study;
}

const Polygon square{.layer = 1, .corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
const Polygon slanted{.layer = 2, .corners = {{1, 0}, {2.5, 0.5}, {2, 2}, {1, 1}}};
const Polygon triangle{.layer = 3, .corners = {{1, 1}, {2, 2}, {0, 1}}};

PlanePoint corner(const PlaneMesh& mesh, const PlaneMesh::Cell& cell, std::size_t i) {
  return mesh.vertices[cell.vertices[i]];
}

/// Of a quadrilateral in the order of the unit square.
double area(const PlaneMesh& mesh, const PlaneMesh::Cell& cell) {
  const PlanePoint a = corner(mesh, cell, 0), b = corner(mesh, cell, 1), c = corner(mesh, cell, 3),
                   d = corner(mesh, cell, 2);
  return ((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0])) / 2;
}

std::string complaint_about(const exchange::Case& study) {
  try {
    static_cast<void>(mesh_polygons(study));
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return {};
}

TEST(PolygonMesh, DividesARectangleIntoTheRowsOfAColumn) {
  const PlaneMesh mesh = mesh_polygons(case_of({{.layer = 4, .corners = {{1, 2}, {2, 2}, {2, 2.5}, {1, 2.5}}}}, 0.25));
  ASSERT_EQ(mesh.cells.size(), 8U);
  EXPECT_EQ(mesh.vertices.size(), 15U);
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const double left = 1 + 0.25 * static_cast<double>(i % 4), low = 2 + 0.25 * static_cast<double>(i / 4);
    EXPECT_EQ(mesh.cells[i].layer, 4);
    for (std::size_t v = 0; v < 4; ++v) {
      EXPECT_NEAR(corner(mesh, mesh.cells[i], v)[0], left + (v % 2 == 1 ? 0.25 : 0.0), 1e-15);
      EXPECT_NEAR(corner(mesh, mesh.cells[i], v)[1], low + (v >= 2 ? 0.25 : 0.0), 1e-15);
    }
  }
}

TEST(PolygonMesh, FillsEveryLayerWithCellsOfPositiveArea) {
  const exchange::Case study = case_of({square, slanted, triangle}, 0.2);
  const PlaneMesh mesh = mesh_polygons(study);
  std::map<int, double> areas;
  for (const PlaneMesh::Cell& cell : mesh.cells) {
    EXPECT_GT(area(mesh, cell), 0.0);
    areas[cell.layer] += area(mesh, cell);
  }
  for (const Polygon& polygon : study.geometry.polygons)
    EXPECT_NEAR(areas[polygon.layer], exchange::area(polygon), 1e-14);
}

TEST(PolygonMesh, DividesEdgesThatAreJoinedAlikeAndNoneMoreCoarselyThanAsked) {
  const PlaneMesh mesh = mesh_polygons(case_of({square, slanted, triangle}, 0.2));
  std::map<int, int> counts;
  for (const PlaneMesh::Cell& cell : mesh.cells)
    ++counts[cell.layer];
  EXPECT_EQ(counts[3], 3 * 6 * 6); // sqrt(5)/0.2 = 11.2
  EXPECT_EQ(counts[1], 12 * 8);    // one edge shared with each of the others
  EXPECT_EQ(counts[2], 12 * 8);    // sqrt(2.5)/0.2 = 7.9
  const PlaneMesh alone = mesh_polygons(case_of({square, slanted}, 0.2));
  EXPECT_EQ(alone.cells.size(), 5U * 8U + 8U * 8U);
}

TEST(PolygonMesh, DividesTheShorterOfTwoOppositeEdgesLikeTheLonger) {
  const Polygon trapezoid{.layer = 1, .corners = {{0, 0}, {1, 0}, {0.75, 1}, {0.25, 1}}};
  EXPECT_EQ(mesh_polygons(case_of({trapezoid}, 0.25)).cells.size(), 4U * 5U); // sqrt(17)/4/0.25 = 4.1
}

/// Its parts on either side of the middles of its edges are divided like each other.
TEST(PolygonMesh, FillsATriangleWhetherOrNotTheSizeGoesIntoItsEdgesAnOddNumberOfTimes) {
  for (const double size : {0.2, 0.25, 0.3, 0.35}) { // sqrt(5)/size = 11.2, 8.9, 7.5, 6.4
    const PlaneMesh mesh = mesh_polygons(case_of({triangle}, size));
    double whole = 0.0;
    for (const PlaneMesh::Cell& cell : mesh.cells)
      whole += area(mesh, cell);
    EXPECT_NEAR(whole, exchange::area(triangle), 1e-14) << size;
  }
}

/// Every inner edge belongs to two cells, and what belongs to one is the outline.
TEST(PolygonMesh, MeetsInWholeEdges) {
  const PlaneMesh mesh = mesh_polygons(case_of({square, slanted, triangle}, 0.2));
  std::map<std::pair<unsigned, unsigned>, int> cells_at_edge;
  for (const PlaneMesh::Cell& cell : mesh.cells) {
    const auto& v = cell.vertices;
    for (const auto& edge :
         {std::minmax(v[0], v[1]), std::minmax(v[1], v[3]), std::minmax(v[2], v[3]), std::minmax(v[0], v[2])})
      ++cells_at_edge[edge];
  }
  double outline = 0.0;
  for (const auto& [edge, cells] : cells_at_edge) {
    EXPECT_LE(cells, 2);
    const PlanePoint &a = mesh.vertices[edge.first], &b = mesh.vertices[edge.second];
    if (cells == 1) outline += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  EXPECT_NEAR(outline, 2 + std::sqrt(2.5) * 2 + std::sqrt(5.0), 1e-12);
}

TEST(PolygonMesh, HasNoTwoVerticesInOnePlace) {
  const PlaneMesh mesh = mesh_polygons(case_of({square, slanted, triangle}, 0.25));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GT(std::hypot(mesh.vertices[i][0] - mesh.vertices[j][0], mesh.vertices[i][1] - mesh.vertices[j][1]), 1e-3);
}

TEST(PolygonMesh, MergesCornersThatDifferByRoundOffOnly) {
  Polygon shifted = slanted;
  shifted.corners[0][0] += 1e-13;
  shifted.corners[3][1] -= 1e-13;
  EXPECT_EQ(mesh_polygons(case_of({square, shifted}, 0.2)).vertices.size(),
            mesh_polygons(case_of({square, slanted}, 0.2)).vertices.size());
}

TEST(PolygonMesh, AnElementSizeThatDividesAnEdgeUpToRoundOffDoesSo) {
  EXPECT_EQ(mesh_polygons(case_of({{.corners = {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}}}, 0.1)).cells.size(), 9U);
}

TEST(PolygonMesh, APentagonIsToBeDivided) {
  const Polygon pentagon{.corners = {{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 1}}};
  EXPECT_THAT(complaint_about(case_of({pentagon}, 0.5)),
              AllOf(HasSubstr("geometry.polygon.0"), HasSubstr("5 corners"),
                    HasSubstr("divide it into triangles and quadrilaterals")));
}

TEST(PolygonMesh, EdgesSharedInPartAreRefused) {
  const Polygon beside{.corners = {{1, 0.25}, {2, 0.25}, {2, 1}, {1, 1}}};
  EXPECT_THAT(complaint_about(case_of({square, beside}, 0.5)),
              AllOf(HasSubstr("within an edge of geometry.polygon.0"), HasSubstr("(1, 0.25) between (1, 0) and (1, 1)"),
                    HasSubstr("divide geometry.polygon.0 there")));
}

} // namespace
} // namespace settle::fem::testing
