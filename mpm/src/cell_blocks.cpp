#include "cell_blocks.hpp"

#include <algorithm>

namespace settle::mpm {

CellBlocks::CellBlocks(std::vector<int> first_cell, const CellNodes& cells, int n_nodes)
    : first_cell_(std::move(first_cell)), kept_(cells.n_cells(), -1), reaching_(first_cell_.size() - 1) {
  divide_nodes(cells, n_nodes);
  if (count() > 1) find_reaching(cells);
}

/// A block owns what it and the earlier ones touch and what none of the earlier ones does.
void CellBlocks::divide_nodes(const CellNodes& cells, int n_nodes) {
  first_node_.assign(1, 0);
  for (int block = 0; block + 1 < count(); ++block) {
    const auto node = [&](int cell) {
      return cells.nodes.begin() + static_cast<std::ptrdiff_t>(cells.begin[static_cast<std::size_t>(cell)]);
    };
    const auto first = node(first_cell(block)), last = node(first_cell(block + 1));
    const int beyond = first == last ? 0 : *std::max_element(first, last) + 1;
    first_node_.push_back(std::max(first_node_.back(), beyond));
  }
  first_node_.push_back(n_nodes);
}

void CellBlocks::find_reaching(const CellNodes& cells) {
  for (int block = 1; block < count(); ++block)
    for (int cell = first_cell(block); cell < first_cell(block + 1); ++cell) {
      const auto c = static_cast<std::size_t>(cell);
      for (std::size_t i = cells.begin[c]; i < cells.begin[c + 1]; ++i) {
        if (cells.nodes[i] >= first_node_[static_cast<std::size_t>(block)]) continue;
        const auto above = std::upper_bound(first_node_.begin(), first_node_.end(), cells.nodes[i]);
        auto& reaching = reaching_[static_cast<std::size_t>(above - first_node_.begin()) - 1];
        if (reaching.empty() || reaching.back() != cell) reaching.push_back(cell);
        if (kept_[c] < 0) kept_[c] = n_kept_++;
      }
    }
}

} // namespace settle::mpm
