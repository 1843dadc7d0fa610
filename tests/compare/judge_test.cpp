#include "settle/compare/judge.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "perfect_body.hpp"
#include "perfect_result.hpp"
#include "settle/compare/campaign_run.hpp"

namespace settle::compare::test {
namespace {

using exchange::Check;
using exchange::CheckStages;
using exchange::Convention;
using exchange::ExitCode;
using exchange::Norm;
using exchange::Quantity;
using testing::HasSubstr;

Check check_of(Quantity quantity, std::vector<std::string> between, double limit) {
  Check check;
  check.quantity = quantity;
  check.between = std::move(between);
  check.limit = limit;
  check.why = "a reason";
  return check;
}

RunOutcome run_with(std::vector<Check> checks) {
  exchange::Case study = paper_case(3, Convention::refill);
  study.checks = std::move(checks);
  return perfect_run(study);
}

const Verdict& find(const std::vector<Verdict>& verdicts, const std::string& what) {
  const auto found = std::find_if(verdicts.begin(), verdicts.end(),
                                  [&](const Verdict& v) { return v.what.find(what) != std::string::npos; });
  if (found == verdicts.end()) throw std::out_of_range(what);
  return *found;
}

TEST(Judge, PerfectSolversPassEverything) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1e-10),
                             check_of(Quantity::vertical_stress, {"fem", "exact"}, 1e-10),
                             check_of(Quantity::settlement, {"mpm", "fem"}, 0.3)});
  judge_into(run);
  for (const Verdict& verdict : run.verdicts) {
    EXPECT_EQ(verdict.status, Status::passed) << verdict.what << ": " << verdict.message;
  }
  EXPECT_EQ(exit_code_of({run}), ExitCode::success);
}

TEST(Judge, EveryCheckGetsExactlyOneVerdictEvenWithoutAnyResult) {
  RunOutcome run =
      run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1), check_of(Quantity::mass, {"mpm", "fem"}, 1),
                check_of(Quantity::density, {"nobody", "exact"}, 1)});
  run.solvers.clear();
  const std::vector<Verdict> verdicts = judge(run);
  ASSERT_EQ(verdicts.size(), 3U);
  for (const Verdict& verdict : verdicts) {
    EXPECT_EQ(verdict.status, Status::missing);
    EXPECT_THAT(verdict.message, HasSubstr("was not run"));
    EXPECT_TRUE(std::isnan(verdict.value));
  }
}

TEST(Judge, ACheckSaysWhatWasComparedAndRelativeToWhat) {
  const RunOutcome run = run_with({check_of(Quantity::settlement, {"exact", "mpm"}, 1e-10)});
  const Verdict verdict = judge_check(run, run.study.checks[0]);
  EXPECT_EQ(verdict.what, "settlement, mpm - exact, l2 over points, last stage");
  EXPECT_THAT(verdict.scale, testing::StartsWith("l2 norm of exact: 0."));
  EXPECT_THAT(verdict.scale, testing::EndsWith(" m"));
  EXPECT_EQ(verdict.why, "a reason");
  EXPECT_EQ(verdict.kind, "check");
}

TEST(Judge, ADifferenceAboveTheLimitFails) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 0.04)});
  for (double& u : result_in(run, "mpm").stages.back().points.displacement)
    u *= 1.05;
  const Verdict verdict = judge_check(run, run.study.checks[0]);
  EXPECT_EQ(verdict.status, Status::failed);
  EXPECT_NEAR(verdict.value, 0.05, 1e-12);
  EXPECT_THAT(verdict.message, HasSubstr("above the limit 0.04"));
}

TEST(Judge, AnExpectedBandHasALowerEnd) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 0.2)});
  run.study.checks[0].at_least = 0.1;
  const Verdict too_good = judge_check(run, run.study.checks[0]);
  EXPECT_EQ(too_good.status, Status::failed);
  EXPECT_THAT(too_good.message, HasSubstr("below the expected band"));
  for (double& u : result_in(run, "mpm").stages.back().points.displacement)
    u *= 1.15;
  EXPECT_EQ(judge_check(run, run.study.checks[0]).status, Status::passed);
}

TEST(Judge, ANanIsMissingAndNeverPasses) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1e9)});
  result_in(run, "mpm").stages.back().points.displacement[1] = NAN;
  const Verdict verdict = judge_check(run, run.study.checks[0]);
  EXPECT_EQ(verdict.status, Status::missing);
  EXPECT_THAT(verdict.message, HasSubstr("NaN"));
}

TEST(Judge, AResultWithoutPointsIsMissing) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1e9)});
  result_in(run, "mpm").stages.back().points = {};
  EXPECT_EQ(judge_check(run, run.study.checks[0]).status, Status::missing);
}

TEST(Judge, AllStagesGiveTheWorst) {
  RunOutcome run = run_with({check_of(Quantity::vertical_stress, {"mpm", "exact"}, 0.5)});
  run.study.checks[0].stages = CheckStages::all;
  for (double& s : result_in(run, "mpm").stages[1].points.stress)
    s *= 1.3;
  const Verdict verdict = judge_check(run, run.study.checks[0]);
  EXPECT_NEAR(verdict.value, 0.3, 1e-12);
  EXPECT_THAT(verdict.scale, HasSubstr("stage 2"));
}

TEST(Judge, AMissingStageIsMissingForEveryCheckOfTheLastStage) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1e9)});
  result_in(run, "mpm").stages.pop_back();
  judge_into(run);
  EXPECT_EQ(find(run.verdicts, "settlement").status, Status::missing);
  EXPECT_EQ(find(run.verdicts, "mpm: every stage is there").status, Status::missing);
  EXPECT_EQ(exit_code_of({run}), ExitCode::file_failed);
}

TEST(Judge, WrongPhysicsFailsWhateverTheAgreement) {
  const auto status_after = [](auto spoil) {
    RunOutcome run = run_with({});
    spoil(result_in(run, "mpm").used);
    return find(judge_physics(run), "mpm").status;
  };
  EXPECT_EQ(status_after([](exchange::Used&) {}), Status::passed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.youngs_modulus *= 1.0 + 1e-9; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.poissons_ratio = 0.3; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.density = 1700; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.gravity = 9.80665; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.law = exchange::Law::hencky; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.convention = Convention::drop; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.kinematics = exchange::Kinematics::small; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.dimension = 3; }), Status::failed);
  EXPECT_EQ(status_after([](exchange::Used& used) { used.gravity = NAN; }), Status::missing);
}

TEST(Judge, WrongPhysicsSaysWhatWasUsedAndWhatWasAsked) {
  RunOutcome run = run_with({});
  result_in(run, "fem").used.density = 1700;
  EXPECT_THAT(find(judge_physics(run), "fem").message, HasSubstr("density 1700 instead of 1720"));
}

TEST(Judge, AuditsCatchLostMassAndAWrongReactionAndNameTheStage) {
  RunOutcome run = run_with({});
  result_in(run, "mpm").stages[1].mass_placed *= 1.0 + 1e-10;
  result_in(run, "fem").stages[2].base_reaction *= 1.0 + 1e-8;
  const std::vector<Verdict> verdicts = judge_balance(run);
  const Verdict& mass = find(verdicts, "mpm: mass before");
  EXPECT_EQ(mass.status, Status::failed);
  EXPECT_THAT(mass.scale, HasSubstr("stage 2"));
  EXPECT_EQ(find(verdicts, "fem: base reaction").status, Status::failed);
  EXPECT_EQ(find(verdicts, "mpm: base reaction").status, Status::passed);
}

TEST(Judge, WhatWasRefilledIsPartOfTheBalanceOfMass) {
  RunOutcome run = run_with({});
  auto& stage = result_in(run, "mpm").stages[1];
  const double share = 0.2 * stage.mass_placed;
  stage.mass_placed -= share;
  stage.mass_refilled += share;
  EXPECT_EQ(find(judge_balance(run), "mpm: mass before").status, Status::passed);
  stage.mass_refilled *= 1.0 + 1e-9;
  EXPECT_EQ(find(judge_balance(run), "mpm: mass before").status, Status::failed);
}

TEST(Judge, PointsThatDoNotSumToTheMassFail) {
  RunOutcome run = run_with({});
  result_in(run, "mpm").stages[2].points.volume[0] *= 1.01;
  EXPECT_EQ(find(judge_balance(run), "mpm: mass of all points").status, Status::failed);
}

TEST(Judge, WithFrozenGeometryTheDensityAsPlacedMakesTheMass) {
  RunOutcome run = run_with({});
  for (double& density : result_in(run, "fem").stages[2].points.density)
    density *= 1.1; // of the strained material
  EXPECT_EQ(find(judge_balance(run), "fem: mass of all points").status, Status::passed);
  result_in(run, "fem").stages[2].points.volume[0] *= 1.01;
  EXPECT_EQ(find(judge_balance(run), "fem: mass of all points").status, Status::failed);
}

TEST(Judge, ANanInTheBalanceIsMissing) {
  RunOutcome run = run_with({});
  result_in(run, "mpm").stages[0].base_reaction = NAN;
  EXPECT_EQ(find(judge_balance(run), "mpm: base reaction").status, Status::missing);
}

TEST(Judge, APerfectBodyOfPolygonsPassesEverything) {
  exchange::Case study = body_case();
  for (const Quantity quantity : {Quantity::displacement, Quantity::stress, Quantity::mass, Quantity::base_reaction}) {
    study.checks.push_back(check_of(quantity, {"mpm", "exact"}, 1e-13));
    study.checks.push_back(check_of(quantity, {"fem", "mpm"}, 1e-13));
    study.checks.back().stages = CheckStages::all;
  }
  RunOutcome run = perfect_body_run(study);
  judge_into(run);
  for (const Verdict& verdict : run.verdicts)
    EXPECT_EQ(verdict.status, Status::passed) << verdict.what << ": " << verdict.message;
  EXPECT_EQ(exit_code_of({run}), ExitCode::success);
}

TEST(Judge, WhatACaseDoesNotStateIsMissingAndNeverPasses) {
  exchange::Case study = body_case();
  study.checks = {check_of(Quantity::stress, {"mpm", "exact"}, 1e9)};
  study.motion->stress.clear();
  RunOutcome run = perfect_body_run(study);
  judge_into(run);
  EXPECT_EQ(find(run.verdicts, "stress, mpm").status, Status::missing);
  EXPECT_THAT(find(run.verdicts, "stress, mpm").message, HasSubstr("does not state the stress"));
}

TEST(Judge, TheReactionIsAuditedOnlyWhereTheWeightIsAllThatLoads) {
  const auto audited = [](const exchange::Case& study) {
    const std::vector<Verdict> verdicts = judge_balance(perfect_body_run(study));
    return std::any_of(verdicts.begin(), verdicts.end(),
                       [](const Verdict& each) { return each.what == "fem: base reaction = weight"; });
  };
  EXPECT_TRUE(audited(body_case()));
  EXPECT_EQ(reaction_unaudited(body_case(), "fem"), "");
  const exchange::Case moved = body_case({"support.0.motion=exact"});
  EXPECT_FALSE(audited(moved));
  EXPECT_THAT(reaction_unaudited(moved, "fem"), HasSubstr("follow a motion"));
  exchange::Case in_time = body_case();
  in_time.motion->duration = 0.1;
  EXPECT_FALSE(audited(in_time));
  EXPECT_THAT(reaction_unaudited(in_time, "mpm"), HasSubstr("inertia"));
}

/// Half a metre deep: 1 m of the surface is half a square metre.
TEST(Judge, ALoadInSpaceIsOnItsDepth) {
  exchange::Case study = body_case();
  study.motion.reset();
  study.stages.push_back(
      {.action = exchange::Action::load, .layer = 1, .from = {1.0, 1.0}, .to = {0.0, 1.0}, .traction = {0.0, -3e3}});
  const int last = study.n_stages();
  EXPECT_NEAR(surface_load(study, last), 3e3, 1e-9);
  study.geometry.dimension = 3;
  study.geometry.depth = 0.5;
  EXPECT_NEAR(surface_load(study, last), 1.5e3, 1e-9);
  EXPECT_EQ(surface_load(study, last - 1), 0.0);
}

TEST(Judge, WithoutGravityNothingIsDividedByTheWeight) {
  RunOutcome run = perfect_body_run(body_case({"gravity=0"}));
  for (const Verdict& verdict : judge_balance(run))
    EXPECT_EQ(verdict.status, Status::passed) << verdict.what << ": " << verdict.message;
  result_in(run, "mpm").stages.back().weight = 1e-3;
  EXPECT_EQ(find(judge_balance(run), "mpm: weight").status, Status::failed);
  result_in(run, "mpm").stages.back().weight = NAN;
  EXPECT_EQ(find(judge_balance(run), "mpm: weight").status, Status::missing);
}

TEST(Judge, AMotionInTimeIsNotAskedToComeToRest) {
  exchange::Case study = body_case();
  study.mpm.scheme = exchange::Scheme::explicit_dynamic;
  study.motion->duration = 0.1;
  for (const Verdict& verdict : judge_balance(perfect_body_run(study)))
    EXPECT_NE(verdict.what, "mpm: every stage ends in equilibrium");
}

TEST(Judge, AnExplicitSchemeHeldToEquilibriumHasAWiderReaction) {
  RunOutcome run = run_with({});
  run.study.mpm.scheme = exchange::Scheme::explicit_dynamic;
  result_in(run, "mpm").stages[2].base_reaction *= 1.001;
  EXPECT_EQ(find(judge_balance(run), "mpm: base reaction").status, Status::passed);
  result_in(run, "mpm").stages[2].base_reaction *= 1.002;
  EXPECT_EQ(find(judge_balance(run), "mpm: base reaction").status, Status::failed);
}

TEST(Judge, AnUnheldRampGetsNoPassOnItsReaction) {
  RunOutcome run = run_with({});
  run.study.mpm.scheme = exchange::Scheme::explicit_dynamic;
  run.study.mpm.explicit_dynamic.hold = 0.0;
  for (auto& stage : result_in(run, "mpm").stages)
    stage.in_equilibrium = false;
  EXPECT_TRUE(is_unheld(run.study, "mpm"));
  EXPECT_FALSE(is_unheld(run.study, "fem"));
  for (const Verdict& verdict : judge_balance(run)) {
    EXPECT_NE(verdict.what, "mpm: base reaction = weight");
    EXPECT_NE(verdict.what, "mpm: every stage ends in equilibrium");
  }
}

TEST(Judge, AStageOutOfEquilibriumFailsWhereEquilibriumIsAskedFor) {
  RunOutcome run = run_with({});
  result_in(run, "mpm").stages[1].in_equilibrium = false;
  EXPECT_EQ(find(judge_balance(run), "mpm: every stage ends").status, Status::failed);
}

TEST(Judge, ASolverThatFailedIsAnErrorWithTheTailOfItsOutput) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1e9)});
  run.solvers[0].result.reset();
  run.solvers[0].status = SolverStatus::crashed;
  run.solvers[0].message = "killed by signal 11";
  run.solvers[0].tail = "the last words";
  judge_into(run);
  EXPECT_EQ(run.verdicts[0].status, Status::error);
  EXPECT_THAT(run.verdicts[0].message, HasSubstr("signal 11"));
  EXPECT_THAT(run.verdicts[0].message, HasSubstr("the last words"));
  EXPECT_THAT(find(run.verdicts, "settlement").message, HasSubstr("crashed"));
  EXPECT_EQ(exit_code_of({run}), ExitCode::solver_failed);
}

TEST(Judge, AReferenceThatCannotBeReadIsMissingAndSoIsItsCheck) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "code"}, 1e9)});
  run.study.file = "case.toml";
  run.study.references["code"] = {.file = "no-such-table.csv", .title = ""};
  judge_into(run);
  EXPECT_EQ(find(run.verdicts, "reference \"code\"").status, Status::missing);
  EXPECT_EQ(find(run.verdicts, "settlement").status, Status::missing);
  EXPECT_EQ(exit_code_of({run}), ExitCode::file_failed);
}

TEST(Judge, AColumnWithoutEquilibriumIsAnErrorOfTheCheck) {
  RunOutcome run = run_with({check_of(Quantity::settlement, {"mpm", "exact"}, 1e9)});
  run.study.materials["fill"].youngs_modulus = 1e3;
  judge_into(run);
  EXPECT_EQ(find(run.verdicts, "settlement").status, Status::error);
}

TEST(ExitCodes, ASolverFailureGoesBeforeAMissingFileAndThatBeforeAFailedVerdict) {
  RunOutcome failed = run_with({});
  judge_into(failed);
  failed.verdicts.front().status = Status::failed;
  RunOutcome missing = failed;
  missing.solvers.front().status = SolverStatus::no_result;
  RunOutcome crashed = failed;
  crashed.solvers.front().status = SolverStatus::timed_out;
  EXPECT_EQ(exit_code_of({failed}), ExitCode::verdict_failed);
  EXPECT_EQ(exit_code_of({failed, missing}), ExitCode::file_failed);
  EXPECT_EQ(exit_code_of({failed, missing, crashed}), ExitCode::solver_failed);
  EXPECT_EQ(exit_code_of({}), ExitCode::verdict_failed);
}

} // namespace
} // namespace settle::compare::test
