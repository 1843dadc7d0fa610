#include "settle/mpm/polygon_fill.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <gtest/gtest.h>

using namespace settle;
using namespace settle::mpm;

namespace {

const exchange::Polygon triangle{.corners = {{0.13, 0.07}, {4.31, 0.92}, {1.7, 3.05}}};

/// Area and first moment of a triangle in closed form.
Piece<2> whole(const exchange::Polygon& t) {
  const Vector<2> a(t.corners[0][0], t.corners[0][1]), b(t.corners[1][0], t.corners[1][1]),
      c(t.corners[2][0], t.corners[2][1]);
  const Vector<2> u = b - a, v = c - a;
  return {(a + b + c) / 3.0, 0.5 * (u[0] * v[1] - u[1] * v[0])};
}

Piece<2> sum(const std::vector<Piece<2>>& pieces) {
  Piece<2> total{Vector<2>::Zero(), 0.0};
  for (const Piece<2>& piece : pieces) {
    total.volume += piece.volume;
    total.centroid += piece.volume * piece.centroid;
  }
  total.centroid /= total.volume;
  return total;
}

} // namespace

TEST(PolygonFill, KeepsTheAreaOnAnyLattice) {
  for (const double size : {2.0, 0.5, 0.11, 0.03}) {
    const Piece<2> filled = sum(cut_polygon(triangle, {{-0.2, 0.017}, size, 2}));
    EXPECT_NEAR(filled.volume, whole(triangle).volume, 1e-12 * filled.volume) << size;
  }
}

/// Slivers of cells are a share h of the area of cut cells, and shifted by less than a cell: their moment is of order
/// h^3.
TEST(PolygonFill, KeepsTheFirstMomentButForSlivers) {
  for (const double size : {0.4, 0.1, 0.025}) {
    const Piece<2> filled = sum(cut_polygon(triangle, {{-0.2, 0.017}, size, 2}));
    EXPECT_NEAR((filled.centroid - whole(triangle).centroid).norm(), 0.0, 0.05 * size * size) << size;
  }
}

TEST(PolygonFill, ARectangleOfWholeSquaresGetsTheLatticeItself) {
  const auto pieces = cut_polygon({.corners = {{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}}}, {{0, 0}, 0.5, 2});
  ASSERT_EQ(pieces.size(), 8U);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::size_t cell = k / 4, column = 2 * cell + k % 2, row = k % 4 / 2;
    EXPECT_NEAR(pieces[k].centroid[0], 0.125 + 0.25 * static_cast<double>(column), 1e-15);
    EXPECT_NEAR(pieces[k].centroid[1], 0.125 + 0.25 * static_cast<double>(row), 1e-15);
    EXPECT_NEAR(pieces[k].volume, 0.0625, 1e-15);
  }
}

TEST(PolygonFill, NoPieceIsMuchHeavierThanALatticeSquareOrALotLighterThanThoseOfItsCell) {
  for (const Piece<2>& piece : cut_polygon(triangle, {{0, 0}, 0.2, 2})) {
    EXPECT_GE(piece.volume, 0.01 / 3.0 / 64.0);
    EXPECT_LE(piece.volume, 0.01 * 2.0);
  }
}

TEST(PolygonFill, ACutCellHasAtLeastThreePiecesAndAFullOneTheLattice) {
  std::map<std::pair<int, int>, std::vector<Piece<2>>> cells;
  for (const Piece<2>& piece : cut_polygon(triangle, {{0, 0}, 0.2, 1}))
    cells[{static_cast<int>(piece.centroid[0] / 0.2), static_cast<int>(piece.centroid[1] / 0.2)}].push_back(piece);
  for (const auto& [cell, pieces] : cells) {
    const bool full = pieces.size() == 1 && pieces[0].volume > 0.04 * (1.0 - 1e-9); // or more, with a sliver beside it
    EXPECT_TRUE(full || pieces.size() >= 3) << cell.first << " " << cell.second;
  }
}

TEST(PolygonFill, EveryPieceLiesInThePolygon) {
  for (const Piece<2>& piece : cut_polygon(triangle, {{0, 0}, 0.07}))
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = triangle.corners[i], &b = triangle.corners[(i + 1) % 3];
      EXPECT_GT((b[0] - a[0]) * (piece.centroid[1] - a[1]) - (b[1] - a[1]) * (piece.centroid[0] - a[0]), 0.0);
    }
}

TEST(PolygonFill, APolygonThinnerThanASquareIsNotLost) {
  const exchange::Polygon strip{.corners = {{0, 0.1}, {3, 0.1}, {3, 0.15}, {0, 0.15}}};
  EXPECT_NEAR(sum(cut_polygon(strip, {{0, 0}, 1.0})).volume, 0.15, 1e-14);
}

TEST(PolygonFill, PolygonsThatTouchShareTheAreaWithoutGapOrOverlap) {
  const exchange::Polygon lower{.corners = {{0, 0}, {3, 0}, {0, 3}}},
      upper{.corners = {{3, 0}, {5, 0}, {0, 5}, {0, 3}}};
  const Lattice<2> lattice{{0, 0}, 0.3};
  const double both = sum(cut_polygon(lower, lattice)).volume + sum(cut_polygon(upper, lattice)).volume;
  EXPECT_NEAR(both, 12.5, 1e-12);
}
