/// \file
/// What Slurm says of jobs that could not note their end themselves. squeue and sacct are played by scripts that print
/// what Slurm 22.05 has printed: of arrays of sleeping jobs that ran out of time, were cancelled, or lost their node.

#include "settle/compare/slurm_campaign.hpp"

#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "paper_cases.hpp"
#include "scratch_folder.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/slurm_jobs.hpp"
#include "settle/compare/task_run.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// `squeue --noheader --array --me --states=all --format=%F|%K|%T|%r|%j`; out of memory and deadline as its manual
/// spells them (the machine had no control groups).
constexpr auto listed = R"(1|3|CANCELLED|None|settle-array
1|0|COMPLETED|None|settle-array
1|1|FAILED|NonZeroExitCode|settle-array
1|2|TIMEOUT|TimeLimit|settle-array
1|4|NODE_FAIL|NodeDown|settle-array
1|5|OUT_OF_MEMORY|OutOfMemory|settle-array
1|6|DEADLINE|DeadLine|settle-array
2|N/A|RUNNING|None|settle-judge
)";

/// One array of runs that are with Slurm, none of which has noted its end.
class SlurmEnds : public testing::Test {
protected:
  static constexpr std::size_t runs = 8;

  SlurmEnds() : path_(std::getenv("PATH")) {
    setenv("PATH", (folder_.path().string() + ":/usr/bin:/bin").c_str(), 1);
    setenv("SETTLE_MPM", folder_.script("solver", "true").c_str(), 1);
    squeue(listed);
    sacct("");
    SubmittedArray array{.name = "settle-array", .id = "1", .titles = {}};
    for (std::size_t number = 0; number < runs; ++number) {
      ExpandedRun run;
      run.name = fmt::format("run {}", number);
      run.solvers = {"mpm"};
      run.study = paper_case(4, exchange::Convention::refill);
      std::filesystem::create_directories(run_folder(folder_.path(), run.name));
      array.titles.push_back(run.name + ", mpm");
      runs_.push_back(run);
    }
    submission_ = {.arrays = {array}, .judge_name = "settle-judge", .judge_id = "2"};
    for (const Task& task : plan_campaign(runs_, folder_.path(), false).tasks)
      note_record(task.job.result_file,
                  {.made_from = task.made_from, .failure = FailedAttempt{.status = std::string(submitted)}});
  }
  ~SlurmEnds() override {
    setenv("PATH", path_.c_str(), 1);
    unsetenv("SETTLE_MPM");
  }
  SlurmEnds(const SlurmEnds&) = delete;
  SlurmEnds& operator=(const SlurmEnds&) = delete;

  /// Has a program of Slurm print a text; arguments it does not know end it, as they end the real one.
  void play(const std::string& program, const std::string& text, const std::string& knows) const {
    (void)folder_.file(program + ".txt", text);
    (void)folder_.script(program, fmt::format("for a in \"$@\"; do case $a in {}) ;; *) echo \"{}: unrecognized option "
                                              "'$a'\" >&2; exit 1 ;; esac; done\ncat '{}'\n",
                                              knows, program, (folder_.path() / (program + ".txt")).string()));
  }
  void squeue(const std::string& text) const {
    play("squeue", text, "--noheader|--array|--me|--states=*|--name=*|--format=*");
  }
  void sacct(const std::string& text) const {
    play("sacct", text, "--noheader|--parsable2|--allocations|--format=*|--jobs=*");
  }
  /// How the task of a number has ended, as it is judged.
  [[nodiscard]] SolverRun end_of(std::size_t number) const {
    Plan plan = plan_campaign(runs_, folder_.path(), false);
    note_lost_jobs(plan, submission_, folder_.path());
    return recorded_end(plan_campaign(runs_, folder_.path(), false).tasks[number]);
  }

  ScratchFolder folder_;
  std::string path_;
  std::vector<ExpandedRun> runs_;
  Submission submission_;
};

TEST_F(SlurmEnds, EachStateIsTheStatusItMeans) {
  EXPECT_EQ(end_of(2).status, SolverStatus::timed_out);
  EXPECT_EQ(end_of(5).status, SolverStatus::out_of_memory);
  EXPECT_EQ(end_of(6).status, SolverStatus::timed_out);
  for (const std::size_t number : {0U, 1U, 3U, 4U}) // a job that has completed without a record has not done its work
    EXPECT_EQ(end_of(number).status, SolverStatus::crashed) << number;
}

TEST_F(SlurmEnds, TheJobAndItsStateAreNamedWithTheEndOfItsLog) {
  std::filesystem::create_directories(slurm_folder(folder_.path()));
  std::ofstream(slurm_folder(folder_.path()) / "settle-array_4.log") << "step 99\nslurmstepd: error: NODE FAILURE\n";
  const SolverRun run = end_of(4);
  EXPECT_THAT(run.message, AllOf(HasSubstr("1_4"), HasSubstr("NODE_FAIL")));
  EXPECT_THAT(run.tail, HasSubstr("NODE FAILURE"));
  EXPECT_THAT(end_of(3).message, HasSubstr("CANCELLED"));
}

TEST_F(SlurmEnds, AJobThatSlurmHasForgottenHasNoResult) {
  EXPECT_EQ(end_of(7).status, SolverStatus::no_result);
  EXPECT_THAT(end_of(7).message, HasSubstr("does not know it any more"));
}

TEST_F(SlurmEnds, WhatSqueueHasForgottenTheAccountsStillKnow) {
  squeue("");
  sacct("1_0|COMPLETED|settle-array\n1_2|TIMEOUT|settle-array\n1_3|CANCELLED by 1000|settle-array\n"
        "1_4|NODE_FAIL|settle-array\n1_5|OUT_OF_MEMORY|settle-array\n1_[6-7]|CANCELLED by 0|settle-array\n"
        "2|COMPLETED|settle-judge\n");
  EXPECT_EQ(end_of(2).status, SolverStatus::timed_out);
  EXPECT_EQ(end_of(5).status, SolverStatus::out_of_memory);
  EXPECT_THAT(end_of(3).message, HasSubstr("CANCELLED"));
  for (const std::size_t number : {6U, 7U}) // cancelled before they were told apart
    EXPECT_THAT(end_of(number).message, HasSubstr("CANCELLED")) << number;
}

TEST_F(SlurmEnds, OfTwoAnswersSqueuesIsTheNewer) {
  sacct("1_2|RUNNING|settle-array\n");
  EXPECT_EQ(end_of(2).status, SolverStatus::timed_out);
}

TEST_F(SlurmEnds, WithoutAccountsSqueueIsEnough) {
  (void)folder_.script("sacct", "echo 'Slurm accounting storage is disabled' >&2; exit 1");
  EXPECT_THAT(accounted_jobs({"1"}), IsEmpty());
  EXPECT_EQ(end_of(2).status, SolverStatus::timed_out);
}

TEST_F(SlurmEnds, ACampaignOfWhichOneJobIsLeftIsAtWork) {
  EXPECT_TRUE(is_at_work(submission_)); // the judge
  squeue("1|0|COMPLETED|None|settle-array\n2|N/A|COMPLETED|None|settle-judge\n");
  EXPECT_FALSE(is_at_work(submission_));
  squeue("1|4-7%2|PENDING|JobArrayTaskLimit|settle-array\n"); // tasks that squeue lists as one
  EXPECT_TRUE(is_at_work(submission_));
  squeue("2|N/A|PENDING|BeginTime|settle-judge\n"); // its node was lost, and it is to run again
  EXPECT_TRUE(is_at_work(submission_));
}

TEST_F(SlurmEnds, NoAnswerIsNotTakenForNoJobs) {
  (void)folder_.script("squeue", "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1");
  EXPECT_THROW((void)is_at_work(submission_), exchange::FileError);
  EXPECT_THROW((void)end_of(2), exchange::FileError);
}

TEST(SlurmStates, StatesThatEndAreToldFromThoseThatGoOn) {
  for (const char* state : {"COMPLETED", "FAILED", "TIMEOUT", "OUT_OF_MEMORY", "NODE_FAIL", "CANCELLED", "DEADLINE",
                            "BOOT_FAIL", "PREEMPTED", "REVOKED"})
    EXPECT_TRUE(has_ended(state)) << state;
  for (const char* state : {"PENDING", "RUNNING", "COMPLETING", "CONFIGURING", "REQUEUED", "SUSPENDED", ""})
    EXPECT_FALSE(has_ended(state)) << state;
}

} // namespace
} // namespace settle::compare::test
