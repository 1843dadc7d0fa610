#include "tangent_solver.hpp"

#include <cmath>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace settle::mpm {

using Matrix = TangentSolver::Matrix;

/// What a symmetric matrix is factorised into.
class TangentSolver::Factor {
public:
  Factor() = default;
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  virtual ~Factor() = default;

  /// False if the matrix has no such factorisation.
  virtual bool make(const Matrix& symmetric) = 0;
  [[nodiscard]] virtual Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const = 0;
  /// The next matrix has entries in other places.
  virtual void forget() {}
};

namespace {

/// Once a kept factorisation takes so many iterations more than it did when it was new, the next system gets its own:
/// about what that costs.
constexpr int iterations_worth_a_factorisation = 6;

class CompleteFactor : public TangentSolver::Factor {
public:
  bool make(const Matrix& symmetric) override {
    if (!analysed_) factor_.analyzePattern(symmetric);
    analysed_ = true;
    factor_.factorize(symmetric);
    return factor_.info() == Eigen::Success;
  }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const override {
    return factor_.solve(right_side);
  }
  void forget() override { analysed_ = false; }

private:
  Eigen::SimplicialLDLT<Matrix> factor_;
  bool analysed_ = false;
};

class IncompleteFactor : public TangentSolver::Factor {
public:
  bool make(const Matrix& symmetric) override {
    factor_.compute(symmetric);
    return factor_.info() == Eigen::Success;
  }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const override {
    return factor_.solve(right_side);
  }

private:
  Eigen::IncompleteCholesky<double> factor_;
};

/// A factor as Eigen's iterative solvers want a preconditioner: made beforehand, not from their matrix.
class Kept {
public:
  template <class Any>
  Kept& analyzePattern(const Any&) {
    return *this;
  }
  template <class Any>
  Kept& factorize(const Any&) {
    return *this;
  }
  template <class Any>
  Kept& compute(const Any&) {
    return *this;
  }
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const { return factor->solve(right_side); }
  [[nodiscard]] static Eigen::ComputationInfo info() { return Eigen::Success; }

  const TangentSolver::Factor* factor = nullptr;
};

struct Outcome {
  bool solved = false;
  int iterations = 0;
};

Outcome iterate(const Matrix& matrix, const Eigen::VectorXd& right_side, double tolerance, int most,
                const TangentSolver::Factor& factor, Eigen::VectorXd& solution) {
  Eigen::BiCGSTAB<Matrix, Kept> solver;
  solver.preconditioner().factor = &factor;
  solver.setTolerance(tolerance);
  solver.setMaxIterations(most);
  solver.compute(matrix);
  solution = solver.solve(right_side);
  const bool solved = solution.allFinite() &&
                      (matrix * solution - right_side).norm() <= 2.0 * tolerance * right_side.norm(); // not as updated
  return {solved, static_cast<int>(solver.iterations())};
}

bool solve_by_lu(const Matrix& matrix, const Eigen::VectorXd& right_side, Eigen::VectorXd& solution) {
  Eigen::SparseLU<Matrix> solver;
  solver.compute(matrix);
  if (solver.info() != Eigen::Success) return false;
  solution = solver.solve(right_side);
  return solution.allFinite();
}

std::unique_ptr<TangentSolver::Factor> factor_for(exchange::MpmLinearSolver kind) {
  switch (kind) {
  case exchange::MpmLinearSolver::direct:
    break;
  case exchange::MpmLinearSolver::iterative:
    return std::make_unique<IncompleteFactor>();
  }
  return std::make_unique<CompleteFactor>();
}

} // namespace

TangentSolver::TangentSolver(exchange::MpmLinearSolver kind)
    : factor_(factor_for(kind)), complete_(kind == exchange::MpmLinearSolver::direct) {}
TangentSolver::TangentSolver(TangentSolver&&) noexcept = default;
TangentSolver::~TangentSolver() = default;

void TangentSolver::forget() {
  factor_->forget();
  usable_ = false;
}

bool TangentSolver::make_factor(const Matrix& matrix) {
  const Matrix transposed = matrix.transpose();
  ++factorisations_;
  return factor_->make(0.5 * (matrix + transposed));
}

bool TangentSolver::solve(const Matrix& matrix, const Eigen::VectorXd& right_side, double tolerance,
                          Eigen::VectorXd& solution) {
  const int root = static_cast<int>(std::sqrt(matrix.rows()));
  const int most = complete_ ? 4 * iterations_worth_a_factorisation : 100 + 10 * root;
  if (usable_) {
    const Outcome kept = iterate(matrix, right_side, tolerance, most, *factor_, solution);
    usable_ = kept.solved && kept.iterations <= iterations_when_new_ + iterations_worth_a_factorisation;
    if (kept.solved) return true;
  }
  if (make_factor(matrix)) {
    const Outcome fresh = iterate(matrix, right_side, tolerance, most, *factor_, solution);
    usable_ = fresh.solved;
    iterations_when_new_ = fresh.iterations;
    if (fresh.solved) return true;
  }
  return complete_ && solve_by_lu(matrix, right_side, solution);
}

} // namespace settle::mpm
