/// \file
/// Campaigns by a real Slurm, which `with_slurm` brings up around these tests.

#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double patience = 120.0; ///< with a Slurm on a busy machine [s]

/// The verdicts without provenance.
json verdicts_in(const fs::path& folder) {
  json verdicts = json::parse(content_of(folder / "verdicts.json"));
  for (const char* provenance : {"created", "commit", "program_version"})
    verdicts.erase(provenance);
  return verdicts;
}

/// A campaign of runs that differ by their title: "run 1", "run 2", ...
class SlurmCampaign : public CommandLine {
protected:
  void SetUp() override {
    if (std::getenv("SLURM_CONF") == nullptr) GTEST_SKIP() << "run by with_slurm";
  }
  [[nodiscard]] fs::path campaign_of(int runs, const std::string& more = "", const std::string& solvers = "") const {
    std::string titles;
    for (int i = 1; i <= runs; ++i)
      titles += fmt::format("{}\"{}\"", i > 1 ? ", " : "", i);
    return folder.file("campaign.toml", fmt::format("format = 1\ntitle = \"Many\"\n[[run]]\nname = \"run {{title}}\"\n"
                                                    "case = \"column.toml\"\nmatrix = {{ title = [{}] }}\n{}\n{}\n",
                                                    titles, solvers, more));
  }
  [[nodiscard]] std::vector<std::string> words(const fs::path& campaign, const fs::path& to,
                                               const std::vector<std::string>& more) const {
    std::vector<std::string> words{"campaign", campaign.string(), "--out", to.string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] Answer by_slurm(const fs::path& campaign, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = words(campaign, out(), more);
    arguments.insert(arguments.end(), {"--executor", "slurm"});
    return run_program(SETTLE_PROGRAM, arguments, patience);
  }
  /// The same, ended by a signal as soon as everything is submitted.
  [[nodiscard]] Answer left_alone(const fs::path& campaign, const std::string& signal) const {
    const auto shell = folder.script(
        "leave",
        fmt::format("'{0}' campaign '{1}' --out '{2}' --executor slurm & settle=$!\n"
                    "while ! grep -q '\"judge_id\": \"[0-9]' '{2}/slurm/submission.json'; do sleep 0.05; done\n"
                    "sleep 0.3; kill -{3} $settle; wait $settle",
                    SETTLE_PROGRAM, campaign.string(), out().string(), signal));
    return run_program(shell, {}, patience);
  }
  /// What a campaign's runs have ended with: "run 1, mpm" -> "crashed".
  [[nodiscard]] std::map<std::string, std::string> ends() const {
    std::map<std::string, std::string> found;
    const json outcome = json::parse(content_of(out() / "outcome.json"));
    for (const json& run : outcome.at("runs"))
      for (const json& solver : run.at("solvers"))
        found[run.at("name").get<std::string>() + ", " + solver.at("solver").get<std::string>()] =
            solver.at("status_name");
    return found;
  }
};

TEST_F(SlurmCampaign, TwentyFourRunsOfWhichOneFailsAreJudgedAsLocalOnesAre) {
  play("mpm",
       "case \"$out\" in */run_7/*) echo the last words; exit 3 ;; esac\ncp " + prepared("mpm").string() + " \"$out\"");
  const fs::path campaign = campaign_of(24, "", "solvers = [\"mpm\"]");
  const fs::path here = folder.path() / "here";
  const Answer local = run_program(SETTLE_PROGRAM, words(campaign, here, {}), patience);
  const int of_local = runs_of("mpm");
  const Answer answer = by_slurm(campaign, {"--slurm-limit", "4"});
  EXPECT_EQ(answer.code, local.code) << answer.text;
  EXPECT_EQ(answer.code, 3);
  EXPECT_EQ(runs_of("mpm"), 2 * of_local);
  EXPECT_EQ(verdicts_in(out()), verdicts_in(here));
  EXPECT_THAT(answer.text, AllOf(HasSubstr("[24/24]"), HasSubstr("run 7, mpm: not converged"),
                                 HasSubstr("the last words"), HasSubstr("report: ")));
  EXPECT_FALSE(fs::exists(out() / "slurm" / "submission.json")) << "its end has been shown";
  EXPECT_EQ(settle({"check", out().string()}).code, 3);
  play_perfect("mpm"); // another program: everything again, on this machine
  EXPECT_EQ(run_program(SETTLE_PROGRAM, words(campaign, out(), {}), patience).code, 4); // fem was not run
}

TEST_F(SlurmCampaign, GoesOnWhenTheShellIsClosedAndIsNotSubmittedTwice) {
  play("mpm", "sleep 1; cp " + prepared("mpm").string() + " \"$out\"");
  const fs::path campaign = campaign_of(4);
  EXPECT_NE(left_alone(campaign, "KILL").code, 0);
  const Answer again = by_slurm(campaign);
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_THAT(again.text, HasSubstr("[8/8]"));
  EXPECT_EQ(runs_of("mpm"), 4);
  EXPECT_EQ(runs_of("fem"), 4);
  EXPECT_THAT(by_slurm(campaign).text, HasSubstr("nothing to run"));
}

TEST_F(SlurmCampaign, WhatWasSubmittedAndNotNotedIsFoundByItsName) {
  play("mpm", "sleep 2; cp " + prepared("mpm").string() + " \"$out\"");
  const fs::path campaign = campaign_of(2);
  EXPECT_NE(left_alone(campaign, "KILL").code, 0);
  const fs::path note = out() / "slurm" / "submission.json";
  json changed = json::parse(content_of(note)); // as a kill between submitting and noting would leave it
  changed["judge_id"] = "";
  changed["arrays"][0]["id"] = "";
  std::ofstream(note) << changed;
  const Answer again = by_slurm(campaign);
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_EQ(runs_of("mpm"), 2);
}

TEST_F(SlurmCampaign, InterruptedSaysHowItIsEndedAndIsFoundDoneLater) {
  play("mpm", "sleep 1; exit 3");
  const fs::path campaign = campaign_of(1);
  const Answer left = left_alone(campaign, "TERM");
  EXPECT_EQ(left.code, 130);
  EXPECT_THAT(left.text, AllOf(HasSubstr("the runs go on in Slurm"), HasSubstr("scancel ")));
  const Answer local = run_program(SETTLE_PROGRAM, words(campaign, out(), {}), patience);
  EXPECT_EQ(local.code, 2);
  EXPECT_THAT(local.text, HasSubstr("with Slurm"));
  const auto wait = folder.script("wait", "while [ -n \"$(squeue --me --noheader)\" ]; do sleep 0.1; done");
  ASSERT_EQ(run_program(wait, {}, patience).code, 0);
  const Answer later = by_slurm(campaign); // the failed run is not run again before somebody has seen its end
  EXPECT_EQ(later.code, 3) << later.text;
  EXPECT_EQ(runs_of("mpm"), 1);
  EXPECT_EQ(by_slurm(campaign).code, 3);
  EXPECT_EQ(runs_of("mpm"), 2);
}

TEST_F(SlurmCampaign, LimitsAndCancelledJobsAreTheVerdictsOfLocalOnes) {
  const std::string job = "${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}";
  play("mpm", "case \"$out\" in\n */run_1/*) sleep 60 ;;\n */run_2/*) scancel " + job +
                  "; sleep 60 ;;\n */greedy/*) x=x; while :; do x=$x$x; done ;;\nesac\ncp " + prepared("mpm").string() +
                  " \"$out\"");
  const fs::path campaign =
      campaign_of(3, "time_limit = 2\nsolvers = [\"mpm\"]\n[[run]]\nname = \"greedy\"\ncase = \"column.toml\"\n"
                     "memory_limit = 60e6\nsolvers = [\"mpm\"]\n");
  const Answer answer = by_slurm(campaign);
  EXPECT_EQ(answer.code, 3) << answer.text;
  const std::map<std::string, std::string> expected{{"run 1, mpm", "timed out"},
                                                    {"run 2, mpm", "crashed"},
                                                    {"run 3, mpm", "finished"},
                                                    {"greedy, mpm", "out of memory"}};
  EXPECT_EQ(ends(), expected);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("Slurm has ended its job"), HasSubstr("CANCELLED")));
}

TEST_F(SlurmCampaign, IsJudgedHereWhereTheJobThatJudgesIsEnded) {
  play("mpm", "sleep 1; cp " + prepared("mpm").string() + " \"$out\"");
  const fs::path campaign = campaign_of(1);
  EXPECT_NE(left_alone(campaign, "KILL").code, 0);
  const std::string judge = json::parse(content_of(out() / "slurm" / "submission.json")).at("judge_id");
  const auto cancel = folder.script("cancel", "scancel " + judge);
  ASSERT_EQ(run_program(cancel, {}, patience).code, 0);
  const auto wait = folder.script("wait", "while [ -n \"$(squeue --me --noheader)\" ]; do sleep 0.1; done");
  ASSERT_EQ(run_program(wait, {}, patience).code, 0);
  const Answer answer = by_slurm(campaign);
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_TRUE(fs::exists(out() / "report.html"));
  EXPECT_EQ(runs_of("mpm"), 1);
}

TEST_F(SlurmCampaign, IsNotMixedWithWhatItWasWhenItWasSubmitted) {
  play("mpm", "sleep 3; cp " + prepared("mpm").string() + " \"$out\"");
  EXPECT_NE(left_alone(campaign_of(1), "KILL").code, 0);
  const Answer other = by_slurm(campaign_of(2));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.text, AllOf(HasSubstr("as it was are with Slurm"), HasSubstr("scancel")));
  const auto end = folder.script("end", "scancel --me; while [ -n \"$(squeue --me --noheader)\" ]; do sleep 0.1; done");
  ASSERT_EQ(run_program(end, {}, patience).code, 0);
  play_perfect("mpm");
  const Answer now = by_slurm(campaign_of(2));
  EXPECT_EQ(now.code, 0) << now.text;
}

TEST_F(SlurmCampaign, ThatCannotStartSaysWhy) {
  const fs::path log = folder.path() / "log";
  const auto shell = folder.script(
      "follow",
      fmt::format("'{}' campaign '{}' --out '{}' --executor slurm --slurm-option=--partition=brief 2> {} & "
                  "settle=$!\nfor i in $(seq 300); do grep -q 'jobs wait' {} && break; sleep 0.1; done\n"
                  "kill -TERM $settle; wait $settle; code=$?; scancel --me; cat {}; exit $code",
                  SETTLE_PROGRAM, campaign_of(1).string(), out().string(), log.string(), log.string(), log.string()));
  const Answer answer = run_program(shell, {}, patience); // 11 minutes in a partition that gives one
  EXPECT_EQ(answer.code, 130);
  EXPECT_THAT(answer.text, HasSubstr("with Slurm: jobs wait: Partition"));
}

TEST_F(SlurmCampaign, WhatSlurmRefusesIsSaidAsItSaysIt) {
  const Answer answer = by_slurm(campaign_of(1), {"--slurm-option=--partition=nope"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("Slurm does not take the job"), HasSubstr("nope")));
  EXPECT_EQ(runs_of("mpm"), 0);
  EXPECT_FALSE(fs::exists(out() / "slurm" / "submission.json"));
  EXPECT_EQ(by_slurm(campaign_of(1), {"--slurm-option=--partition=test"}).code, 0);
}

TEST_F(SlurmCampaign, TheCampaignMayHoldOptionsForSlurm) {
  const fs::path campaign = campaign_of(1);
  const std::string text = content_of(campaign);
  (void)folder.file("campaign.toml", "slurm_options = [\"--partition=nope\"]\n" + text);
  EXPECT_EQ(by_slurm(campaign).code, 2);
  EXPECT_EQ(by_slurm(campaign, {"--slurm-option=--partition=test"}).code, 0); // the command line's counts
}

} // namespace
} // namespace settle::compare::test
