// What every space of shape functions has to be, in the plane and in space.

#include <random>

#include <gtest/gtest.h>

#include "blocks.hpp"

namespace settle::mpm::test {
namespace {

template <class Space>
class SpaceOf : public testing::Test {};
TYPED_TEST_SUITE(SpaceOf, EverySpace, SpaceName);

TYPED_TEST(SpaceOf, FunctionsSumToOneAndReproduceLinearFieldsAtPointsAnywhere) {
  using X = Vector<TypeParam::dim>;
  std::mt19937 random(5);
  auto body = block<TypeParam>({.columns = 4, .deep = 3, .rows = 5, .filled_rows = 4});
  scatter_positions(body, random, 0.4);
  const X slope = X::LinSpaced(-2.0, 5.0);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const auto stencil = body.space.stencil(body.points.cell[p], body.points, p);
    ASSERT_LE(stencil.size(), TypeParam::max_nodes);
    double sum = 0;
    X position = X::Zero(), gradient_sum = X::Zero(), gradient = X::Zero();
    for (int i = 0; i < stencil.size(); ++i) {
      const X node = body.space.node_position(stencil.node(i));
      EXPECT_GE(stencil.value(i), -1e-15);
      sum += stencil.value(i);
      position += stencil.value(i) * node;
      gradient_sum += stencil.gradients.col(i);
      gradient += slope.dot(node) * stencil.gradients.col(i);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LT((position - body.points.position_of(p)).norm(), 1e-14);
    EXPECT_LT(gradient_sum.norm(), 1e-13);
    EXPECT_LT((gradient - slope).norm(), 1e-12);
  }
}

TYPED_TEST(SpaceOf, CellsFillTheGridAndNoneLiesOutside) {
  constexpr int dim = TypeParam::dim;
  const auto body = block<TypeParam>({.columns = 4, .deep = 3, .rows = 5});
  const auto& space = body.space;
  EXPECT_NEAR(space.n_cells() * space.cell_volume() / (space.plan_area() * space.height()), 1.0, 1e-14);
  for (int axis = 0; axis < dim; ++axis)
    for (const double outside : {-1e-9, space.extent(axis) + 1e-9}) {
      Vector<dim> x = Vector<dim>::Constant(0.3);
      EXPECT_GE(space.locate(x), 0);
      x[axis] = outside;
      EXPECT_EQ(space.locate(x), -1);
    }
}

TYPED_TEST(SpaceOf, ColumnsAndRowsOfCellsAreThoseOfTheSquaresTheyLieIn) {
  constexpr int dim = TypeParam::dim;
  const auto body = block<TypeParam>({.columns = 4, .deep = 3, .rows = 5});
  const auto& space = body.space;
  for (int cell = 0; cell < space.n_cells(); ++cell) {
    const Vector<dim> middle =
        space.corner(space.column_of(cell), space.row_of(cell)) + Vector<dim>::LinSpaced(0.2, 0.25);
    const int found = space.locate(middle);
    EXPECT_EQ(found / TypeParam::cells_per_square, cell / TypeParam::cells_per_square);
    EXPECT_NEAR(middle[dim - 1], space.row_of(cell) * space.size() + 0.25, 1e-14);
  }
}

/// Spaces of products: what is left of one in three dimensions where its functions are summed over an axis is the one
/// of the two others.
template <class Solid>
struct PlaneOf;
template <>
struct PlaneOf<HexahedronSpace> {
  using Space = QuadrilateralSpace;
};
template <>
struct PlaneOf<GimpSpace<3>> {
  using Space = GimpSpace<2>;
};
template <>
struct PlaneOf<BSplineSpace<3>> {
  using Space = BSplineSpace<2>;
};
template <>
struct PlaneOf<BSplineGimpSpace<3>> {
  using Space = BSplineGimpSpace<2>;
};

template <class Space>
class ProductSpaceOf : public testing::Test {};
using ProductSpaces = testing::Types<HexahedronSpace, GimpSpace<3>, BSplineSpace<3>, BSplineGimpSpace<3>>;
TYPED_TEST_SUITE(ProductSpaceOf, ProductSpaces, SpaceName);

template <class T>
PerAxis<T, 2> without_axis(const PerAxis<T, 3>& values, std::size_t axis) {
  return {values[axis == 0 ? 1 : 0], values[axis == 2 ? 1 : 2]};
}
Vector<2> without_axis(const Vector<3>& x, int axis) {
  return {x[axis == 0 ? 1 : 0], x[axis == 2 ? 1 : 2]};
}

/// Of a point at x, with this domain where the space needs one.
template <class Space>
typename Space::Stencil stencil_at(const Space& space, const Vector<Space::dim>& x,
                                   const Vector<Space::dim>& half_lengths) {
  Points<Space::dim> points;
  points.has_domains = Space::has_domains;
  points.add({.position = x, .half_lengths = half_lengths});
  return space.stencil(space.locate(x), points, 0);
}

TYPED_TEST(ProductSpaceOf, SummedOverOneAxisItIsTheOneInThePlaneOfTheOthers) {
  using Plane = typename PlaneOf<TypeParam>::Space;
  const GridBox<3> box{.counts = {4, 3, 5}, .size = 0.3, .origin = {-0.4, 0.2, 0.7}};
  const TypeParam solid(box);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < 60; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const auto dropped = static_cast<std::size_t>(axis);
      const Plane plane({without_axis(box.counts, dropped), box.size, without_axis(box.origin, axis)});
      Vector<3> x, half;
      for (int d = 0; d < 3; ++d) {
        x[d] = box.origin[d] + unit(random) * solid.extent(d);
        half[d] = unit(random) * 0.5 * box.size;
      }
      const auto in_space = stencil_at(solid, x, half);
      const auto expected = stencil_at(plane, without_axis(x, axis), without_axis(half, axis));
      for (int j = 0; j < expected.size(); ++j) {
        double value = -expected.value(j);
        Vector<2> gradient = -expected.gradients.col(j);
        for (int i = 0; i < in_space.size(); ++i) {
          const auto index = without_axis(solid.node_numbering().index(in_space.node(i)), dropped);
          if (plane.node_numbering().number(index) != expected.node(j)) continue;
          value += in_space.value(i);
          gradient += without_axis(Vector<3>(in_space.gradients.col(i)), axis);
        }
        EXPECT_NEAR(value, 0.0, 1e-14);
        EXPECT_LT(gradient.norm(), 1e-12);
      }
    }
}

TEST(BoxNumbering, RunsAlongXFirstThenYAndRowAfterRowUpwards) {
  const BoxNumbering<3> numbering{{4, 3, 5}};
  EXPECT_EQ(numbering.size(), 60);
  EXPECT_EQ(numbering.columns(), 12);
  EXPECT_EQ(numbering.number({1, 2, 3}), 1 + 4 * (2 + 3 * 3));
  for (int n = 0; n < numbering.size(); ++n)
    EXPECT_EQ(numbering.number(numbering.index(n)), n);
}

} // namespace
} // namespace settle::mpm::test
