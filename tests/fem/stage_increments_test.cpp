#include <gtest/gtest.h>

#include "drawn_bodies.hpp"
#include "staged_problem.hpp"

namespace settle::fem::testing {
namespace {

/// Highest node of the first layer of a drawn column 0.5 m wide: vertical displacement.
double heave_of_first_layer(const StagedProblem<2>& problem) {
  double heave = 0.0;
  for (const auto& cell : problem.placed_cells())
    for (const unsigned v : cell->vertex_indices())
      if (std::abs(cell->vertex(v)[1] - 1.0) < 1e-9)
        heave = interpolate(problem.element(), problem.history().of(cell).counted_displacement(),
                            dealii::GeometryInfo<2>::unit_cell_vertex(v))[1];
  return heave;
}

void run_stage(StagedProblem<2>& problem, int stage) {
  problem.begin(stage);
  ASSERT_TRUE(problem.solve(1.0).reached());
  problem.accept();
  problem.finish();
}

TEST(StageIncrement, OfARemovalReleasesItsShareOfTheForces) {
  exchange::Case study = drawn_column(2, 2.0);
  study.stages = {{.action = Action::ground, .layer = 1},
                  {.action = Action::ground, .layer = 2},
                  {.action = Action::remove, .layer = 2}};
  StagedProblem<2> problem(study);
  run_stage(problem, 1);
  run_stage(problem, 2);
  problem.begin(3);
  const double whole = 1720 * 9.81 / FrozenColumn::oedometric_modulus(400e3, 0.25);
  for (const double share : {0.25, 0.5, 1.0}) {
    ASSERT_TRUE(problem.solve(share).reached());
    problem.accept();
    EXPECT_NEAR(heave_of_first_layer(problem), share * whole, 1e-11 * whole);
  }
}

TEST(StageIncrement, OfALoadRaisesItsShareOfTheTraction) {
  exchange::Case study = drawn_column(1, 1.0);
  study.stages = {{.action = Action::ground, .layer = 1},
                  {.action = Action::load, .layer = 1, .from = {0.5, 1.0}, .to = {0.0, 1.0}, .traction = {0.0, -1e4}}};
  StagedProblem<2> problem(study);
  run_stage(problem, 1);
  problem.begin(2);
  for (const double share : {0.5, 1.0}) {
    const Equilibrium equilibrium = problem.solve(share);
    EXPECT_NEAR(equilibrium.base_reaction, 0.5 * (1720 * 9.81 + share * 1e4), 1e-7);
    problem.accept();
  }
}

/// Solver refuses what the formulation does not know of materials; density is of a layer all the same.
TEST(Layers, WeighWhatTheirMaterialsSay) {
  exchange::Case study = drawn_column(2, 2.0);
  study.materials["rock"] = study.fill();
  study.materials["rock"].density = 2600.0;
  study.geometry.polygons[1].material = "rock";
  StagedProblem<2> problem(study);
  run_stage(problem, 1);
  problem.begin(2);
  const double weight = 0.5 * 9.81 * (1720.0 + 2600.0);
  EXPECT_NEAR(problem.solve(1.0).base_reaction, weight, 1e-10 * weight);
  EXPECT_NEAR(problem.mass(1), 0.5 * 1720.0, 1e-9);
  EXPECT_NEAR(problem.mass(2), 0.5 * 2600.0, 1e-9);
}

} // namespace
} // namespace settle::fem::testing
