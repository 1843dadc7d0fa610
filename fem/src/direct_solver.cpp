#include <deal.II/lac/sparse_direct.h>

#include "linear_solver.hpp"

namespace settle::fem {
namespace {

class DirectSolver final : public LinearSolver {
public:
  void prepare(const dealii::SparseMatrix<double>& matrix) override {
    factorized_ = false;
    try {
      factors_.initialize(matrix);
      factorized_ = true;
    } catch (const dealii::SparseDirectUMFPACK::ExcUMFPACKError&) {
    } // `solve` says so
  }

  std::optional<dealii::Vector<double>> solve(const dealii::Vector<double>& forces, double /*tolerance*/) override {
    if (!factorized_) return {};
    dealii::Vector<double> displacement = forces;
    factors_.solve(displacement);
    return displacement;
  }

private:
  dealii::SparseDirectUMFPACK factors_;
  bool factorized_ = false;
};

} // namespace

std::unique_ptr<LinearSolver> make_direct_solver() {
  return std::make_unique<DirectSolver>();
}

} // namespace settle::fem
