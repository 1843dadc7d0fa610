/// \file
/// The linear systems of the quasi-static scheme.
#pragma once

#include <memory>

#include <Eigen/SparseCore>

#include "settle/exchange/case.hpp"

namespace settle::mpm {

/// Solves systems whose matrices change little from one to the next and are nearly symmetric: a factorisation of an
/// earlier one's symmetric part is kept as the preconditioner of BiCGSTAB (van der Vorst 1992) on the matrix itself.
///
/// - `direct`: the factorisation is complete, sparse L D L^T (Eigen). Where it is of no use, because the matrix is far
///   from symmetric or singular in part, sparse LU with pivoting takes its place.
/// - `iterative`: it is an incomplete L L^T (Lin & More 1999, Eigen), as sparse as the matrix.
///
/// It is made anew once the matrix has other entries, or a few more iterations were needed than when it
/// was new.
class TangentSolver {
public:
  using Matrix = Eigen::SparseMatrix<double>;

  explicit TangentSolver(exchange::MpmLinearSolver kind);
  TangentSolver(TangentSolver&&) noexcept;
  ~TangentSolver();

  /// To be told when the matrices to come have entries in other places.
  void forget();

  /// |matrix * solution - right_side| <= tolerance * |right_side|, Euclidean; false if that cannot be had.
  bool solve(const Matrix& matrix, const Eigen::VectorXd& right_side, double tolerance, Eigen::VectorXd& solution);

  [[nodiscard]] int factorisations() const { return factorisations_; } ///< made so far

  class Factor;

private:
  std::unique_ptr<Factor> factor_;
  bool complete_;
  bool usable_ = false; ///< the factor belongs to a matrix like those to come
  int iterations_when_new_ = 0;
  int factorisations_ = 0;

  bool make_factor(const Matrix& matrix);
};

} // namespace settle::mpm
