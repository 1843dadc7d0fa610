// Who owns which nodes where cells are summed up in blocks.

#include <gmock/gmock.h>

#include "cell_blocks.hpp"

namespace settle::mpm::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Cell i of n in a row touches nodes i and i + 1.
CellNodes row_of_cells(int n) {
  CellNodes cells;
  for (int i = 0; i < n; ++i) {
    cells.nodes.insert(cells.nodes.end(), {i, i + 1});
    cells.begin.push_back(cells.nodes.size());
  }
  return cells;
}

std::vector<int> nodes_of(const CellBlocks& blocks, int block, int n_nodes) {
  std::vector<int> nodes;
  for (int node = 0; node < n_nodes; ++node)
    if (blocks.owns(block, node)) nodes.push_back(node);
  return nodes;
}

TEST(CellBlocks, OwnWhatNoEarlierCellTouchesAndKnowWhichLaterCellsReachIn) {
  const CellBlocks blocks({0, 2, 5}, row_of_cells(5), 6);
  EXPECT_EQ(blocks.count(), 2);
  EXPECT_THAT(nodes_of(blocks, 0, 6), ElementsAre(0, 1, 2));
  EXPECT_THAT(nodes_of(blocks, 1, 6), ElementsAre(3, 4, 5));
  EXPECT_THAT(blocks.reaching(0), ElementsAre(2)); // the cell between nodes 2 and 3
  EXPECT_THAT(blocks.reaching(1), IsEmpty());
  EXPECT_EQ(blocks.n_kept(), 1);
  EXPECT_EQ(blocks.kept(2), 0);
  EXPECT_EQ(blocks.kept(3), -1);
}

TEST(CellBlocks, MayBeEmptyOrOwnNothing) {
  const CellNodes twice{.nodes = {0, 1, 1, 2, 0, 2}, .begin = {0, 2, 4, 6}};
  const CellBlocks blocks({0, 2, 2, 3}, twice, 4);
  EXPECT_THAT(nodes_of(blocks, 0, 4), ElementsAre(0, 1, 2));
  EXPECT_THAT(nodes_of(blocks, 1, 4), IsEmpty());
  EXPECT_THAT(nodes_of(blocks, 2, 4), ElementsAre(3)); // which no cell touches
  EXPECT_THAT(blocks.reaching(0), ElementsAre(2));     // once, though it touches two nodes there
}

TEST(CellBlocks, OneOwnsEverythingAndKeepsNothing) {
  const CellBlocks blocks({0, 5}, row_of_cells(5), 6);
  EXPECT_EQ(nodes_of(blocks, 0, 6).size(), 6U);
  EXPECT_EQ(blocks.n_kept(), 0);
}

} // namespace
} // namespace settle::mpm::test
