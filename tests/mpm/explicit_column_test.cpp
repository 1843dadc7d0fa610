// The paper's column with its explicit scheme, damping 0.75, held to equilibrium.

#include <cmath>

#include <gmock/gmock.h>

#include <fmt/format.h>

#include "paper_column.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::mpm::test {
namespace {

using testing::HasSubstr;

void expect_exact_and_same_as_quasi_static(const std::string& convention) {
  const Overrides overrides{"construction.convention=" + convention};
  const auto study = paper_column({overrides.front(), "mpm.scheme=explicit"});
  const auto stages = stages_of(study);
  const auto errors = errors_of(study, stages);
  EXPECT_LE(errors.settlement, 0.015);
  EXPECT_LE(errors.vertical_stress, 0.02);
  for (const auto& stage : stages)
    EXPECT_TRUE(stage.in_equilibrium);

  const auto other = placed_points(stages_of(paper_column(overrides)).back());
  const auto own = placed_points(stages.back());
  EXPECT_LE(relative_difference(own.settlement, other.settlement), 0.01);
  EXPECT_LE(relative_difference(own.vertical_stress, other.vertical_stress), 0.01);
}

TEST(ExplicitColumn, RefilledIsTheExactOneAndThatOfTheQuasiStaticScheme) {
  expect_exact_and_same_as_quasi_static("refill");
}

TEST(ExplicitColumn, FloatIsTheExactOneAndThatOfTheQuasiStaticScheme) {
  expect_exact_and_same_as_quasi_static("float");
}

TEST(ExplicitColumn, LevelUpIsTheExactOneAndThatOfTheQuasiStaticScheme) {
  expect_exact_and_same_as_quasi_static("level-up");
}

TEST(ExplicitColumn, AStageThatFindsNoEquilibriumInTimeEndsWithBothErrors) {
  const auto study =
      paper_column({"construction.convention=float", "mpm.scheme=explicit", "mpm.explicit.max_hold_time=0.2"});
  try {
    stages_of(study);
    FAIL() << "a fifth of a second is not enough";
  } catch (const exchange::NotConverged& error) {
    EXPECT_EQ(error.code(), exchange::ExitCode::solver_failed);
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("no equilibrium within max_hold_time = 0.2 s"),
                                             testing::ContainsRegex("given: +force error [0-9].*, energy error [0-9]"),
                                             HasSubstr("allowed: force error 0.001, energy error 0.001")));
  }
}

TEST(ExplicitColumn, AnUnheldRampIsOutOfEquilibriumAndLooksLikeThePapersNumbers) {
  const auto study = paper_column(
      {"construction.convention=drop", "mpm.scheme=explicit", "mpm.explicit.hold=0", "mpm.explicit.ramp_time=15"});
  const auto last = stages_of(study).back();
  EXPECT_FALSE(last.in_equilibrium);
  EXPECT_GT(last.out_of_balance, 0.001);
  EXPECT_NEAR(-last.points.stress[6 * lowest_point(last) + 1], 77.6e3, 1e3); // another code: 77.64 kPa
  EXPECT_NEAR(mean_density(last), 1860.0, 10.0);                             // another code: 1860 kg/m3
}

TEST(ExplicitColumn, AHoldOfGivenLengthBringsItCloserToEquilibrium) {
  const auto imbalance_after = [](const std::string& hold) {
    const auto study = paper_column({"construction.convention=float", "construction.layers=2", "mpm.scheme=explicit",
                                     "mpm.explicit.ramp_time=5", "mpm.explicit.hold=" + hold});
    const auto last = stages_of(study).back();
    return std::abs(last.base_reaction / last.weight - 1.0);
  };
  EXPECT_LT(imbalance_after("10"), 0.2 * imbalance_after("0"));
}

TEST(ExplicitColumn, PlainPointIntegrationSuffersFromCellCrossing) {
  // The classic method: stresses summed over the points' own volumes. Not a defect of this solver but what is known of
  // linear shape functions; mixed integration, 0.6 % here, is the remedy.
  const auto study = paper_column({"construction.convention=float", "mpm.scheme=explicit", "mpm.integration=points"});
  EXPECT_GT(errors_of(study, stages_of(study)).settlement, 0.5);
}

} // namespace
} // namespace settle::mpm::test
