// The linear systems of the quasi-static scheme: summing up with kept places, solving with a kept factorisation.

#include <random>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "tangent_matrix.hpp"
#include "tangent_solver.hpp"

namespace settle::mpm::test {
namespace {

using Matrix = TangentSolver::Matrix;
using exchange::MpmLinearSolver;

constexpr double tolerance = 1e-10;

/// A chain of n springs, and an antisymmetric part with this share of their stiffness.
Matrix chain(int n, double stiffness, double antisymmetric) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 2.0 * stiffness);
    if (i == 0) continue;
    entries.emplace_back(i, i - 1, stiffness * (-1.0 + antisymmetric));
    entries.emplace_back(i - 1, i, stiffness * (-1.0 - antisymmetric));
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double residual(const Matrix& matrix, const Eigen::VectorXd& right_side, const Eigen::VectorXd& solution) {
  return (matrix * solution - right_side).norm() / right_side.norm();
}

class EveryTangentSolver : public testing::TestWithParam<MpmLinearSolver> {};
INSTANTIATE_TEST_SUITE_P(Kinds, EveryTangentSolver,
                         testing::Values(MpmLinearSolver::direct, MpmLinearSolver::iterative),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

TEST_P(EveryTangentSolver, SolvesAnUnsymmetricSystemToItsTolerance) {
  const Matrix matrix = chain(200, 3e5, 0.05);
  const Eigen::VectorXd right_side = Eigen::VectorXd::LinSpaced(200, -1.0, 2.0);
  Eigen::VectorXd solution;
  ASSERT_TRUE(TangentSolver(GetParam()).solve(matrix, right_side, tolerance, solution));
  EXPECT_LE(residual(matrix, right_side, solution), 2.0 * tolerance);
  const Eigen::VectorXd dense = Eigen::MatrixXd(matrix).partialPivLu().solve(right_side);
  EXPECT_LT((solution - dense).norm() / dense.norm(), 1e-5); // tolerance times the condition, (2 n / pi)^2
}

TEST_P(EveryTangentSolver, KeepsTheFactorisationWhileTheMatrixChangesLittle) {
  TangentSolver solver(GetParam());
  const Eigen::VectorXd right_side = Eigen::VectorXd::Ones(50);
  Eigen::VectorXd solution;
  for (const double stiffness : {1.0, 1.02, 0.97}) {
    const Matrix matrix = chain(50, stiffness, 0.02);
    ASSERT_TRUE(solver.solve(matrix, right_side, tolerance, solution));
    EXPECT_LE(residual(matrix, right_side, solution), 2.0 * tolerance);
  }
  EXPECT_EQ(solver.factorisations(), 1);
}

/// The chain with next to nothing between every other spring: entries in other places, a matrix hardly another.
Matrix chain_with_more_entries(int n) {
  Matrix matrix = chain(n, 1.0, 0.02);
  for (int i = 2; i < n; ++i)
    matrix.coeffRef(i, i - 2) = matrix.coeffRef(i - 2, i) = -1e-6;
  return matrix;
}

TEST_P(EveryTangentSolver, MakesTheFactorisationAnewForAMatrixWithOtherEntries) {
  TangentSolver solver(GetParam());
  const Eigen::VectorXd right_side = Eigen::VectorXd::Ones(50);
  Eigen::VectorXd solution;
  for (const Matrix& matrix : {chain(50, 1.0, 0.02), chain_with_more_entries(50)}) {
    solver.forget();
    ASSERT_TRUE(solver.solve(matrix, right_side, tolerance, solution));
    EXPECT_LE(residual(matrix, right_side, solution), 2.0 * tolerance);
  }
  EXPECT_EQ(solver.factorisations(), 2);
}

TEST_P(EveryTangentSolver, SaysThatASingularSystemHasNoSolution) {
  Matrix matrix = chain(10, 1.0, 0.0);
  for (int i = 0; i < 10; ++i)
    matrix.coeffRef(i, i) = i == 0 || i == 9 ? 1.0 : 2.0; // a chain that is held nowhere
  Eigen::VectorXd solution;
  EXPECT_FALSE(TangentSolver(GetParam()).solve(matrix, Eigen::VectorXd::Ones(10), tolerance, solution));
}

/// Every spring of the chain gets a stiffness of its own, up to this share apart: the chain is no good preconditioner.
Matrix uneven_chain(double share) {
  Eigen::VectorXd scale(60);
  for (int i = 0; i < 60; ++i)
    scale[i] = 1.0 + share / 6.0 * (i % 7);
  return (scale.asDiagonal() * chain(60, 1.0, 0.0) * scale.asDiagonal()).eval();
}

/// How many factorisations there were after the chain, and after each of three solves with the uneven one.
std::vector<int> factorisations_with(const Matrix& uneven) {
  const Eigen::VectorXd right_side = Eigen::VectorXd::Ones(60);
  TangentSolver solver(MpmLinearSolver::direct);
  Eigen::VectorXd solution;
  std::vector<int> counts;
  for (const Matrix& matrix : {chain(60, 1.0, 0.0), uneven, uneven, uneven}) {
    EXPECT_TRUE(solver.solve(matrix, right_side, tolerance, solution));
    EXPECT_LE(residual(matrix, right_side, solution), 2.0 * tolerance);
    counts.push_back(static_cast<int>(solver.factorisations()));
  }
  return counts;
}

TEST(TangentSolver, AFactorisationThatHasBecomeABadOneIsMadeAnewForTheNextSystem) {
  EXPECT_EQ(factorisations_with(uneven_chain(0.2)), (std::vector<int>{1, 1, 2, 2}));
}

TEST(TangentSolver, AFactorisationThatIsOfNoUseIsMadeAnewAtOnce) {
  EXPECT_EQ(factorisations_with(uneven_chain(1.2)), (std::vector<int>{1, 2, 2, 2}));
}

TEST(TangentSolver, DirectSolvesAlsoWhatIsFarFromSymmetric) {
  Matrix matrix = chain(40, 1.0, 30.0); // almost a rotation
  Eigen::VectorXd solution;
  ASSERT_TRUE(TangentSolver(MpmLinearSolver::direct).solve(matrix, Eigen::VectorXd::Ones(40), tolerance, solution));
  EXPECT_LE(residual(matrix, Eigen::VectorXd::Ones(40), solution), 2.0 * tolerance);
}

/// Two cells of two degrees of freedom each that share the middle one of three; the first of all is held.
CellEquations two_cells() {
  return {.rows = {-1, 0, 0, 1}, .begin = {0, 2, 4}, .size = 2};
}

TEST(TangentMatrix, SumsUpTheCellsEntriesOfFreeDegreesOfFreedom) {
  TangentMatrix tangent;
  EXPECT_TRUE(tangent.set_pattern(two_cells()));
  Eigen::Matrix3d first, second; // larger than a cell: only the upper left part counts
  first << 1, 2, 99, 3, 4, 99, 99, 99, 99;
  second << 10, 20, 99, 30, 40, 99, 99, 99, 99;
  tangent.add(0, first, 0, 1); // column by column
  tangent.add(0, first, 1, 2);
  tangent.add(1, second, 0, 2);
  const Eigen::Matrix2d sum{{4 + 10, 20}, {30, 40}};
  EXPECT_EQ(Eigen::Matrix2d(tangent.matrix()), sum);
}

TEST(TangentMatrix, StartsFromZeroAgainAndSaysWhenItsEntriesHaveMoved) {
  TangentMatrix tangent;
  tangent.set_pattern(two_cells());
  tangent.add(1, Eigen::Matrix2d::Ones(), 0, 2);
  EXPECT_FALSE(tangent.set_pattern(two_cells()));
  EXPECT_EQ(tangent.matrix().norm(), 0.0);
  EXPECT_TRUE(tangent.set_pattern({.rows = {0, 1, 1, 2}, .begin = {0, 2, 4}, .size = 3}));
  EXPECT_EQ(tangent.matrix().rows(), 3);
}

} // namespace
} // namespace settle::mpm::test
