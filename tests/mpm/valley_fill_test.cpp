#include "settle/mpm/valley_fill.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "pieces.hpp"
#include "settle/exchange/valley.hpp"

using namespace settle;
using namespace settle::mpm;
using mpm::test::sum;

namespace {

/// One layer 2 m high; the crest 1.3 m wide, the floor 0.9 m.
exchange::Geometry dam(const std::vector<double>& slopes, const std::vector<double>& flanks) {
  exchange::Geometry geometry{.dimension = 3};
  geometry.embankment = exchange::Embankment{.height = 2.0, .crest = 1.3, .slopes = slopes};
  geometry.valley = exchange::Valley{.bottom = 0.9, .slopes = flanks};
  return geometry;
}

const exchange::Geometry lopsided = dam({2.0, 1.25}, {0.6, 1.1});

/// Of what lies between two heights, by Gauss points in closed form: everything is of degree 3 or less in the height.
Piece<3> whole(const exchange::Geometry& geometry, const Levels& levels) {
  Piece<3> total{Vector<3>::Zero(), 0.0};
  const double middle = 0.5 * (levels.low + levels.high), half = 0.5 * (levels.high - levels.low);
  for (const double side : {-1.0, 0.0, 1.0}) {
    const double height = middle + side * half * std::sqrt(0.6);
    const exchange::Span x = exchange::fill_at(*geometry.embankment, height);
    const exchange::Span y = exchange::valley_at(*geometry.valley, height);
    const double volume = (side == 0.0 ? 8.0 : 5.0) / 9.0 * half * x.width() * y.width();
    total.volume += volume;
    total.centroid += volume * Vector<3>(0.5 * (x.from + x.to), 0.5 * (y.from + y.to), height);
  }
  total.centroid /= total.volume;
  return total;
}

} // namespace

TEST(ValleyFill, KeepsTheVolumeOnAnyLattice) {
  const Levels levels{0.3, 1.71};
  for (const double size : {2.0, 0.5, 0.21}) {
    const Piece<3> filled = sum(cut_dam(lopsided, levels, {{-0.2, 0.017, 0.05}, size, 2}));
    EXPECT_NEAR(filled.volume, whole(lopsided, levels).volume, 1e-12 * filled.volume) << size;
  }
}

TEST(ValleyFill, KeepsTheFirstMomentButForSlivers) {
  const Levels levels{0.3, 1.71};
  for (const double size : {0.8, 0.4, 0.2}) {
    const Piece<3> filled = sum(cut_dam(lopsided, levels, {{-0.2, 0.017, 0.05}, size, 2}));
    EXPECT_NEAR((filled.centroid - whole(lopsided, levels).centroid).norm(), 0.0, 0.02 * size * size) << size;
  }
}

/// A cube that all four surfaces cut at once.
TEST(ValleyFill, IsExactWhereOneCellHoldsTheWholeDam) {
  const auto pieces = cut_dam(lopsided, {0.0, 2.0}, {{-10.0, -10.0, -10.0}, 20.0, 1});
  const Piece<3> filled = sum(pieces), exact = whole(lopsided, {0.0, 2.0});
  EXPECT_NEAR(filled.volume, exact.volume, 1e-13 * exact.volume);
  EXPECT_NEAR((filled.centroid - exact.centroid).norm(), 0.0, 1e-12);
}

TEST(ValleyFill, UprightSidesOnTheLatticeGiveTheLatticeItself) {
  const exchange::Geometry box = dam({0.0, 0.0}, {0.0, 0.0});
  const auto pieces = cut_dam(box, {0.0, 0.5}, {{-0.65, -0.45, 0.0}, 0.1, 2});
  ASSERT_EQ(pieces.size(), 13U * 9U * 5U * 8U);
  for (const Piece<3>& piece : pieces)
    EXPECT_NEAR(piece.volume, 0.05 * 0.05 * 0.05, 1e-15);
  EXPECT_NEAR((pieces.front().centroid - Vector<3>(-0.625, -0.425, 0.025)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((pieces[1].centroid - pieces[0].centroid - Vector<3>(0.05, 0.0, 0.0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((pieces[4].centroid - pieces[0].centroid - Vector<3>(0.0, 0.0, 0.05)).norm(), 0.0, 1e-14);
}

TEST(ValleyFill, EveryPieceLiesInTheDamAndNoneIsMuchHeavierThanALatticeCube) {
  const Lattice<3> lattice{{0.0, 0.0, 0.0}, 0.3, 2};
  for (const Piece<3>& piece : cut_dam(lopsided, {0.0, 2.0}, lattice)) {
    const exchange::Span x = exchange::fill_at(*lopsided.embankment, piece.centroid[2]);
    const exchange::Span y = exchange::valley_at(*lopsided.valley, piece.centroid[2]);
    EXPECT_GT(piece.centroid[0], x.from);
    EXPECT_LT(piece.centroid[0], x.to);
    EXPECT_GT(piece.centroid[1], y.from);
    EXPECT_LT(piece.centroid[1], y.to);
    EXPECT_LT(piece.volume, 2.0 * std::pow(lattice.spacing(), 3));
  }
}

TEST(ValleyFill, AVIsFilledDownToItsCorner) {
  exchange::Geometry v = lopsided;
  v.valley->bottom = 0.0;
  const Piece<3> filled = sum(cut_dam(v, {0.0, 0.4}, {{0.0, 0.0, 0.0}, 0.25, 2}));
  EXPECT_NEAR(filled.volume, whole(v, {0.0, 0.4}).volume, 1e-12);
}
