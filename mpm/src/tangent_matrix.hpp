/// \file
/// A sparse matrix that is summed up cell by cell, over and over with the same entries.
#pragma once

#include <vector>

#include <Eigen/SparseCore>

namespace settle::mpm {

/// Equations of the degrees of freedom of cells, one cell after the other.
struct CellEquations {
  std::vector<int> rows;          ///< of every cell's degrees of freedom; -1 where a support holds
  std::vector<std::size_t> begin; ///< of a cell's rows; n_cells + 1 entries
  int size = 0;                   ///< of the matrix

  bool operator==(const CellEquations&) const = default;
};

/// Keeps where each cell's entries go, so that summing up needs no sorting.
class TangentMatrix {
public:
  /// All entries zero; true if their places have changed.
  bool set_pattern(CellEquations equations);
  void set_zero();

  /// Adds columns `first_column` ... `last_column` - 1 of the upper left part of a dense matrix, as large as the cell
  /// has degrees of freedom, to the entries of the cell, the `number`-th.
  template <class Dense>
  void add(std::size_t number, const Dense& dense, int first_column, int last_column) {
    const auto n = static_cast<int>(equations_.begin[number + 1] - equations_.begin[number]);
    std::size_t place = first_place_[number] + static_cast<std::size_t>(n * first_column);
    for (int j = first_column; j < last_column; ++j)
      for (int i = 0; i < n; ++i)
        if (const int at = places_[place++]; at >= 0) matrix_.valuePtr()[at] += dense(i, j);
  }

  [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }
  [[nodiscard]] int size() const { return equations_.size; }

private:
  CellEquations equations_;
  std::vector<std::size_t> first_place_; ///< of each cell in `places_`
  std::vector<int> places_;              ///< of every cell's entries, column by column, among the values; -1: none
  Eigen::SparseMatrix<double> matrix_;

  void find_places();
};

} // namespace settle::mpm
