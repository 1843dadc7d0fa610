// The background grid: shape functions, cells and their corners.

#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "settle/mpm/cell_table.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm::test {
namespace {

const TriangleSpace grid({.counts = {5, 7}, .size = 0.3});

Vector<2> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return {unit(random) * grid.width(), unit(random) * grid.rows() * grid.size()};
}

/// Signed area of a triangle.
double area(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c) {
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
}

/// Barycentric coordinates of x from the areas of the three triangles it makes with the cell's corners.
TriangleSpace::Values barycentric(int cell, const Vector<2>& x) {
  const auto nodes = grid.nodes(cell);
  const auto a = grid.node_position(nodes[0]), b = grid.node_position(nodes[1]), c = grid.node_position(nodes[2]);
  const double whole = area(a, b, c);
  return {area(x, b, c) / whole, area(a, x, c) / whole, area(a, b, x) / whole};
}

TEST(TriangleSpace, ShapeFunctionsAreTheBarycentricCoordinatesOfTheCellsCorners) {
  std::mt19937 random(1);
  for (int k = 0; k < 1000; ++k) {
    const auto x = random_point(random);
    const int cell = grid.locate(x);
    const auto expected = barycentric(cell, x), values = grid.values(cell, x);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(values[i], expected[i], 1e-13);
  }
}

TEST(TriangleSpace, ShapeFunctionsSumToOneAndReproduceLinearFieldsInsideAndOutsideTheirCell) {
  std::mt19937 random(2);
  const auto linear = [](const Vector<2>& x) { return 3.0 - 2.0 * x[0] + 5.0 * x[1]; };
  for (int cell = 0; cell < grid.n_cells(); ++cell) {
    const auto x = random_point(random);
    const auto values = grid.values(cell, x);
    const auto nodes = grid.nodes(cell);
    double sum = 0, field = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += values[i];
      field += values[i] * linear(grid.node_position(nodes[i]));
    }
    EXPECT_NEAR(sum, 1.0, 1e-13);
    EXPECT_NEAR(field, linear(x), 1e-12);
  }
}

TEST(TriangleSpace, GradientsAreTheDifferencesOfTheShapeFunctions) {
  std::mt19937 random(3);
  const double step = 0.01;
  for (int cell = 0; cell < grid.n_cells(); ++cell) {
    const auto x = random_point(random);
    for (int d = 0; d < 2; ++d) {
      const auto ahead = grid.values(cell, x + step * Vector<2>::Unit(d));
      const auto behind = grid.values(cell, x - step * Vector<2>::Unit(d));
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        EXPECT_NEAR(grid.gradients(cell)(d, i), (ahead[k] - behind[k]) / (2.0 * step), 1e-11);
      }
    }
  }
}

TEST(TriangleSpace, LocateFindsTheOneCellInWhichNoBarycentricCoordinateIsNegative) {
  std::mt19937 random(4);
  for (int k = 0; k < 1000; ++k) {
    const auto x = random_point(random);
    const int found = grid.locate(x);
    for (int cell = 0; cell < grid.n_cells(); ++cell) {
      const auto b = barycentric(cell, x);
      EXPECT_EQ(b[0] >= 0.0 && b[1] >= 0.0 && b[2] >= 0.0, cell == found) << "cell " << cell << " of point " << k;
    }
  }
}

TEST(TriangleSpace, CornersOfEveryCellLieOnItsSquareAndTheRightAngleComesFirst) {
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) {
      const int lower = 2 * (column + grid.columns() * row);
      const auto corner = [&](int dx, int dy) {
        return Vector<2>((column + dx) * grid.size(), (row + dy) * grid.size());
      };
      const std::array<Vector<2>, 6> expected{corner(0, 0), corner(1, 0), corner(0, 1),
                                              corner(1, 1), corner(0, 1), corner(1, 0)};
      for (std::size_t i = 0; i < 6; ++i) {
        const int node = grid.nodes(lower + static_cast<int>(i) / 3)[i % 3];
        EXPECT_LT((grid.node_position(node) - expected[i]).norm(), 1e-14) << "square " << column << ", " << row;
      }
    }
}

TEST(TriangleSpace, CellsAreAsLargeAndAsHighAsTheirCornersSay) {
  for (int cell = 0; cell < grid.n_cells(); ++cell) {
    const auto nodes = grid.nodes(cell);
    const auto a = grid.node_position(nodes[0]), b = grid.node_position(nodes[1]), c = grid.node_position(nodes[2]);
    EXPECT_NEAR(grid.cell_volume(), area(a, b, c), 1e-14);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    EXPECT_NEAR(grid.shortest_length(), 2.0 * area(a, b, c) / longest, 1e-14);
  }
}

TEST(TriangleSpace, PointsOutsideHaveNoCell) {
  const double height = grid.rows() * grid.size();
  for (const Vector<2>& x : {Vector<2>(-1e-9, 0.1), Vector<2>(0.1, -1e-9), Vector<2>(grid.width() + 1e-9, 0.1),
                             Vector<2>(0.1, height + 1e-9)})
    EXPECT_EQ(grid.locate(x), -1) << x.transpose();
}

TEST(TriangleSpace, APointOutsideIsLostWithItsIdentityItsPositionAndTheBox) {
  Points<2> points;
  points.add({.position = {0.1, 0.1}, .volume = 1.0, .density = 1.0});
  points.add({.position = {0.25, 2.5}, .volume = 1.0, .density = 1.0});
  CellTable table;
  try {
    sort_by_cell(grid, points, table);
    FAIL() << "the second point is above the grid";
  } catch (const PointLost& lost) {
    EXPECT_EQ(lost.code(), exchange::ExitCode::solver_failed);
    EXPECT_THAT(lost.what(), testing::AllOf(testing::HasSubstr("material point 2"), testing::HasSubstr("(0.25, 2.5) m"),
                                            testing::HasSubstr("[0, 1.5] x [0, 2.1] m")));
  }
}

} // namespace
} // namespace settle::mpm::test
