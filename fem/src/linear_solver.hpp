/// \file
/// Solvers for the linear equations of a Newton step.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

namespace settle::fem {

class LinearSolver {
public:
  LinearSolver() = default;
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;
  virtual ~LinearSolver() = default;

  /// Prepares for this matrix [N/m], which has to stay as it is until the next one.
  virtual void prepare(const dealii::SparseMatrix<double>& matrix) = 0;
  /// The displacement [m] that leaves of these forces no more than `tolerance`, in the l2 norm [N]; a direct solver
  /// leaves round-off, whatever is asked. Nothing where it does not come there: the matrix is singular, the iterations
  /// allowed or the memory do not suffice.
  [[nodiscard]] virtual std::optional<dealii::Vector<double>> solve(const dealii::Vector<double>& forces,
                                                                    double tolerance) = 0;
};

/// Sparse LU factors (UMFPACK).
std::unique_ptr<LinearSolver> make_direct_solver();

/// What a multigrid method has to know of the equations.
struct MultigridProblem {
  /// Of each rigid motion the values at all degrees of freedom, those that are held zero. The components of a node are
  /// neighbours among the degrees of freedom, in the order of the axes.
  std::vector<std::vector<double>> rigid_motions;
  unsigned dimension; ///< components of a node
  bool symmetric;     ///< the matrix: conjugate gradients; else GMRES
};

/// A Krylov method with algebraic multigrid by smoothed aggregation as its preconditioner (Trilinos ML). What is
/// prepared for a matrix serves those that follow, as long as it still does.
std::unique_ptr<LinearSolver> make_multigrid_solver(MultigridProblem problem);

} // namespace settle::fem
