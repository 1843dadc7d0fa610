#include <csignal>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/compare/process.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CampaignCommand : public CommandLine {};

TEST_F(CampaignCommand, ARunLeavesReportVerdictsResultsAndCase) {
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 0) << answer.text;
  for (const std::string name : {"report.html", "summary.md", "verdicts.json", "junit.xml", "outcome.json"}) {
    EXPECT_TRUE(std::filesystem::exists(out() / name)) << name;
  }
  for (const std::string name : {"mpm.h5", "mpm.log", "fem.h5", "fem.log", "case.toml"}) {
    EXPECT_TRUE(std::filesystem::exists(out() / "runs" / "column" / name)) << name;
  }
  EXPECT_THAT(answer.text, HasSubstr("report: " + (out() / "report.html").string()));
}

TEST_F(CampaignCommand, ResultsThatAreUpToDateAreUsedAgain) {
  ASSERT_EQ(run_case().code, 0);
  const Answer again = run_case();
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.text, HasSubstr("up to date"));
  EXPECT_EQ(runs_of("mpm"), 1);
  EXPECT_EQ(run_case({"--fresh"}).code, 0);
  EXPECT_EQ(runs_of("mpm"), 2);
}

TEST_F(CampaignCommand, FieldPicturesAreLeftOutOnRequestAndComeBackWithoutARun) {
  const std::string picture = "<figure class=\"fields\"";
  ASSERT_EQ(run_case({"--no-fields"}).code, 0);
  EXPECT_TRUE(content_of(out() / "report.html").find(picture) == std::string::npos);
  ASSERT_EQ(run_case().code, 0);
  EXPECT_TRUE(content_of(out() / "report.html").find(picture) != std::string::npos);
  EXPECT_EQ(runs_of("mpm"), 1);
}

TEST_F(CampaignCommand, AnotherCaseOrAnotherProgramIsRunAgain) {
  ASSERT_EQ(run_case().code, 0);
  EXPECT_EQ(run_case({"--set", "title=another"}).code, 0);
  EXPECT_EQ(runs_of("mpm"), 2);
  play("mpm", "cp " + prepared("mpm").string() + " \"$out\" # a new version");
  EXPECT_EQ(run_case({"--set", "title=another"}).code, 0);
  EXPECT_EQ(runs_of("mpm"), 3);
  EXPECT_EQ(runs_of("fem"), 2);
}

TEST_F(CampaignCommand, AResultOfAnotherProblemFailsItsPhysics) {
  const Answer answer = run_case({"--set", "material.fill.density=1800"}); // the played solvers do not listen
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("density 1720 instead of 1800"));
}

TEST_F(CampaignCommand, ASolverThatIsLeftOutLeavesItsChecksMissing) {
  const Answer answer = run_case({"--solvers", "mpm"});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("missing: column"), HasSubstr("fem was not run")));
}

TEST_F(CampaignCommand, AMatrixIsOneReport) {
  const auto file = folder.file("campaign.toml", R"toml(
format = 1
title = "Two titles"
[[run]]
name = "column {title}"
case = "column.toml"
matrix = { "title" = ["a", "b"] }
)toml");
  const Answer answer = settle({"campaign", file.string(), "--out", out().string(), "-j", "2"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, AllOf(HasSubstr("column a"), HasSubstr("column b"), HasSubstr("[4/4]")));
  EXPECT_TRUE(std::filesystem::exists(out() / "runs" / "column_a" / "mpm.h5"));
  EXPECT_TRUE(std::filesystem::exists(out() / "runs" / "column_b" / "fem.h5"));
}

TEST_F(CampaignCommand, CheckingAgainJudgesWhatIsThere) {
  ASSERT_EQ(run_case().code, 0);
  EXPECT_EQ(settle({"check", out().string()}).code, 0);
  std::filesystem::resize_file(result("fem"), 1000);
  const Answer answer = settle({"check", out().string()});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("unreadable result"));
  EXPECT_EQ(runs_of("fem"), 1);
}

TEST_F(CampaignCommand, AFolderThatWasMovedCanBeCheckedAndReported) {
  ASSERT_EQ(run_case().code, 0);
  const auto elsewhere = folder.path() / "elsewhere";
  std::filesystem::rename(out(), elsewhere);
  std::filesystem::remove(case_file);
  std::filesystem::remove(elsewhere / "report.html");
  EXPECT_EQ(settle({"check", elsewhere.string()}).code, 0);
  EXPECT_EQ(settle({"report", elsewhere.string()}).code, 0);
  EXPECT_TRUE(std::filesystem::exists(elsewhere / "report.html"));
}

TEST_F(CampaignCommand, ResultsThatAreDamagedAreRunAgain) {
  ASSERT_EQ(run_case().code, 0);
  std::filesystem::resize_file(result("mpm"), 1000);
  EXPECT_EQ(run_case().code, 0);
  EXPECT_EQ(runs_of("mpm"), 2);
}

TEST_F(CampaignCommand, CtrlCStopsSolversAndEndsWith130) {
  const auto witness = folder.path() / "survived";
  const auto started = folder.path() / "started";
  play("mpm", "touch " + started.string() + "; sleep 3; touch " + witness.string());
  const std::string commands =
      fmt::format("'{}' run '{}' --out '{}' & settle=$!\nwhile [ ! -e {} ]; do sleep 0.05; done\n"
                  "kill -TERM $settle; wait $settle",
                  SETTLE_PROGRAM, case_file.string(), out().string(), started.string());
  const auto shell = folder.script("interrupt", commands);
  const Answer answer = run_program(shell, {});
  EXPECT_EQ(answer.code, 130);
  EXPECT_THAT(answer.text, HasSubstr("interrupted"));
  std::this_thread::sleep_for(std::chrono::milliseconds(3500));
  EXPECT_FALSE(std::filesystem::exists(witness));
}

TEST_F(CampaignCommand, VerdictsForMachinesAgreeWithTheExitCode) {
  ASSERT_EQ(run_case().code, 0);
  EXPECT_TRUE(nlohmann::json::accept(content_of(out() / "verdicts.json")));
  EXPECT_THAT(content_of(out() / "verdicts.json"), HasSubstr("\"passed\""));
}

} // namespace
} // namespace settle::compare::test
