#include <algorithm>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// A campaign of three runs, of which nothing has run yet.
class CampaignEngine : public CommandLine {
protected:
  CampaignEngine()
      : file(folder.file("campaign.toml", "format = 1\ntitle = \"Letters\"\n[[run]]\nname = \"column {title}\"\n"
                                          "case = \"column.toml\"\nmatrix = { title = [\"a\", \"b\", \"c\"] }\n")) {}

  [[nodiscard]] Answer campaign(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"campaign", file.string(), "--out", out().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return settle(arguments);
  }
  [[nodiscard]] fs::path run(const std::string& letter) const { return out() / "runs" / ("column_" + letter); }

  fs::path file;
};

TEST_F(CampaignEngine, ADryRunSaysWhatItWouldRunAndWritesNothing) {
  const Answer answer = campaign({"--dry-run"});
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("column a, mpm: new\n"), HasSubstr("column c, fem: new\n"),
                                 HasSubstr("6 of 6 solver runs to do, 0 up to date")));
  EXPECT_FALSE(fs::exists(out()));
  EXPECT_EQ(runs_of("mpm"), 0);
}

TEST_F(CampaignEngine, ADryRunSaysWhy) {
  ASSERT_EQ(campaign().code, 0);
  EXPECT_THAT(campaign({"--dry-run"}).text, HasSubstr("0 of 6 solver runs to do, 6 up to date"));
  EXPECT_THAT(campaign({"--dry-run", "--fresh"}).text, HasSubstr("column a, fem: forced"));
  fs::resize_file(run("a") / "mpm.h5", 1000);
  play("fem", "cp " + prepared("fem").string() + " \"$out\" # a new version");
  const std::string text = campaign({"--dry-run"}).text;
  EXPECT_THAT(text, AllOf(HasSubstr("column a, mpm: result damaged"), HasSubstr("column b, fem: solver changed"),
                          Not(HasSubstr("column b, mpm")), HasSubstr("4 of 6")));
}

TEST_F(CampaignEngine, ADryRunSeesAChangedCase) {
  ASSERT_EQ(campaign().code, 0);
  study.probes["axis"].points_per_layer = 5;
  std::ofstream(case_file) << exchange::to_toml(study);
  EXPECT_THAT(campaign({"--dry-run"}).text, AllOf(HasSubstr("column b, mpm: case changed"), HasSubstr("6 of 6")));
}

TEST_F(CampaignEngine, AFinishedCampaignHasNothingToRunAndSaysTheSameAgain) {
  const Answer first = campaign();
  ASSERT_EQ(first.code, 0);
  const auto written = fs::last_write_time(out() / "report.html");
  const Answer second = campaign();
  EXPECT_EQ(second.code, 0);
  EXPECT_THAT(second.text, AllOf(HasSubstr("nothing to run"), ContainsRegex("column b +[0-9]+ ")));
  EXPECT_EQ(fs::last_write_time(out() / "report.html"), written);
  EXPECT_EQ(runs_of("mpm"), 3);
}

TEST_F(CampaignEngine, NoMoreSolversRunAtATimeThanAskedForWhileOthersAreJudged) {
  const std::string running = (folder.path() / "running").string(), counts = (folder.path() / "counts").string();
  for (const std::string solver : {"mpm", "fem"})
    play(solver, fmt::format("mkdir -p {0}; touch {0}/$$; ls {0} | wc -l >> {1}; sleep 0.1\ncp {2} \"$out\"; rm {0}/$$",
                             running, counts, prepared(solver).string()));
  for (const int jobs : {1, 2}) {
    fs::remove(counts);
    ASSERT_EQ(campaign({"--fresh", "-j", std::to_string(jobs)}).code, 0);
    std::ifstream lines(counts);
    const std::vector<int> at_a_time{std::istream_iterator<int>(lines), {}};
    ASSERT_EQ(at_a_time.size(), 6U);
    EXPECT_LE(*std::max_element(at_a_time.begin(), at_a_time.end()), jobs);
  }
}

TEST_F(CampaignEngine, AFinishedCampaignThatHasNotPassedEndsInTheSameExitCodeAgain) {
  const auto failing = [&] {
    return settle({"run", case_file.string(), "--set", "material.fill.density=1800", "--out", out().string()});
  };
  ASSERT_EQ(failing().code, 1); // the played solvers do not listen
  const Answer second = failing();
  EXPECT_EQ(second.code, 1);
  EXPECT_THAT(second.text, AllOf(HasSubstr("nothing to run"), HasSubstr("density 1720 instead of 1800")));
}

TEST_F(CampaignEngine, AReportThatIsGoneIsWrittenAgainWithoutRunning) {
  ASSERT_EQ(campaign().code, 0);
  fs::remove(out() / "junit.xml");
  EXPECT_EQ(campaign().code, 0);
  EXPECT_TRUE(fs::exists(out() / "junit.xml"));
  EXPECT_EQ(runs_of("mpm"), 3);
}

TEST_F(CampaignEngine, ACampaignThatHasChangedIsJudgedAgainWithoutRunning) {
  ASSERT_EQ(campaign().code, 0);
  std::ofstream(file, std::ios::app) << "note = \"another note\"\n";
  EXPECT_THAT(campaign().text, Not(HasSubstr("nothing to run")));
  EXPECT_THAT(content_of(out() / "report.html"), HasSubstr("another note"));
  EXPECT_EQ(runs_of("mpm"), 3);
}

TEST_F(CampaignEngine, AnInterruptedCampaignLeavesNoReportOfAnEarlierState) {
  ASSERT_EQ(campaign().code, 0);
  play("mpm", "kill -KILL $PPID; sleep 5");
  const auto shell = folder.script(
      "killed", fmt::format("'{}' campaign '{}' --out '{}'; true", SETTLE_PROGRAM, file.string(), out().string()));
  run_program(shell, {});
  for (const std::string name : {"outcome.json", "verdicts.json", "junit.xml", "report.html", "finished.json"}) {
    EXPECT_FALSE(fs::exists(out() / name)) << name;
  }
  play_perfect("mpm");
  EXPECT_EQ(campaign().code, 0);
}

TEST_F(CampaignEngine, TwoCampaignsInOneFolderAreKeptApart) {
  fs::create_directories(out());
  const int held = open((out() / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  const std::string holder = fmt::format("{} 1 elsewhere 2026-01-02T03:04:05Z\n", getpid());
  ASSERT_EQ(write(held, holder.data(), holder.size()), static_cast<ssize_t>(holder.size()));
  const Answer refused = campaign();
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.text, AllOf(HasSubstr("another campaign is at work"), HasSubstr(std::to_string(getpid())),
                                  HasSubstr("on elsewhere"), HasSubstr("since 2026-01-02T03:04:05Z")));
  EXPECT_EQ(runs_of("mpm"), 0);
  close(held);
  EXPECT_EQ(campaign().code, 0);
}

TEST_F(CampaignEngine, WhatAKilledCampaignHasLeftRunningIsEndedByTheNext) {
  const auto survivor = folder.path() / "survivor";
  // The grandchild leaves the group and outlives its parents, with the lock.
  play("mpm",
       fmt::format("setsid sh -c 'sleep 3; touch {}' & sleep 0.2; kill -KILL $PPID; sleep 5", survivor.string()));
  const auto shell = folder.script(
      "killed", fmt::format("'{}' campaign '{}' --out '{}' -j 1; true", SETTLE_PROGRAM, file.string(), out().string()));
  run_program(shell, {});
  play_perfect("mpm");
  const Answer answer = campaign();
  EXPECT_EQ(answer.code, 0) << answer.text;
  sleep(4);
  EXPECT_FALSE(fs::exists(survivor));
}

TEST_F(CampaignEngine, ProgressForProgramsIsOneJsonObjectALine) {
  const auto shell = folder.script("json", fmt::format("'{}' campaign '{}' --out '{}' --progress json 2>/dev/null",
                                                       SETTLE_PROGRAM, file.string(), out().string()));
  std::istringstream lines(run_program(shell, {}).text);
  std::map<std::string, int> events;
  json last;
  for (std::string line; std::getline(lines, line); ++events[last.at("event").get<std::string>()])
    last = json::parse(line);
  EXPECT_EQ(events, (std::map<std::string, int>{{"started", 6}, {"ended", 6}, {"campaign ended", 1}}));
  EXPECT_EQ(last.at("exit_code"), 0);
  EXPECT_EQ(last.at("report"), (out() / "report.html").string());
}

TEST_F(CampaignEngine, TheEndOfASolverRunTellsStatusAndCost) {
  play("mpm", "exit 3");
  std::istringstream lines(campaign({"--progress", "json", "--shard", "1/3"}).text);
  json ended;
  for (std::string line; std::getline(lines, line);) {
    const json event = json::parse(line);
    if (event.at("event") == "ended" && event.at("solver") == "mpm") ended = event;
  }
  EXPECT_EQ(ended.at("run"), "column a");
  EXPECT_EQ(ended.at("status"), "not converged");
  EXPECT_EQ(ended.at("reason"), "new");
  EXPECT_GT(ended.at("wall_time"), 0.0);
  EXPECT_EQ(ended.at("total"), 2);
}

TEST_F(CampaignEngine, APlanForProgramsNamesEveryTask) {
  std::istringstream lines(campaign({"--progress", "json", "--dry-run"}).text);
  int planned = 0;
  for (std::string line; std::getline(lines, line); ++planned)
    EXPECT_EQ(json::parse(line).at("reason"), "new");
  EXPECT_EQ(planned, 6);
}

TEST_F(CampaignEngine, OnATerminalTheLineHasABar) {
  EXPECT_THAT(campaign({"--progress", "line"}).text,
              AllOf(HasSubstr("[----------"), HasSubstr("0/6: column a, mpm"), HasSubstr("left")));
}

TEST_F(CampaignEngine, AShardRunsItsPartAndSaysSo) {
  const Answer answer = campaign({"--shard", "2/3"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_EQ(runs_of("mpm"), 1);
  EXPECT_TRUE(fs::exists(run("b")));
  EXPECT_THAT(content_of(out() / "report.html"), HasSubstr("shard 2 of 3"));
  EXPECT_EQ(campaign().code, 0); // in the same folder: the rest
  EXPECT_EQ(runs_of("mpm"), 3);
}

TEST_F(CampaignEngine, AShardThatIsNoneIsRefused) {
  EXPECT_EQ(campaign({"--shard", "4/3"}).code, 2);
  EXPECT_EQ(campaign({"--shard", "4/4"}).code, 2);
}

} // namespace
} // namespace settle::compare::test
