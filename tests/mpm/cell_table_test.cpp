// Sorting points by cell.

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "blocks.hpp"

namespace settle::mpm::test {
namespace {

/// Every number a point carries but its cell.
auto content(const Points<2>& points, std::size_t p) {
  return std::tuple(points.layer[p], points.refilled[p], points.mass[p], points.volume[p], points.position[0][p],
                    points.position[1][p], points.placed[0][p], points.placed[1][p], points.velocity[0][p],
                    points.velocity[1][p], points.stress[0][p], points.stress[1][p], points.stress[2][p],
                    points.stress[3][p]);
}

using Contents = std::map<std::uint64_t, decltype(content(std::declval<Points<2>>(), 0))>;

Contents contents(const Points<2>& points) {
  Contents all;
  for (std::size_t p = 0; p < points.size(); ++p)
    all.emplace(points.id[p], content(points, p));
  return all;
}

/// A block whose points all differ in every array, with points in cells they are not sorted into.
Body<TriangleSpace> mixed_block() {
  std::mt19937 random(5);
  auto body = block();
  randomize_velocities(body, random);
  randomize_stresses(body, random);
  std::uniform_real_distribution<double> share(0.5, 1.5);
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    body.points.mass[p] *= share(random);
    body.points.volume[p] *= share(random);
    body.points.layer[p] = static_cast<std::int32_t>(p % 3);
    body.points.refilled[p] = p % 2 == 0 ? 1 : 0;
  }
  std::uniform_real_distribution<double> x(0.0, body.space.width()), y(0.0, body.space.rows() * body.space.size());
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    body.points.position[0][p] = x(random);
    body.points.position[1][p] = y(random);
  }
  return body;
}

TEST(SortByCell, PutsThePointsOfEveryCellIntoItsRange) {
  auto body = mixed_block();
  body.sort();
  const auto& begin = body.cells.begin;
  const auto& occupied = body.cells.occupied;
  EXPECT_TRUE(std::is_sorted(body.points.cell.begin(), body.points.cell.end()));
  ASSERT_EQ(begin.size(), static_cast<std::size_t>(body.space.n_cells()) + 1);
  EXPECT_EQ(begin.front(), 0U);
  EXPECT_EQ(begin.back(), body.points.size());
  for (int cell = 0; cell < body.space.n_cells(); ++cell) {
    const auto c = static_cast<std::size_t>(cell);
    EXPECT_EQ(begin[c + 1] - begin[c], std::count(body.points.cell.begin(), body.points.cell.end(), cell));
    EXPECT_EQ(std::binary_search(occupied.begin(), occupied.end(), cell), begin[c + 1] > begin[c]);
    EXPECT_EQ(body.cells.is_empty(cell), begin[c + 1] == begin[c]);
  }
  for (std::size_t p = 0; p < body.points.size(); ++p)
    EXPECT_EQ(body.points.cell[p], body.space.locate(body.points.position_of(p)));
}

TEST(SortByCell, CarriesEveryArrayWithItsPointAndLosesNothing) {
  auto body = mixed_block();
  const auto before = contents(body.points);
  body.sort();
  EXPECT_EQ(contents(body.points), before);
}

TEST(SortByCell, KeepsTheOrderOfPointsWithinACell) {
  auto body = mixed_block();
  std::map<std::uint64_t, std::size_t> place_before;
  for (std::size_t p = 0; p < body.points.size(); ++p)
    place_before[body.points.id[p]] = p;
  body.sort();
  for (std::size_t p = 1; p < body.points.size(); ++p)
    if (body.points.cell[p] == body.points.cell[p - 1]) {
      EXPECT_LT(place_before[body.points.id[p - 1]], place_before[body.points.id[p]]);
    }
}

TEST(SortByCell, LeavesPointsThatCrossNoCellBoundaryWhereTheyAre) {
  auto body = mixed_block();
  body.sort();
  const auto ids = body.points.id;
  const auto begin = body.cells.begin;
  for (std::size_t p = 0; p < body.points.size(); ++p) { // towards the middle of its cell: crosses nothing
    Vector<2> middle = Vector<2>::Zero();
    for (const int node : body.space.nodes(body.points.cell[p]))
      middle += body.space.node_position(node) / 3.0;
    for (std::size_t d = 0; d < 2; ++d)
      body.points.position[d][p] = 0.5 * (body.points.position[d][p] + middle[static_cast<int>(d)]);
  }
  body.sort();
  EXPECT_EQ(body.points.id, ids);
  EXPECT_EQ(body.cells.begin, begin);
}

TEST(SortByCell, TakesInPointsAddedLater) {
  auto body = block();
  const auto before = body.points.size();
  place_layer(body, {.layer = 2, .base = 1.5, .thickness = 0.5});
  body.sort();
  EXPECT_EQ(body.points.size(), before + 18);
  EXPECT_EQ(body.cells.begin.back(), before + 18);
  EXPECT_TRUE(std::is_sorted(body.points.cell.begin(), body.points.cell.end()));
  EXPECT_EQ(std::count(body.points.layer.begin(), body.points.layer.end(), 2), 18);
}

} // namespace
} // namespace settle::mpm::test
