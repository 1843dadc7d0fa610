/// \file
/// The linear system of a quasi-static increment, summed up cell by cell.
#pragma once

#include <optional>

#include "cell_blocks.hpp"
#include "cell_contribution.hpp"
#include "crew.hpp"
#include "settle/mpm/quasi_static_step.hpp"
#include "tangent_matrix.hpp"
#include "tangent_solver.hpp"

namespace settle::mpm {

/// Kept between increments for its pattern, its factorisation and its threads. Every sum is in the order of the cells,
/// whatever the number of threads.
template <class Space>
class QuasiStaticSystem {
public:
  QuasiStaticSystem(exchange::MpmLinearSolver kind, Threads threads) : threads_(threads), solver_(kind) {}

  /// Numbers what is free of the nodes that points touch; to be called when points have moved or were added.
  void renumber(const Body<Space>& body);

  /// Internal forces at `displacement` (dim * nodes) [m], and the tangent; false if a point turns inside out.
  bool assemble(const Body<Space>& body, const Eigen::VectorXd& displacement, Eigen::VectorXd& internal);
  /// As TangentSolver::solve; `residual` and `step` are of the free degrees of freedom.
  bool solve(const Eigen::VectorXd& residual, double tolerance, Eigen::VectorXd& step) {
    return solver_.solve(tangent_.matrix(), residual, tolerance, step);
  }
  /// Moves all points, and deforms them; they are not sorted.
  void move_points(Body<Space>& body, const Eigen::VectorXd& displacement);

  /// The entries of a full nodal vector at the free degrees of freedom.
  [[nodiscard]] Eigen::VectorXd free_part(const Eigen::VectorXd& full) const;
  void add_to_free(const Eigen::VectorXd& step, Eigen::VectorXd& full) const;

private:
  static constexpr int dim = Space::dim;
  using Contribution = CellContribution<Space>;

  Threads threads_;
  Crew crew_;
  Shares shares_; ///< of the blocks
  CellNodes cells_;
  std::optional<CellBlocks> blocks_;
  std::vector<Contribution> kept_, scratch_; ///< by CellBlocks::kept, by thread
  std::vector<int> equation_;                ///< dim * node + direction -> row; -1 where nothing is free
  TangentMatrix tangent_;
  TangentSolver solver_;

  void divide(const Body<Space>& body);
  [[nodiscard]] CellEquations number_unknowns(const Body<Space>& body);
  bool add_own_cells(const Body<Space>& body, const Eigen::VectorXd& displacement, int block, Contribution& scratch,
                     Eigen::VectorXd& internal);
  void add(int block, int cell, const Contribution& sum, Eigen::VectorXd& internal);
};

} // namespace settle::mpm
