#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "finite_column.hpp"

namespace settle::fem::testing {
namespace {

using exchange::FemLinearSolver;

/// A body in space that is not a column: wide, of several cells along each axis.
exchange::Case block(exchange::FemElement element, double element_size) {
  return column({.layers = 2,
                 .dimension = 3,
                 .element = element,
                 .element_size = element_size,
                 .width = 1.0,
                 .height = 1.0,
                 .probes_per_layer = 3});
}

std::vector<exchange::Stage> solve_with(FemLinearSolver solver, exchange::Case study) {
  study.fem.linear_solver = solver;
  return solve(study);
}

/// Both leave 1e-12 of the load or, where round-off of the finest meshes is more, 1e-9; a displacement errs by more
/// than its forces do, by what a base carries against one cell.
void expect_same(const std::vector<exchange::Stage>& found, const std::vector<exchange::Stage>& expected,
                 double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto largest = [](const std::vector<double>& values) {
      return std::abs(*std::max_element(values.begin(), values.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); }));
    };
    const exchange::SamplePoints &points = found[k].points, &same = expected[k].points;
    ASSERT_EQ(points.size(), same.size());
    for (std::size_t i = 0; i < points.displacement.size(); ++i)
      ASSERT_NEAR(points.displacement[i], same.displacement[i], tolerance * largest(same.displacement)) << i;
    for (std::size_t i = 0; i < points.stress.size(); ++i)
      ASSERT_NEAR(points.stress[i], same.stress[i], tolerance * largest(same.stress)) << i;
    EXPECT_NEAR(found[k].base_reaction, expected[k].base_reaction, tolerance * expected[k].weight);
    EXPECT_TRUE(found[k].in_equilibrium);
  }
}

class Multigrid : public ::testing::TestWithParam<exchange::FemElement> {};

TEST_P(Multigrid, FindsAtSmallStrainWhatFactorsFind) {
  const exchange::Case study = block(GetParam(), 0.125);
  expect_same(solve_with(FemLinearSolver::multigrid, study), solve_with(FemLinearSolver::direct, study), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(EveryElement, Multigrid,
                         ::testing::Values(exchange::FemElement::Q1, exchange::FemElement::Q2));

/// The law `rate` has a tangent that is not symmetric.
TEST(Multigrid, FindsAtFiniteStrainWhatFactorsFind) {
  exchange::Case study = block(exchange::FemElement::Q1, 0.125);
  study.fem.kinematics = exchange::Kinematics::finite;
  study.construction.convention = exchange::Convention::level_up;
  study.fem.increments = 2;
  for (const exchange::Law law : {exchange::Law::rate, exchange::Law::neo_hookean}) {
    study.materials["fill"].law = law;
    expect_same(solve_with(FemLinearSolver::multigrid, study), solve_with(FemLinearSolver::direct, study), 1e-9);
  }
}

TEST(Multigrid, SolvesInThePlane) {
  const exchange::Case study = column({.layers = 2, .element_size = 0.0625, .width = 2.0, .height = 1.0});
  expect_same(solve_with(FemLinearSolver::multigrid, study), solve_with(FemLinearSolver::direct, study), 1e-9);
}

TEST(Multigrid, SolvesNearlyIncompressibleMaterial) {
  exchange::Case study = block(exchange::FemElement::Q2, 0.25);
  study.materials["fill"].poissons_ratio = 0.49;
  expect_same(solve_with(FemLinearSolver::multigrid, study), solve_with(FemLinearSolver::direct, study), 1e-8);
}

/// Contributions of cells are added in one order, whoever computes them.
TEST(Threads, ChangeNoBitOfWhatFactorsFind) {
  exchange::Case study = block(exchange::FemElement::Q1, 0.125);
  study.fem.linear_solver = FemLinearSolver::direct;
  const std::vector<exchange::Stage> one = solve(study);
  study.fem.threads = 2;
  const std::vector<exchange::Stage> two = solve(study);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].points.displacement, two[k].points.displacement);
    EXPECT_EQ(one[k].points.stress, two[k].points.stress);
  }
}

TEST(Threads, GiveTheSameBitsTwiceWithMultigrid) {
  exchange::Case study = block(exchange::FemElement::Q1, 0.0625);
  study.fem.threads = 2;
  const std::vector<exchange::Stage> once = solve_with(FemLinearSolver::multigrid, study);
  const std::vector<exchange::Stage> again = solve_with(FemLinearSolver::multigrid, study);
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].points.displacement, again[k].points.displacement);
    EXPECT_EQ(once[k].points.stress, again[k].points.stress);
    EXPECT_EQ(once[k].base_reaction, again[k].base_reaction);
  }
}

} // namespace
} // namespace settle::fem::testing
