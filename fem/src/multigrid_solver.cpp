#include <algorithm>
#include <cstdlib>

#include <Teuchos_ParameterList.hpp>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <ml_utils.h>

#include "linear_solver.hpp"

namespace settle::fem {
namespace {

using Vector = dealii::Vector<double>;

/// Trilinos lives on MPI, here with one process. Started when first needed, because that takes a while, and without the
/// daemon that Open MPI keeps for processes to come.
void start_mpi() {
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  static int no_arguments = 0;
  static char** no_values = nullptr;
  static const dealii::Utilities::MPI::MPI_InitFinalize running(no_arguments, no_values,
                                                                dealii::MultithreadInfo::n_threads());
}

class MultigridSolver final : public LinearSolver {
public:
  explicit MultigridSolver(MultigridProblem problem) : problem_(std::move(problem)) {}

  void prepare(const dealii::SparseMatrix<double>& matrix) override {
    matrix_ = &matrix;
    if (fresh_iterations_ == 0 || last_iterations_ > more_allowed * fresh_iterations_) rebuild();
  }

  std::optional<Vector> solve(const Vector& forces, double tolerance) override {
    std::optional<Vector> displacement = iterate(forces, tolerance);
    if (displacement || fresh_iterations_ == 0) return displacement;
    rebuild();
    return iterate(forces, tolerance);
  }

private:
  static constexpr unsigned iterations_allowed = 500;
  /// What was built for an earlier matrix is built anew when it needs this many times the iterations it needed at
  /// first.
  static constexpr unsigned more_allowed = 2;
  static constexpr unsigned basis_of_gmres = 60; ///< vectors, before it starts again

  void rebuild() {
    ML_set_random_seed(1); // eigenvalues are estimated from a random vector: the same one every time
    preconditioner_.clear();
    copy_.clear();
    copy_.reinit(*matrix_, 0.0);
    preconditioner_.initialize(copy_, parameters());
    fresh_iterations_ = last_iterations_ = 0;
  }

  std::optional<Vector> iterate(const Vector& forces, double tolerance) {
    dealii::SolverControl control(iterations_allowed, tolerance, false, false);
    Vector displacement(forces.size());
    try {
      if (problem_.symmetric)
        dealii::SolverCG<Vector>(control).solve(*matrix_, displacement, forces, preconditioner_);
      else
        dealii::SolverGMRES<Vector>(control, dealii::SolverGMRES<Vector>::AdditionalData(basis_of_gmres + 2, true))
            .solve(*matrix_, displacement, forces, preconditioner_);
    } catch (const dealii::SolverControl::NoConvergence&) {
      return {};
    }
    last_iterations_ = control.last_step();
    if (fresh_iterations_ == 0) fresh_iterations_ = std::max(1U, last_iterations_);
    return displacement;
  }

  /// Smoothed aggregation of nodes (Vanek, Mandel & Brezina 1996), rigid motions kept on every level.
  [[nodiscard]] Teuchos::ParameterList parameters() {
    null_space_.clear();
    for (const std::vector<double>& motion : problem_.rigid_motions)
      null_space_.insert(null_space_.end(), motion.begin(), motion.end());
    Teuchos::ParameterList list;
    list.set("default values", "SA");
    list.set("ML output", 0);
    list.set("PDE equations", static_cast<int>(problem_.dimension));
    list.set("null space: type", "pre-computed");
    list.set("null space: dimension", static_cast<int>(problem_.rigid_motions.size()));
    list.set("null space: vectors", null_space_.data());
    list.set("null space: add default vectors", false);
    list.set("aggregation: type", "Uncoupled");
    list.set("aggregation: threshold", 0.0);
    list.set("smoother: type", "Chebyshev");
    list.set("smoother: sweeps", 2);
    list.set("smoother: Chebyshev alpha", 20.0);
    list.set("smoother: pre or post", "both");
    list.set("coarse: type", "Amesos-KLU");
    list.set("coarse: max size", 1000);
    return list;
  }

  MultigridProblem problem_;
  const dealii::SparseMatrix<double>* matrix_ = nullptr;
  std::vector<double> null_space_;              ///< (motions, dofs), as long as the preconditioner lives
  dealii::TrilinosWrappers::SparseMatrix copy_; ///< of the matrix for which the preconditioner was built
  dealii::TrilinosWrappers::PreconditionAMG preconditioner_;
  unsigned fresh_iterations_ = 0; ///< of the first solve with the preconditioner as it is
  unsigned last_iterations_ = 0;
};

} // namespace

std::unique_ptr<LinearSolver> make_multigrid_solver(MultigridProblem problem) {
  start_mpi(); // before any object of Trilinos
  return std::make_unique<MultigridSolver>(std::move(problem));
}

} // namespace settle::fem
