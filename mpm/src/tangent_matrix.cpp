#include "tangent_matrix.hpp"

#include <algorithm>

namespace settle::mpm {

namespace {

/// Calls `action(row, column)` for every entry of a cell, column by column; held degrees of freedom are -1.
template <class Action>
void for_each_entry(const CellEquations& equations, std::size_t cell, Action&& action) {
  for (std::size_t j = equations.begin[cell]; j < equations.begin[cell + 1]; ++j)
    for (std::size_t i = equations.begin[cell]; i < equations.begin[cell + 1]; ++i)
      action(equations.rows[i], equations.rows[j]);
}

Eigen::SparseMatrix<double> zeros(const CellEquations& equations) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t cell = 0; cell + 1 < equations.begin.size(); ++cell)
    for_each_entry(equations, cell, [&](int row, int column) {
      if (row >= 0 && column >= 0) entries.emplace_back(row, column, 0.0);
    });
  Eigen::SparseMatrix<double> matrix(equations.size, equations.size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Where an entry is among the values.
int place_of(const Eigen::SparseMatrix<double>& matrix, int row, int column) {
  const int* rows = matrix.innerIndexPtr();
  const int* outer = matrix.outerIndexPtr();
  return static_cast<int>(std::lower_bound(rows + outer[column], rows + outer[column + 1], row) - rows);
}

} // namespace

bool TangentMatrix::set_pattern(CellEquations equations) {
  const bool changed = !(equations == equations_);
  if (changed) {
    equations_ = std::move(equations);
    matrix_ = zeros(equations_);
    find_places();
  }
  set_zero();
  return changed;
}

void TangentMatrix::set_zero() {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
}

void TangentMatrix::find_places() {
  first_place_.clear();
  places_.clear();
  for (std::size_t cell = 0; cell + 1 < equations_.begin.size(); ++cell) {
    first_place_.push_back(places_.size());
    for_each_entry(equations_, cell, [&](int row, int column) {
      places_.push_back(row >= 0 && column >= 0 ? place_of(matrix_, row, column) : -1);
    });
  }
}

} // namespace settle::mpm
