// Cubes cut into six tetrahedra: cells, faces, Gauss points, and what the stable step rests on.

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "settle/mpm/point_layout.hpp"
#include "settle/mpm/tetrahedron_space.hpp"

namespace settle::mpm::test {
namespace {

const TetrahedronSpace grid({.counts = {3, 4, 2}, .size = 0.3, .origin = {-0.4, 0.2, 0.7}});

Vector<3> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Vector<3> x = grid.origin();
  for (int d = 0; d < 3; ++d)
    x[d] += unit(random) * grid.extent(d);
  return x;
}

/// The corners of a cell, one a column.
Eigen::Matrix<double, 3, 4> corners(int cell) {
  Eigen::Matrix<double, 3, 4> positions;
  for (int i = 0; i < 4; ++i)
    positions.col(i) = grid.node_position(grid.nodes(cell)[static_cast<std::size_t>(i)]);
  return positions;
}

TEST(TetrahedronSpace, LocateFindsTheOneCellInWhichNoShapeFunctionIsNegative) {
  std::mt19937 random(3);
  for (int k = 0; k < 300; ++k) {
    const Vector<3> x = random_point(random);
    const int found = grid.locate(x);
    for (int cell = 0; cell < grid.n_cells(); ++cell) {
      const auto values = grid.values(cell, x);
      EXPECT_EQ(*std::min_element(values.begin(), values.end()) >= 0.0, cell == found) << "cell " << cell;
    }
  }
}

TEST(TetrahedronSpace, EveryCellHasASixthOfItsCube) {
  for (int cell = 0; cell < grid.n_cells(); ++cell) {
    const auto x = corners(cell);
    Tensor<3> edges;
    edges << x.col(1) - x.col(0), x.col(2) - x.col(0), x.col(3) - x.col(0);
    EXPECT_NEAR(std::abs(edges.determinant()) / 6.0 / grid.cell_volume(), 1.0, 1e-13);
  }
}

TEST(TetrahedronSpace, FieldsAreContinuousWhereCubesAndCellsMeet) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<double> nodal(static_cast<std::size_t>(grid.n_nodes()));
  for (double& value : nodal)
    value = any(random);
  const auto field = [&](const Vector<3>& x) {
    const int cell = grid.locate(x);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += grid.values(cell, x)[i] * nodal[static_cast<std::size_t>(grid.nodes(cell)[i])];
    return sum;
  };
  const double step = 1e-9 * grid.size();
  for (int k = 0; k < 300; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      Vector<3> on_face = random_point(random); // of two cubes, then between two cells of a cube
      on_face[axis] = grid.origin()[axis] + grid.size();
      const Vector<3> across = step * Vector<3>::Unit(axis);
      EXPECT_NEAR(field(on_face - across), field(on_face + across), 1e-7);
      const int other = (axis + 1) % 3;
      Vector<3> local = 0.9 * (random_point(random) - grid.origin()) / grid.extent(1);
      local[other] = local[axis];
      const Vector<3> inside = grid.corner({1, 2, 1}) + grid.size() * local;
      EXPECT_NEAR(field(inside - across), field(inside + across), 1e-7);
    }
}

TEST(TetrahedronSpace, GradientsAreTheDerivativesOfTheValues) {
  std::mt19937 random(5);
  for (int cell = 0; cell < grid.n_cells(); ++cell)
    for (int d = 0; d < 3; ++d) {
      const Vector<3> x = random_point(random), shift = 0.1 * Vector<3>::Unit(d);
      const auto ahead = grid.values(cell, x + shift), behind = grid.values(cell, x - shift);
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(grid.gradients(cell)(d, static_cast<int>(i)), (ahead[i] - behind[i]) / 0.2, 1e-12);
    }
}

TEST(TetrahedronSpace, NoTetrahedronVibratesFasterThanTheStableStepAllows) {
  const double allowed = 2.0 / grid.shortest_length(); // a frequency omega is stable up to a step of 2 / omega
  for (int cell = 0; cell < TetrahedronSpace::cells_per_square; ++cell) { // of waves of speed 1, a quarter of the mass
    const Eigen::Matrix4d scaled = 4.0 * grid.gradients(cell).transpose() * grid.gradients(cell); // at every node
    const double highest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(scaled).eigenvalues().maxCoeff();
    EXPECT_NEAR(std::sqrt(highest) / allowed, 1.0, 1e-13);
  }
}

TEST(TetrahedronLayout, FourPointsOfEveryCellIntegrateQuadraticsExactly) {
  const TetrahedronSpace cube({.counts = {1, 1, 1}});
  const PointLayout<3> layout = tetrahedron_layout();
  ASSERT_EQ(layout.points_per_square(), 24U);
  for (int cell = 0; cell < 6; ++cell) {
    const auto& positions = layout.cells[static_cast<std::size_t>(cell)];
    ASSERT_EQ(positions.size(), 4U);
    Tensor<3> by_points = Tensor<3>::Zero(), exact = Tensor<3>::Zero(); // mean of x x^T
    for (const Vector<3>& x : positions) {
      EXPECT_EQ(cube.locate(x), cell);
      by_points += 0.25 * x * x.transpose();
    }
    Vector<3> sum = Vector<3>::Zero();
    for (const int node : cube.nodes(cell)) {
      const Vector<3> x = cube.node_position(node);
      exact += x * x.transpose() / 20.0;
      sum += x;
    }
    exact += sum * sum.transpose() / 20.0;
    EXPECT_LT((by_points - exact).norm(), 1e-15);
  }
}

TEST(TetrahedronLayout, RefilledRowsAreAsHighAsTheSmallestDistanceOfRowsOfPoints) {
  const PointLayout<3> layout = tetrahedron_layout();
  std::vector<double> heights;
  for (const auto& cell : layout.cells)
    for (const Vector<3>& x : cell)
      heights.push_back(x[2]);
  std::sort(heights.begin(), heights.end());
  double smallest = 1.0;
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (heights[i] - heights[i - 1] > 1e-9) smallest = std::min(smallest, heights[i] - heights[i - 1]);
  EXPECT_NEAR(layout.row_height, smallest, 1e-14);
}

} // namespace
} // namespace settle::mpm::test
