/// \file
/// Occupied cells in blocks that threads sum up at a time, with the same bits as one cell after the other.
#pragma once

#include <cstddef>
#include <vector>

namespace settle::mpm {

/// Nodes of the occupied cells, one cell after the other.
struct CellNodes {
  std::vector<int> nodes;
  std::vector<std::size_t> begin{0}; ///< of a cell's nodes; n_cells + 1 entries

  [[nodiscard]] std::size_t n_cells() const { return begin.size() - 1; }
};

/// Blocks of successive cells, numbered as they are occupied. Every block owns a range of nodes that no cell of an
/// earlier block touches: sums at them are over the block's own cells first and then over cells of later blocks, those
/// that reach down into it, in the order of the cells.
class CellBlocks {
public:
  /// `first_cell`: of every block, and the number of cells.
  CellBlocks(std::vector<int> first_cell, const CellNodes& cells, int n_nodes);

  [[nodiscard]] int count() const { return static_cast<int>(first_cell_.size()) - 1; }
  [[nodiscard]] int first_cell(int block) const { return first_cell_[static_cast<std::size_t>(block)]; }
  [[nodiscard]] bool owns(int block, int node) const {
    const auto b = static_cast<std::size_t>(block);
    return node >= first_node_[b] && node < first_node_[b + 1];
  }

  /// Where what a cell contributes is kept for the blocks that it reaches down into, 0 ... n_kept() - 1; -1: nowhere.
  [[nodiscard]] int kept(int cell) const { return kept_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] int n_kept() const { return n_kept_; }
  /// Cells of later blocks that touch nodes of this one.
  [[nodiscard]] const std::vector<int>& reaching(int block) const { return reaching_[static_cast<std::size_t>(block)]; }

private:
  std::vector<int> first_cell_, first_node_;
  std::vector<int> kept_;
  int n_kept_ = 0;
  std::vector<std::vector<int>> reaching_; ///< by block

  void divide_nodes(const CellNodes& cells, int n_nodes);
  void find_reaching(const CellNodes& cells);
};

} // namespace settle::mpm
