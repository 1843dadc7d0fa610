#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "perfect_body.hpp"
#include "perfect_result.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/legs.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using exchange::Quantity;
using testing::HasSubstr;

/// The body of two layers that may fail; it does at half the weight of the second.
RunOutcome failed_run() {
  RunOutcome run = perfect_body_run(body_case({"construction.may_fail=true"}));
  for (const char* solver : {"mpm", "fem"}) {
    exchange::Result& result = result_in(run, solver);
    result.failure = exchange::Failure{.stage = 2, .share = 0.5};
    exchange::Stage& last = result.stages.back();
    last.weight -= 0.5 * run.study.gravity * last.mass_placed;
    last.base_reaction = last.weight;
  }
  return run;
}

/// The same, where MPM has gone on from there to rest.
RunOutcome run_out_run() {
  RunOutcome run = failed_run();
  exchange::Result& result = result_in(run, "mpm");
  exchange::Stage state = result.stages.back();
  state.weight = state.base_reaction = run.study.gravity * state.mass;
  result.failure->run_out = exchange::RunOut{.at_rest = true,
                                             .duration = 3.0,
                                             .largest_displacement = 0.5,
                                             .distance = 0.25,
                                             .mass_before = state.mass,
                                             .points_before = static_cast<std::int64_t>(state.points.size()),
                                             .external_work = 1000.0,
                                             .stress_work = 950.0,
                                             .damping_loss = 45.0,
                                             .state = std::move(state)};
  return run;
}

const Verdict& verdict_on(const std::vector<Verdict>& verdicts, const std::string& what) {
  for (const Verdict& verdict : verdicts)
    if (verdict.what.find(what) != std::string::npos) return verdict;
  throw std::out_of_range(what);
}

LegSamples height_leg(const RunOutcome& run) {
  return leg_samples(
      run, {.value = "fem", .reference = "exact", .quantity = Quantity::failure_height, .stage = 2, .exact = 1.6});
}

TEST(FailingBody, HasTheHeightThatCarriedItsWeightLast) {
  const LegSamples leg = height_leg(failed_run());
  ASSERT_EQ(leg.size(), 1U) << leg.problem;
  EXPECT_NEAR(leg.value[0], 1.5, 1e-12);
  EXPECT_NEAR(leg.reference[0], 1.6, 1e-12);
}

TEST(FailingBody, IsAuditedByWhatActedWhenItFailed) {
  RunOutcome run = failed_run();
  judge_into(run);
  for (const char* what : {"weight = gravity x mass", "base reaction = weight", "every stage is there"})
    EXPECT_EQ(verdict_on(run.verdicts, what).status, Status::passed) << verdict_on(run.verdicts, what).message;
  result_in(run, "mpm").failure->share = 0.75;
  judge_into(run);
  EXPECT_EQ(verdict_on(run.verdicts, "mpm: weight = gravity x mass").status, Status::failed);
}

TEST(FailingBody, ThatRunsOutIsAuditedOnceMore) {
  RunOutcome run = run_out_run();
  judge_into(run);
  for (const char* what :
       {"mpm: the run-out loses nothing", "mpm: the run-out ends at rest", "mpm: work of gravity = stress work",
        "mpm: base reaction = weight after the run-out", "mpm: every stage is there", "mpm: every stage ends in"})
    EXPECT_EQ(verdict_on(run.verdicts, what).status, Status::passed) << verdict_on(run.verdicts, what).message;
  EXPECT_NEAR(verdict_on(run.verdicts, "work of gravity").value, 0.005, 1e-12);
}

TEST(FailingBody, ThatLosesPointsWorkOrRestOnItsWayFails) {
  const auto status_with = [](const char* what, auto&& change) {
    RunOutcome run = run_out_run();
    change(*result_in(run, "mpm").failure->run_out);
    judge_into(run);
    return verdict_on(run.verdicts, what).status;
  };
  using exchange::RunOut;
  EXPECT_EQ(status_with("loses nothing", [](RunOut& of) { ++of.points_before; }), Status::failed);
  EXPECT_EQ(status_with("loses nothing", [](RunOut& of) { of.mass_before *= 1.0 + 1e-9; }), Status::failed);
  EXPECT_EQ(status_with("ends at rest", [](RunOut& of) { of.at_rest = false; }), Status::failed);
  EXPECT_EQ(status_with("work of gravity", [](RunOut& of) { of.stress_work *= 0.9; }), Status::failed);
  EXPECT_EQ(status_with("work of gravity", [](RunOut& of) { of.external_work = std::nan(""); }), Status::missing);
  EXPECT_EQ(status_with("after the run-out", [](RunOut& of) { of.state.base_reaction *= 1.01; }), Status::failed);
}

TEST(FailingBody, ThatStandsHasNoHeightOfFailure) {
  const RunOutcome run = perfect_body_run(body_case({"construction.may_fail=true"}));
  const LegSamples leg = height_leg(run);
  EXPECT_EQ(leg.size(), 0U);
  EXPECT_THAT(leg.problem, HasSubstr("fem did not fail"));
}

TEST(FailingBody, ThatMayNotFailMissesItsStages) {
  RunOutcome run = failed_run();
  run.study.construction.may_fail = false;
  result_in(run, "mpm").stages.pop_back();
  judge_into(run);
  EXPECT_EQ(verdict_on(run.verdicts, "mpm: every stage is there").status, Status::missing);
}

TEST(LoadedBody, HasTheLoadInItsBaseReaction) {
  const exchange::Case study = body_case({"stage=[{layer=1}, {layer=2}, {action=\"load\", from=[2, 2], to=[0, 2], "
                                          "traction=[0, -1e4]}]"});
  RunOutcome run = perfect_body_run(study);
  for (const char* solver : {"mpm", "fem"}) {
    exchange::Result& result = result_in(run, solver);
    result.stages.push_back(result.stages.back());
    result.stages.back().mass_placed = 0.0;
    result.stages.back().base_reaction += 2e4;
  }
  judge_into(run);
  EXPECT_EQ(verdict_on(run.verdicts, "mpm: base reaction").status, Status::passed);
  result_in(run, "mpm").stages.back().base_reaction -= 2e4;
  judge_into(run);
  EXPECT_EQ(verdict_on(run.verdicts, "mpm: base reaction").status, Status::failed);
}

TEST(SupportReaction, IsTheSizeOfTheForceOfTheSupportAskedFor) {
  RunOutcome run = perfect_body_run(body_case());
  result_in(run, "fem").stages.back().support_reactions = {3.0, 4.0, 60.0, 80.0};
  LegRequest request{.value = "fem",
                     .reference = "exact",
                     .quantity = Quantity::support_reaction,
                     .stage = 2,
                     .support = 1,
                     .exact = 5.0};
  EXPECT_NEAR(leg_samples(run, request).value.at(0), 5.0, 1e-15);
  request.support = 3;
  EXPECT_THAT(leg_samples(run, request).problem, HasSubstr("does not say what its supports exert"));
}

} // namespace
} // namespace settle::compare::test
