#include "settle/compare/process.hpp"

#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scratch_folder.hpp"

namespace settle::compare::test {
namespace {

const std::atomic<bool> go_on{false};

ProcessOutcome run(const std::string& body, const ScratchFolder& folder, double time_limit = 20.0) {
  return run_process({.program = folder.script("program", body),
                      .arguments = {"first", "second word"},
                      .log = folder.path() / "log",
                      .time_limit = time_limit},
                     go_on);
}

TEST(Process, GivesTheExitCodeAndKeepsBothOutputs) {
  const ScratchFolder folder;
  const ProcessOutcome outcome = run("echo out; echo error >&2; echo \"$2\"; exit 7", folder);
  EXPECT_EQ(outcome.end, ProcessEnd::exited);
  EXPECT_EQ(outcome.code, 7);
  EXPECT_EQ(tail_of(folder.path() / "log", 9), "out\nerror\nsecond word");
}

TEST(Process, GivesTheSignal) {
  const ScratchFolder folder;
  const ProcessOutcome outcome = run("kill -SEGV $$", folder);
  EXPECT_EQ(outcome.end, ProcessEnd::signalled);
  EXPECT_EQ(outcome.code, SIGSEGV);
}

TEST(Process, ToldToEndTogetherWithUsHasNotEndedByItself) {
  const ScratchFolder folder;
  std::atomic<bool> stop{false};
  const ProcessRequest request{
      .program = folder.script("program", "kill -TERM $$"), .log = folder.path() / "log", .time_limit = 20.0};
  std::jthread teller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  EXPECT_EQ(run_process(request, stop).end, ProcessEnd::stopped);
  EXPECT_EQ(run_process(request, go_on).end, ProcessEnd::signalled);
}

TEST(Process, IsKilledAtItsTimeLimitTogetherWithItsChildren) {
  const ScratchFolder folder;
  const auto witness = folder.path() / "survived";
  const ProcessOutcome outcome = run("(sleep 1; touch " + witness.string() + ") & sleep 30", folder, 0.2);
  EXPECT_EQ(outcome.end, ProcessEnd::timed_out);
  EXPECT_LT(outcome.wall_time, 5.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_FALSE(std::filesystem::exists(witness));
}

TEST(Process, IsKilledWhenItTakesMoreMemoryThanItMay) {
  const ScratchFolder folder;
  constexpr double limit = 50e6; // [B]; a shell has some
  const ProcessOutcome outcome = run_process({.program = folder.script("program", "x=x; while :; do x=$x$x; done"),
                                              .arguments = {},
                                              .log = folder.path() / "log",
                                              .time_limit = 60,
                                              .memory_limit = limit},
                                             go_on);
  EXPECT_EQ(outcome.end, ProcessEnd::out_of_memory);
  EXPECT_GT(outcome.peak_memory, limit);
}

TEST(Process, TheMemoryOfItsChildrenCounts) {
  const ScratchFolder folder;
  const auto greedy = folder.script("greedy", "x=x; while :; do x=$x$x; done");
  const ProcessOutcome outcome = run_process({.program = folder.script("program", greedy.string() + "; true"),
                                              .arguments = {},
                                              .log = folder.path() / "log",
                                              .time_limit = 60,
                                              .memory_limit = 50e6},
                                             go_on);
  EXPECT_EQ(outcome.end, ProcessEnd::out_of_memory);
}

/// The kernel counts what the starter has, because both share it until the program begins.
TEST(Process, ItsPeakMemoryIsItsOwnAndNotThatOfWhoStartedIt) {
  const ScratchFolder folder;
  constexpr std::size_t much = 60'000'000; // [B]
  const std::vector<char> own(much, 'x');
  EXPECT_LT(run("sleep 0.3", folder).peak_memory, 0.5 * much);
  const ProcessOutcome larger = run("x=x; while [ ${#x} -lt 130000000 ]; do x=$x$x; done; sleep 0.2", folder);
  EXPECT_GT(larger.peak_memory, 2.0 * much);
  EXPECT_EQ(own.back(), 'x');
}

TEST(Process, TellsTheTimeOfTheProcessor) {
  const ScratchFolder folder;
  const ProcessOutcome working = run("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done", folder);
  EXPECT_GT(working.cpu_time, 0.01);
  const ProcessOutcome idle = run("sleep 0.3", folder);
  EXPECT_GE(idle.wall_time, 0.3);
  EXPECT_LT(idle.cpu_time, 0.25);
}

TEST(Process, WhatItLeavesRunningIsEnded) {
  const ScratchFolder folder;
  const auto witness = folder.path() / "survived";
  EXPECT_EQ(run("(sleep 1; touch " + witness.string() + ") & exit 0", folder).end, ProcessEnd::exited);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_FALSE(std::filesystem::exists(witness));
}

TEST(Process, IsKilledWhenItIsToStop) {
  const ScratchFolder folder;
  std::atomic<bool> stop{false};
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    stop = true;
  });
  const ProcessOutcome outcome = run_process({.program = folder.script("program", "sleep 30"),
                                              .arguments = {},
                                              .log = folder.path() / "log",
                                              .time_limit = 20},
                                             stop);
  EXPECT_EQ(outcome.end, ProcessEnd::stopped);
  EXPECT_LT(outcome.wall_time, 5.0);
}

TEST(Process, AProgramThatIsNotThereIsAnOutcome) {
  const ScratchFolder folder;
  const ProcessOutcome outcome = run_process(
      {.program = "/nowhere/program", .arguments = {}, .log = folder.path() / "log", .time_limit = 5}, go_on);
  EXPECT_EQ(outcome.end, ProcessEnd::not_started);
  EXPECT_FALSE(outcome.problem.empty());
}

TEST(Process, ALogThatCannotBeWrittenIsAnOutcome) {
  const ScratchFolder folder;
  const ProcessOutcome outcome = run_process(
      {.program = folder.script("program", "true"), .arguments = {}, .log = "/nowhere/log", .time_limit = 5}, go_on);
  EXPECT_EQ(outcome.end, ProcessEnd::not_started);
}

TEST(Process, ManyAtOnceKeepTheirOwnExitCodes) {
  const ScratchFolder folder;
  const auto program = folder.script("program", "sleep 0.05; exit $1");
  std::vector<ProcessOutcome> outcomes(16);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      threads.emplace_back([&, i] {
        outcomes[i] = run_process({.program = program,
                                   .arguments = {std::to_string(i)},
                                   .log = folder.path() / ("log" + std::to_string(i)),
                                   .time_limit = 20},
                                  go_on);
      });
    }
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    EXPECT_EQ(outcomes[i].code, static_cast<int>(i));
}

TEST(Process, TheTailOfAFileIsItsLastLines) {
  const ScratchFolder folder;
  EXPECT_EQ(tail_of(folder.file("a", "1\n2\n3\n\n"), 2), "2\n3");
  EXPECT_EQ(tail_of(folder.file("b", "1\n2"), 5), "1\n2");
  EXPECT_EQ(tail_of(folder.file("c", ""), 5), "");
  EXPECT_EQ(tail_of(folder.path() / "none", 5), "");
  EXPECT_LE(tail_of(folder.file("d", std::string(100000, 'x')), 5).size(), 16384U);
}

TEST(Process, WhatAProgramPrintsCanBeCaptured) {
  const ScratchFolder folder;
  const CapturedOutput output = run_captured(folder.script("program", "echo hello $1"), {"you"}, 5.0, go_on);
  EXPECT_EQ(output.text, "hello you");
  EXPECT_EQ(output.outcome.code, 0);
}

} // namespace
} // namespace settle::compare::test
