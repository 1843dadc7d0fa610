#include "settle/compare/campaign_plan.hpp"

#include <fstream>

#include <gmock/gmock.h>

#include "paper_cases.hpp"
#include "scratch_folder.hpp"
#include "settle/compare/run_folder.hpp"

namespace settle::compare::test {
namespace {

using testing::ElementsAre;

/// Runs of one solver whose program a script plays, without any result yet.
class CampaignPlan : public testing::Test {
protected:
  CampaignPlan() {
    setenv("SETTLE_MPM", folder_.script("solver", "true").c_str(), 1);
    for (const std::string name : {"a", "b", "c", "d"}) {
      ExpandedRun run;
      run.name = name;
      run.solvers = {"mpm"};
      run.study = paper_case(4, exchange::Convention::refill);
      run.study.title = name;
      runs_.push_back(run);
      std::filesystem::create_directories(run_folder(folder_.path(), name));
    }
  }
  ~CampaignPlan() override { unsetenv("SETTLE_MPM"); }
  CampaignPlan(const CampaignPlan&) = delete;
  CampaignPlan& operator=(const CampaignPlan&) = delete;

  [[nodiscard]] Plan plan(bool fresh = false) const { return plan_campaign(runs_, folder_.path(), fresh); }
  /// The run has failed after so long, which is remembered [s].
  void remember(std::size_t run, double wall_time) const {
    const Task task = plan().tasks[run];
    note_record(task.job.result_file, {.made_from = task.made_from, .wall_time = wall_time, .result = {}});
  }
  void finish(std::size_t run) const {
    const Task task = plan().tasks[run];
    std::ofstream(task.job.result_file) << "a result";
    note_success(task.job.result_file, {.made_from = task.made_from, .wall_time = 1.0, .result = {}});
  }

  ScratchFolder folder_;
  std::vector<ExpandedRun> runs_;
};

TEST_F(CampaignPlan, RunsWithoutRememberedCostKeepTheirOrder) {
  EXPECT_THAT(order_of(plan()), ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(due(plan()), 4U);
}

TEST_F(CampaignPlan, TheLongestGoesFirstAndTheUnknownBeforeIt) {
  remember(0, 1.0);
  remember(1, 3.0);
  remember(2, 2.0);
  EXPECT_THAT(order_of(plan()), ElementsAre(3, 1, 2, 0));
}

TEST_F(CampaignPlan, WhatIsUpToDateGoesLastAndIsNotDue) {
  finish(0);
  EXPECT_THAT(order_of(plan()), ElementsAre(1, 2, 3, 0));
  EXPECT_EQ(due(plan()), 3U);
  EXPECT_EQ(plan(true).tasks[0].reason, Reason::forced);
}

TEST_F(CampaignPlan, OnlyTheRunWhoseCaseHasChangedIsDue) {
  for (std::size_t run = 0; run < runs_.size(); ++run)
    finish(run);
  EXPECT_EQ(due(plan()), 0U);
  runs_[2].study.gravity = 10.0;
  EXPECT_EQ(due(plan()), 1U);
  EXPECT_EQ(plan().tasks[2].reason, Reason::case_changed);
}

TEST_F(CampaignPlan, TheMemoryOfARunIsLimitedToLessThanTheMachineHasUnlessItSays) {
  runs_[1].memory_limit = 5e6;
  const Plan all = plan();
  EXPECT_GT(all.tasks[0].job.memory_limit, 1e6);
  EXPECT_LT(all.tasks[0].job.memory_limit, 1e15);
  EXPECT_EQ(all.tasks[1].job.memory_limit, 5e6);
}

} // namespace
} // namespace settle::compare::test
