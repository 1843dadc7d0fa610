// The gradients that internal force and strain share.

#include "cell_gradients.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"

namespace settle::mpm::test {
namespace {

/// Points anywhere in their cells, of different volumes.
template <class Space>
Body<Space> scattered_block(StressIntegration integration) {
  std::mt19937 random(7);
  auto body = block<Space>();
  body.integration = integration;
  scatter_positions(body, random, 0.3);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  for (double& volume : body.points.volume)
    volume *= share(random);
  return body;
}

/// What the patches of a cell sum to.
template <int dim>
struct Sums {
  double volume = 0;
  Eigen::Matrix<double, dim, Eigen::Dynamic> gradients; ///< weighted by volume
};

template <class Space>
Sums<Space::dim> sums_of(const Body<Space>& body, int cell) {
  const CellGradients<Space> gradients(body, cell);
  Sums<Space::dim> sums;
  sums.gradients.setZero(Space::dim, gradients.n_nodes());
  gradients.for_each_patch([&](const Patch<Space>& patch) {
    sums.volume += patch.volume;
    sums.gradients += patch.volume * patch.gradients.leftCols(gradients.n_nodes());
  });
  return sums;
}

/// The gradient of a node; zero if the stencil does not name it.
template <class Stencil>
auto gradient_of(const Stencil& stencil, int node) {
  Vector<Stencil::Gradients::RowsAtCompileTime> gradient;
  gradient.setZero();
  for (int i = 0; i < stencil.size(); ++i)
    if (stencil.node(i) == node) gradient = stencil.gradients.col(i);
  return gradient;
}

template <class Space>
class CellGradientsOf : public testing::Test {};
TYPED_TEST_SUITE(CellGradientsOf, EverySpace, SpaceName);

TYPED_TEST(CellGradientsOf, PatchesHoldEveryPointOnce) {
  const auto body = scattered_block<TypeParam>(StressIntegration::full_cells);
  std::size_t next = 0;
  for (const int cell : body.cells.occupied)
    CellGradients<TypeParam>(body, cell).for_each_patch([&](const Patch<TypeParam>& patch) {
      EXPECT_EQ(patch.points.first, next);
      next = patch.points.last;
    });
  EXPECT_EQ(next, body.points.size());
}

TYPED_TEST(CellGradientsOf, OfFullCellsHaveTheCellsVolumeAndItsMeanGradientWhereverThePointsAre) {
  const auto body = scattered_block<TypeParam>(StressIntegration::full_cells);
  const double volume = body.space.cell_volume();
  for (const int cell : body.cells.occupied) {
    const auto sums = sums_of(body, cell);
    const auto average = body.space.cell_average(cell);
    const CellGradients<TypeParam> gradients(body, cell);
    EXPECT_NEAR(sums.volume / volume, 1.0, 1e-14);
    for (int i = 0; i < gradients.n_nodes(); ++i)
      EXPECT_LT((sums.gradients.col(i) / volume - gradient_of(average, gradients.node(i))).norm(),
                1e-13 / body.space.size());
  }
}

TYPED_TEST(CellGradientsOf, OfPointsVolumesAreThoseOfTheShapeFunctions) {
  const auto body = scattered_block<TypeParam>(StressIntegration::points);
  for (const int cell : body.cells.occupied) {
    const CellGradients<TypeParam> gradients(body, cell);
    gradients.for_each_patch([&](const Patch<TypeParam>& patch) {
      double volume = 0;
      for (std::size_t p = patch.points.first; p < patch.points.last; ++p) {
        volume += body.points.volume[p];
        const auto own = body.space.stencil(cell, body.points, p);
        for (int i = 0; i < gradients.n_nodes(); ++i)
          EXPECT_LT((patch.gradients.col(i) - gradient_of(own, gradients.node(i))).norm(), 1e-13);
      }
      EXPECT_NEAR(patch.volume, volume, 1e-15);
    });
  }
}

TYPED_TEST(CellGradientsOf, ReproduceTheGradientOfALinearFieldAtEveryPoint) {
  for (const auto integration : {StressIntegration::full_cells, StressIntegration::points}) {
    const auto body = scattered_block<TypeParam>(integration);
    using Field = Vector<TypeParam::dim>;
    const Field exact = Field::LinSpaced(0.7, -0.4);
    for (const int cell : body.cells.occupied) {
      const CellGradients<TypeParam> gradients(body, cell);
      gradients.for_each_patch([&](const Patch<TypeParam>& patch) {
        Field gradient = Field::Zero();
        for (int i = 0; i < gradients.n_nodes(); ++i)
          gradient += exact.dot(body.space.node_position(gradients.node(i))) * patch.gradients.col(i);
        EXPECT_LT((gradient - exact).norm(), 1e-13);
      });
    }
  }
}

/// Quadrilaterals whose points name their nodes each in an order of its own, as spaces do whose points have domains.
class WanderingSpace : public QuadrilateralSpace {
public:
  using Stencil = mpm::Stencil<dim, max_nodes, StencilNodes::of_the_point>;
  using QuadrilateralSpace::QuadrilateralSpace;

  [[nodiscard]] Stencil stencil(int cell, const Points<2>& points, std::size_t p) const {
    return turned(QuadrilateralSpace::stencil(cell, points, p), static_cast<int>(p % 4));
  }
  [[nodiscard]] Stencil cell_average(int cell) const { // names two nodes of four: the others have to be found
    Stencil average = turned(QuadrilateralSpace::cell_average(cell), 1);
    average.count = 2;
    return average;
  }

private:
  static Stencil turned(const QuadrilateralSpace::Stencil& stencil, int by) {
    Stencil result{};
    for (int i = 0; i < max_nodes; ++i) {
      const int from = (i + by) % max_nodes;
      result.nodes[static_cast<std::size_t>(i)] = stencil.node(from);
      result.values[static_cast<std::size_t>(i)] = stencil.value(from);
      result.gradients.col(i) = stencil.gradients.col(from);
    }
    return result;
  }
};

TEST(CellGradients, OfPointsThatTouchDifferentNodesAreOverAllOfThem) {
  const auto body = scattered_block<QuadrilateralSpace>(StressIntegration::points);
  const Body<WanderingSpace> wandering{.space = WanderingSpace(body.space.box()),
                                       .points = body.points,
                                       .layout = body.layout,
                                       .cells = body.cells,
                                       .fixed = body.fixed,
                                       .lame = body.lame,
                                       .integration = body.integration};
  for (const int cell : body.cells.occupied) {
    const CellGradients<WanderingSpace> gradients(wandering, cell);
    ASSERT_EQ(gradients.n_nodes(), 4);
    gradients.for_each_patch([&](const Patch<WanderingSpace>& patch) {
      const auto own = body.space.stencil(cell, body.points, patch.points.first);
      for (int i = 0; i < 4; ++i) {
        const auto at = std::find(own.nodes.begin(), own.nodes.end(), gradients.node(i)) - own.nodes.begin();
        ASSERT_LT(at, 4);
        EXPECT_LT((patch.gradients.col(i) - own.gradients.col(at)).norm(), 1e-13);
      }
    });
  }
}

} // namespace
} // namespace settle::mpm::test
