#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A campaign of two runs whose parts are asked for one by one, as a scheduler does.
class SingleRun : public CommandLine {
protected:
  SingleRun()
      : file(folder.file("campaign.toml", "format = 1\n[[run]]\nname = \"column {title}\"\ncase = \"column.toml\"\n"
                                          "matrix = { title = [\"a\", \"b\"] }\n")) {}
  [[nodiscard]] Answer campaign(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"campaign", file.string(), "--out", out().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return settle(arguments);
  }
  [[nodiscard]] Answer only(const std::string& title) const { return campaign({"--only-run", title}); }
  [[nodiscard]] fs::path run(const std::string& letter) const { return out() / "runs" / ("column_" + letter); }

  fs::path file;
};

TEST_F(SingleRun, RunsNothingElseAndIsUpToDateForTheCampaign) {
  const Answer answer = only("column b, mpm");
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("column b, mpm: finished"));
  EXPECT_TRUE(fs::exists(run("b") / "mpm.h5"));
  EXPECT_FALSE(fs::exists(run("a")));
  EXPECT_FALSE(fs::exists(out() / "report.html"));
  EXPECT_THAT(only("column b, mpm").text, HasSubstr("up to date"));
  EXPECT_EQ(campaign({}).code, 0);
  EXPECT_EQ(runs_of("mpm"), 2);
}

TEST_F(SingleRun, ThatFailsSaysSoAndIsJudgedLikeAFailureOfTheCampaign) {
  play("mpm", "case \"$out\" in *column_b*) echo the last words; exit 3 ;; esac; cp " + prepared("mpm").string() +
                  " \"$out\"");
  for (const std::string title : {"column a, mpm", "column a, fem", "column b, fem"})
    ASSERT_EQ(only(title).code, 0);
  const Answer failed = only("column b, mpm");
  EXPECT_EQ(failed.code, 3);
  EXPECT_THAT(failed.text, AllOf(HasSubstr("not converged"), HasSubstr("the last words")));
  const Answer judged = campaign({"--judge-only"});
  EXPECT_EQ(judged.code, 3);
  EXPECT_EQ(runs_of("mpm"), 2);
  const fs::path by_parts = folder.path() / "by-parts";
  fs::rename(out(), by_parts);
  const Answer whole = campaign({});
  EXPECT_EQ(whole.code, 3);
  const auto verdicts = [](const fs::path& folder_of_it) {
    auto all = nlohmann::json::parse(content_of(folder_of_it / "verdicts.json"));
    all.erase("created");
    return all;
  };
  EXPECT_EQ(verdicts(by_parts), verdicts(out()));
}

TEST_F(SingleRun, ThatIsMissingIsAVerdictWhereOnlyJudged) {
  ASSERT_EQ(only("column a, mpm").code, 0);
  const Answer judged = campaign({"--judge-only"});
  EXPECT_EQ(judged.code, 4);
  EXPECT_THAT(judged.text, AllOf(HasSubstr("mpm no result"), HasSubstr("it has not been run")));
  EXPECT_EQ(runs_of("fem"), 0);
  EXPECT_EQ(campaign({}).code, 0);
}

TEST_F(SingleRun, ThatThereIsNotIsRefusedWithTheNearest) {
  const Answer answer = only("column a, mmp");
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, HasSubstr("did you mean column a, mpm?"));
  EXPECT_EQ(campaign({"--only-run", "column a, mpm", "--judge-only"}).code, 2);
}

TEST_F(SingleRun, KeepsACampaignOutOfTheFolderAndLetsOthersIn) {
  const fs::path started = folder.path() / "started";
  play("mpm", "touch " + started.string() + "; sleep 2; cp " + prepared("mpm").string() + " \"$out\"");
  const std::string command =
      fmt::format("'{}' campaign '{}' --out '{}'", SETTLE_PROGRAM, file.string(), out().string());
  const auto shell = folder.script(
      "both",
      fmt::format("{0} --only-run 'column a, mpm' & first=$!\nwhile [ ! -e {1} ]; do sleep 0.05; done\n"
                  "{0}; echo refused $?\n{0} --only-run 'column b, fem'; echo beside $?\nwait $first; echo first $?",
                  command, started.string()));
  EXPECT_THAT(run_program(shell, {}).text, AllOf(HasSubstr("single runs of this campaign are at work"),
                                                 HasSubstr("refused 2"), HasSubstr("beside 0"), HasSubstr("first 0")));
}

TEST_F(SingleRun, SlurmThatIsNotThereIsSaid) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const Answer answer = campaign({"--executor", "slurm"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("there is no Slurm on this machine"), HasSubstr("leave --executor out")));
  EXPECT_EQ(runs_of("mpm"), 0);
}

TEST_F(SingleRun, OptionsThatSlurmMayNotHaveAreRefused) {
  EXPECT_THAT(campaign({"--executor", "slurm", "--slurm-option=--array=0-3"}).text,
              AllOf(HasSubstr("settle sets this option"), HasSubstr("--slurm-option")));
  EXPECT_THAT(campaign({"--executor", "slurm", "--slurm-option=short"}).text, HasSubstr("this is no option of sbatch"));
  EXPECT_EQ(campaign({"--slurm-option=--partition=short"}).code, 2); // without Slurm
  std::ofstream(file, std::ios::app) << "\n";
  (void)folder.file("campaign.toml", "slurm_options = [\"--wrap=true\"]\n" + content_of(file));
  const Answer answer = campaign({"--executor", "slurm"});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, HasSubstr("campaign.toml, slurm_options: settle sets this option"));
}

TEST_F(SingleRun, OfAShardIsFoundInItByTheCostsOfAnEarlierCampaign) {
  ASSERT_EQ(campaign({}).code, 0);
  const fs::path costs = folder.path() / "costs.json";
  fs::copy_file(out() / "outcome.json", costs);
  EXPECT_EQ(campaign({"--shard", "1/2", "--costs", costs.string(), "--dry-run"}).code, 0);
  EXPECT_EQ(campaign({"--costs", costs.string()}).code, 2); // of no shard
  std::ofstream(costs) << "{}";
  const Answer answer = campaign({"--shard", "1/2", "--costs", costs.string()});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("this is no outcome of a campaign"));
}

} // namespace
} // namespace settle::compare::test
