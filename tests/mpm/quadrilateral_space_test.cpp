// Bilinear quadrilaterals: shape functions, cells and their corners.

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>

#include "settle/mpm/cell_table.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm::test {
namespace {

const QuadrilateralSpace space({.counts = {5, 7}, .size = 0.3, .origin = {-0.4, 1.2}});

Vector<2> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return space.origin() + Vector<2>(unit(random) * space.width(), unit(random) * space.height());
}

TEST(QuadrilateralSpace, ShapeFunctionsSumToOneAndReproduceBilinearFieldsInsideAndOutsideTheirCell) {
  std::mt19937 random(2);
  const auto field = [](const Vector<2>& x) { return 3.0 - 2.0 * x[0] + 5.0 * x[1] + 4.0 * x[0] * x[1]; };
  for (int cell = 0; cell < space.n_cells(); ++cell) {
    const auto x = random_point(random);
    const auto stencil = space.stencil_at(cell, x);
    double sum = 0, value = 0;
    Vector<2> gradient = Vector<2>::Zero();
    for (int i = 0; i < stencil.size(); ++i) {
      const double nodal = field(space.node_position(stencil.node(i)));
      sum += stencil.value(i);
      value += stencil.value(i) * nodal;
      gradient += nodal * stencil.gradients.col(i);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(value, field(x), 1e-11);
    EXPECT_LT((gradient - Vector<2>(-2.0 + 4.0 * x[1], 5.0 + 4.0 * x[0])).norm(), 1e-10);
  }
}

TEST(QuadrilateralSpace, LocateFindsTheOneCellInWhichNoShapeFunctionIsNegative) {
  std::mt19937 random(4);
  for (int k = 0; k < 500; ++k) {
    const auto x = random_point(random);
    const int found = space.locate(x);
    for (int cell = 0; cell < space.n_cells(); ++cell) {
      const auto values = space.stencil_at(cell, x).values;
      EXPECT_EQ(*std::min_element(values.begin(), values.end()) >= 0.0, cell == found) << "cell " << cell;
    }
  }
}

TEST(QuadrilateralSpace, PointsOutsideHaveNoCellWhereverTheGridStarts) {
  const Vector<2> low = space.origin(), high = low + Vector<2>(space.width(), space.height());
  for (const Vector<2>& x : {Vector<2>(low[0] - 1e-9, 2.0), Vector<2>(0.1, low[1] - 1e-9),
                             Vector<2>(high[0] + 1e-9, 2.0), Vector<2>(0.1, high[1] + 1e-9)})
    EXPECT_EQ(space.locate(x), -1) << x.transpose();
}

TEST(QuadrilateralSpace, APointOutsideIsLostWithTheBoxOfTheGrid) {
  Points<2> points;
  points.add({.position = {0.25, 0.5}, .volume = 1.0, .density = 1.0});
  CellTable table;
  try {
    sort_by_cell(space, points, table);
    FAIL() << "the point is below the grid";
  } catch (const PointLost& lost) {
    EXPECT_THAT(lost.what(), testing::HasSubstr("[-0.4, 1.1] x [1.2, 3.3] m"));
  }
}

} // namespace
} // namespace settle::mpm::test
