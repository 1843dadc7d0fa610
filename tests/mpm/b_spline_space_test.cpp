// Quadratic B-splines: sums, linear fields, derivatives, sides of the grid, and what the stable step rests on.

#include <cmath>
#include <random>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "settle/mpm/product_space.hpp"

namespace settle::mpm::test {
namespace {

const BSplineSpace<2> space({.counts = {4, 6}, .size = 0.3, .origin = {-0.4, 0.7}});

Vector<2> random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  return space.origin() + Vector<2>(unit(random) * space.width(), unit(random) * space.height());
}

BSplineSpace<2>::Stencil at(const BSplineSpace<2>& grid, const Vector<2>& x) {
  return grid.stencil_at(grid.locate(x), x);
}

/// The value of a node's function at x.
double value_of(int node, const Vector<2>& x) {
  const auto stencil = at(space, x);
  for (int i = 0; i < stencil.size(); ++i)
    if (stencil.node(i) == node) return stencil.value(i);
  return 0.0;
}

TEST(BSplineSpace, FunctionsAreNotNegativeSumToOneAndReproduceLinearFields) {
  std::mt19937 random(1);
  const Vector<2> slope(-2.0, 5.0);
  for (int k = 0; k < 1000; ++k) {
    const auto x = random_point(random);
    const auto stencil = at(space, x);
    double sum = 0;
    Vector<2> position = Vector<2>::Zero(), gradient_sum = Vector<2>::Zero(), gradient = Vector<2>::Zero();
    for (int i = 0; i < stencil.size(); ++i) {
      EXPECT_GE(stencil.value(i), 0.0);
      sum += stencil.value(i);
      position += stencil.value(i) * space.node_position(stencil.node(i));
      gradient_sum += stencil.gradients.col(i);
      gradient += slope.dot(space.node_position(stencil.node(i))) * stencil.gradients.col(i);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_LT((position - x).norm(), 1e-14);
    EXPECT_LT(gradient_sum.norm(), 1e-12);
    EXPECT_LT((gradient - slope).norm(), 1e-12);
  }
}

TEST(BSplineSpace, GradientsAreTheDerivativesOfTheFunctionsAlsoAcrossCells) {
  std::mt19937 random(2);
  const double step = 1e-6;
  for (int k = 0; k < 300; ++k) {
    const Vector<2> x = space.origin() + 0.01 * Vector<2>::Ones() + 0.95 * (random_point(random) - space.origin());
    const auto stencil = at(space, x);
    for (int i = 0; i < stencil.size(); ++i)
      for (int d = 0; d < 2; ++d) {
        const Vector<2> shift = step * Vector<2>::Unit(d);
        const double difference = value_of(stencil.node(i), x + shift) - value_of(stencil.node(i), x - shift);
        EXPECT_NEAR(stencil.gradients(d, i), difference / (2.0 * step), 1e-4); // second derivatives jump: 1e-5/m
      }
  }
}

TEST(BSplineSpace, GradientsAreContinuousWhereCellsMeet) {
  for (int column = 1; column < space.columns(); ++column) {
    const Vector<2> x = space.corner(column, 2) + Vector<2>(0.0, 0.1);
    const int left = column - 1 + 2 * space.columns();
    const auto before = space.stencil_at(left, x), after = space.stencil_at(left + 1, x);
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j)
        if (before.node(i) == after.node(j)) {
          EXPECT_LT((before.gradients.col(i) - after.gradients.col(j)).norm(), 1e-13);
        }
  }
}

TEST(BSplineSpace, OnASideOfTheGridOnlyTheNodesOnThatSideCount) {
  for (double y = 0.05; y < 1.8; y += 0.1) {
    const Vector<2> on_left = space.origin() + Vector<2>(0.0, y);
    const Vector<2> on_right = space.origin() + Vector<2>(space.width() * (1 - 1e-15), y);
    for (const auto& [x, column] : {std::pair{on_left, 0}, std::pair{on_right, space.node_columns() - 1}}) {
      const auto stencil = at(space, x);
      for (int i = 0; i < stencil.size(); ++i)
        if (stencil.node(i) % space.node_columns() != column) {
          EXPECT_NEAR(stencil.value(i), 0.0, 1e-14);
        }
    }
  }
}

TEST(BSplineSpace, TheAverageOfACellIsThatOfItsFunctions) {
  const double gauss = 0.5 / std::sqrt(3.0); // two points a direction: exact for cubics
  for (int cell = 0; cell < space.n_cells(); ++cell) {
    const auto average = space.cell_average(cell);
    std::array<double, 9> values{};
    BSplineSpace<2>::Stencil::Gradients gradients = BSplineSpace<2>::Stencil::Gradients::Zero();
    for (const double sx : {-gauss, gauss})
      for (const double sy : {-gauss, gauss}) {
        const Vector<2> middle = space.corner(space.column_of(cell), space.row_of(cell)) + Vector<2>(0.15, 0.15);
        const auto stencil = space.stencil_at(cell, middle + 0.3 * Vector<2>(sx, sy));
        gradients += 0.25 * stencil.gradients;
        for (std::size_t i = 0; i < 9; ++i)
          values[i] += 0.25 * stencil.values[i];
      }
    EXPECT_LT((gradients - average.gradients).norm(), 1e-13);
    for (std::size_t i = 0; i < 9; ++i)
      EXPECT_NEAR(values[i], average.values[i], 1e-14);
  }
}

/// The highest frequency, times h / c, of a line of n squares that vibrates along itself: points on a lattice of
/// `per_side` a square, mass lumped, ends free.
double highest_frequency(int n, int per_side) {
  const BSplineSpace<2> line({.counts = {n, 1}, .size = 1.0});
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n + 2, n + 2);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(n + 2);
  for (int p = 0; p < n * per_side; ++p) {
    const auto stencil = at(line, {(p + 0.5) / per_side, 0.0}); // on the lower side: three functions
    for (int i = 0; i < 3; ++i) {
      mass[stencil.node(i)] += stencil.value(i) / per_side;
      for (int j = 0; j < 3; ++j)
        stiffness(stencil.node(i), stencil.node(j)) += stencil.gradients(0, i) * stencil.gradients(0, j) / per_side;
    }
  }
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff());
}

TEST(BSplineSpace, NoLineOfSquaresVibratesFasterThanTheStableStepAllows) {
  const BSplineSpace<2> unit({.counts = {1, 1}, .size = 1.0});
  const double allowed = 2.0 / unit.shortest_length(); // a frequency omega is stable up to a step of 2/omega
  double highest = 0;
  for (int n = 1; n <= 12; ++n)
    for (const int per_side : {2, 3, 4})
      highest = std::max(highest, highest_frequency(n, per_side));
  EXPECT_LE(highest, 1.04 * allowed); // one square of two points across, both ends free: sqrt(6.4)
  EXPECT_GE(highest, 0.95 * allowed);
  EXPECT_NEAR(highest_frequency(1, 60), allowed, 1e-3);
}

} // namespace
} // namespace settle::mpm::test
