#include <cstdlib>

#include <gmock/gmock.h>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class FailingSolver : public CommandLine {};

TEST_F(FailingSolver, ACrashIsAVerdictWithTheTailAndTheOtherSolverIsJudged) {
  play("mpm", "echo the last words; kill -SEGV $$");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text,
              AllOf(HasSubstr("error: column: mpm ran to its end"), HasSubstr("signal 11"), HasSubstr("the last words"),
                    HasSubstr("mpm gave no result: crashed"), Not(HasSubstr("fem gave no result"))));
  EXPECT_TRUE(std::filesystem::exists(out() / "report.html"));
}

TEST_F(FailingSolver, NotConvergingIsExitCodeThree) {
  play("fem", "echo 'no equilibrium in stage 2' >&2; exit 3");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("not converged"), HasSubstr("no equilibrium in stage 2")));
}

TEST_F(FailingSolver, TimeLimitsEndASolverThatHangs) {
  play("mpm", "sleep 60");
  const auto campaign = folder.file("hang.toml", "format = 1\n[[run]]\nname = \"column\"\ncase = \"column.toml\"\n"
                                                 "time_limit = 0.3\n[[run]]\nname = \"other\"\ncase = \"column.toml\"\n"
                                                 "solvers = [\"fem\"]\n");
  const Answer answer = settle({"campaign", campaign.string(), "--out", out().string()});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("timed out"), HasSubstr("time limit of 0.3 s")));
  EXPECT_TRUE(std::filesystem::exists(out() / "runs" / "other" / "fem.h5")); // the campaign went on
}

TEST_F(FailingSolver, FinishingWithoutAResultIsExitCodeFour) {
  play("mpm", "echo all is well");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("no result"), HasSubstr("all is well")));
}

TEST_F(FailingSolver, GarbageForAResultIsExitCodeFour) {
  play("mpm", "echo garbage > \"$out\"");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("unreadable result"));
}

TEST_F(FailingSolver, AnUnknownExitCodeIsACrashEvenWithAResultLeftBehind) {
  play("mpm", "cp " + prepared("mpm").string() + " \"$out\"; exit 77");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, HasSubstr("crashed"));
}

TEST_F(FailingSolver, ATruncatedResultIsExitCodeFour) {
  play("mpm", "head -c 3000 " + prepared("mpm").string() + " > \"$out\"");
  EXPECT_EQ(run_case().code, 4);
}

TEST_F(FailingSolver, ASolverThatCannotWriteIsExitCodeFour) {
  play("mpm", "echo 'no space left' >&2; exit 4");
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("no space left"));
}

TEST_F(FailingSolver, AMissingSolverSaysWhereItWasLookedFor) {
  setenv("SETTLE_MPM", "/nowhere/settle-mpm", 1);
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("not found"), HasSubstr("SETTLE_MPM")));
}

TEST_F(FailingSolver, AnOldResultIsNotTakenForThatOfASolverThatFails) {
  ASSERT_EQ(run_case().code, 0);
  play("mpm", "exit 3"); // another program: the result is not up to date
  EXPECT_EQ(run_case().code, 3);
  EXPECT_FALSE(std::filesystem::exists(result("mpm")));
}

TEST_F(FailingSolver, WhatCheckRefusesEndsTheCommandBeforeAnythingIsRunOrWritten) {
  const auto script = folder.script("refusing", "echo 'settle-fem: refill needs frozen geometry' >&2; exit 2");
  setenv("SETTLE_FEM", script.c_str(), 1);
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, HasSubstr("refill needs frozen geometry"));
  EXPECT_EQ(runs_of("mpm"), 0);
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(FailingSolver, CheckingAgainRemembersTheFailure) {
  play("mpm", "echo the last words; exit 3");
  ASSERT_EQ(run_case().code, 3);
  play_perfect("mpm");
  const Answer answer = settle({"check", out().string()});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.text, HasSubstr("the last words"));
}

} // namespace
} // namespace settle::compare::test
