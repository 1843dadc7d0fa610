// The paper's column by the explicit scheme with dynamic relaxation, against its closed form and the same column with
// local damping under a ramp.

#include <cmath>

#include <gtest/gtest.h>

#include "paper_column.hpp"

namespace settle::mpm::test {
namespace {

struct Comparison {
  RelativeErrors errors; ///< of the relaxed column
  std::int64_t steps = 0, steps_of_local_damping = 0;
  double settlement = 0, vertical_stress = 0; ///< relative differences of the two
};

std::int64_t steps_of(const std::vector<exchange::Stage>& stages) {
  std::int64_t steps = 0;
  for (const auto& stage : stages)
    steps += stage.steps;
  return steps;
}

void expect_at_rest(const std::vector<exchange::Stage>& stages, double force_error) {
  for (const auto& stage : stages) {
    EXPECT_TRUE(stage.in_equilibrium);
    EXPECT_LE(stage.out_of_balance, force_error);
    EXPECT_LE(std::abs(stage.base_reaction / stage.weight - 1.0), force_error); // what is unbalanced is all that lacks
  }
}

Comparison compared(Overrides overrides) {
  overrides.emplace_back("mpm.scheme=explicit");
  const auto local = stages_of(paper_column(overrides));
  overrides.emplace_back("mpm.explicit.relaxation=viscous");
  const auto study = paper_column(overrides);
  const auto relaxed = stages_of(study);
  expect_at_rest(relaxed, 0.001);
  const auto own = placed_points(relaxed.back()), other = placed_points(local.back());
  return {.errors = errors_of(study, relaxed),
          .steps = steps_of(relaxed),
          .steps_of_local_damping = steps_of(local),
          .settlement = relative_difference(own.settlement, other.settlement),
          .vertical_stress = relative_difference(own.vertical_stress, other.vertical_stress)};
}

/// Both rest within 0.1 % of their weight, and the path matters only where points cross cells: each crossing shifts the
/// stress of a point by what it differs from its new cell's, a share of 1 / 40 cells of the column. The limits of the
/// errors are those of local damping.
void expect_exact_and_soon(const Overrides& overrides) {
  const Comparison relaxed = compared(overrides);
  EXPECT_LE(relaxed.errors.settlement, 0.01);
  EXPECT_LE(relaxed.errors.vertical_stress, 0.01);
  EXPECT_LE(relaxed.settlement, 0.01);
  EXPECT_LE(relaxed.vertical_stress, 0.01);
  EXPECT_LE(10 * relaxed.steps, relaxed.steps_of_local_damping);
}

TEST(RelaxedColumn, RefilledIsTheExactOneInATenthOfTheStepsOfLocalDamping) {
  expect_exact_and_soon({});
}

TEST(RelaxedColumn, FloatIsTheExactOneInATenthOfTheStepsOfLocalDamping) {
  expect_exact_and_soon({"construction.convention=float"});
}

TEST(RelaxedColumn, OfGimpSquaresIsTheExactOneInATenthOfTheStepsOfLocalDamping) {
  expect_exact_and_soon({"mpm.element=quadrilateral", "mpm.basis=gimp", "mpm.integration=points"});
}

TEST(RelaxedColumn, HeldMoreTightlyIsNearerToTheQuasiStaticOne) {
  // Away from crossings, GIMP has no path: what is left is what is out of balance, and the quasi-static increments.
  const Overrides gimp{"construction.convention=float", "mpm.element=quadrilateral", "mpm.basis=gimp",
                       "mpm.integration=points"};
  const auto quasi_static = placed_points(stages_of(paper_column(gimp)).back());
  const auto distance = [&](const std::string& force_error) {
    Overrides overrides = gimp;
    overrides.insert(overrides.end(), {"mpm.scheme=explicit", "mpm.explicit.relaxation=viscous",
                                       "mpm.explicit.force_error=" + force_error});
    return relative_difference(placed_points(stages_of(paper_column(overrides)).back()).settlement,
                               quasi_static.settlement);
  };
  EXPECT_LE(distance("1e-3"), 2e-3);
  EXPECT_LE(distance("1e-5"), 2e-4);
}

TEST(RelaxedColumn, ConservesMassAndNeverStandsAboveItsDesignLevelByMoreThanPartOfARow) {
  const auto study = paper_column({"mpm.scheme=explicit", "mpm.explicit.relaxation=viscous"});
  for (const auto& stage : stages_of(study)) {
    double mass = 0;
    for (std::size_t p = 0; p < stage.points.size(); ++p)
      mass += stage.points.density[p] * stage.points.volume[p];
    EXPECT_NEAR(mass / stage.mass, 1.0, 1e-12);
    const double row = study.mpm.element_size / 6.0;
    EXPECT_NEAR(stage.surface_height, stage.layer * study.layer_thickness(), 0.2 * row);
  }
}

TEST(RelaxedColumn, UnderARampComesToTheSameRest) {
  const Overrides viscous{"construction.convention=float", "mpm.scheme=explicit", "mpm.explicit.relaxation=viscous"};
  Overrides ramped = viscous;
  ramped.emplace_back("mpm.explicit.ramp_time=2");
  const auto at_once = stages_of(paper_column(viscous)), slowly = stages_of(paper_column(ramped));
  EXPECT_GT(steps_of(slowly), steps_of(at_once));
  EXPECT_LE(relative_difference(placed_points(at_once.back()).settlement, placed_points(slowly.back()).settlement),
            0.01);
}

} // namespace
} // namespace settle::mpm::test
