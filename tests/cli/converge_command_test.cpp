#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// Where the first verdict on a family says that the case expects it.
std::string place_of_convergence(const nlohmann::json& verdicts) {
  for (const auto& verdict : verdicts.at("verdicts")) {
    if (verdict.at("kind") == "convergence") return verdict.at("where");
  }
  return "no verdict on a family";
}

/// The played solvers hand over the exact solution on every level: errors are round-off.
class ConvergeCommand : public CommandLine {
protected:
  ConvergeCommand() {
    study.converge.emplace();
    study.converge->element_size = {0.5, 0.25, 0.125};
    expect("mpm", exchange::Convergence::floor_limited);
    expect("fem", exchange::Convergence::floor_limited);
    write();
  }
  void expect(const std::string& solver, exchange::Convergence verdict) {
    exchange::ExpectedConvergence expected;
    expected.solver = solver;
    expected.verdict = verdict;
    if (verdict == exchange::Convergence::converging) expected.order = 1.0;
    study.converge->expectations.push_back(expected);
  }
  void write() { case_file = folder.file("column.toml", exchange::to_toml(study)); }
  [[nodiscard]] Answer converge(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"converge", case_file.string(), "--out", out().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return settle(arguments);
  }
  /// Refused with exit code 2, nothing run, nothing written.
  void expect_refused(const std::vector<std::string>& more, const testing::Matcher<const std::string&>& message) const {
    const Answer answer = converge(more);
    EXPECT_EQ(answer.code, 2) << answer.text;
    EXPECT_THAT(answer.text, message);
    EXPECT_EQ(runs_of("mpm") + runs_of("fem"), 0);
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
};

TEST_F(ConvergeCommand, RunsEveryLevelWithBothSolversAndSaysWhatItFinds) {
  const Answer answer = converge({"-j", "2"});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_EQ(runs_of("mpm"), 3);
  EXPECT_EQ(runs_of("fem"), 3);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("[6/6]"), HasSubstr("element size [m]"), HasSubstr("0.125"),
                                 HasSubstr("floor-limited"), HasSubstr("expected: floor-limited")));
  EXPECT_THAT(content_of(out() / "report.html"), HasSubstr("id=\"family-1-column\""));
  EXPECT_THAT(content_of(out() / "summary.md"), HasSubstr("## Convergence of column"));
  EXPECT_THAT(content_of(out() / "junit.xml"), HasSubstr("column.convergence"));
}

TEST_F(ConvergeCommand, AnotherVerdictThanExpectedIsExitCodeOne) {
  study.converge->expectations.clear();
  expect("mpm", exchange::Convergence::converging);
  write();
  const Answer answer = converge();
  EXPECT_EQ(answer.code, 1) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("failed: column: settlement, mpm - exact, l2 over points: converging at order 1"));
  EXPECT_EQ(runs_of("fem"), 0); // nothing is expected of it
  const auto verdicts = nlohmann::json::parse(content_of(out() / "verdicts.json"));
  EXPECT_EQ(verdicts["status"], "failed");
  const std::string place = place_of_convergence(verdicts);
  EXPECT_THAT(place, ContainsRegex("column[.]toml:[0-9]+:[0-9]+$"));
  const Answer again = settle({"check", out().string(), "--format", "json"});
  EXPECT_EQ(place_of_convergence(nlohmann::json::parse(again.text)), place);
}

TEST_F(ConvergeCommand, ASolverOfWhichNothingIsExpectedIsMissing) {
  study.converge->expectations.resize(1);
  write();
  const Answer answer = converge({"--solvers", "mpm,fem"});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("the case does not say what it expects of fem"));
}

TEST_F(ConvergeCommand, ASolverThatFailsOnALevelIsExitCodeThree) {
  play("mpm", "exit 3");
  EXPECT_EQ(converge().code, 3);
}

TEST_F(ConvergeCommand, UsesLevelsThatAreUpToDateAndCanBeCheckedAgain) {
  ASSERT_EQ(converge().code, 0);
  EXPECT_EQ(converge().code, 0);
  EXPECT_EQ(runs_of("mpm"), 3);
  EXPECT_EQ(settle({"check", out().string()}).code, 0);
  std::filesystem::remove(out() / "runs" / "column_level_2" / "mpm.h5");
  EXPECT_EQ(settle({"check", out().string()}).code, 4);
}

TEST_F(ConvergeCommand, AFamilyCanBePartOfACampaign) {
  const auto file = folder.file("campaign.toml", R"toml(
format = 1
title = "A family and a run"
[[run]]
name = "levels of {construction.convention}"
case = "column.toml"
converge = true
matrix = { "construction.convention" = ["refill"] }
[[run]]
name = "alone"
case = "column.toml"
)toml");
  const Answer answer = settle({"campaign", file.string(), "--out", out().string()});
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text, AllOf(HasSubstr("levels of refill level 3"), HasSubstr("alone"), HasSubstr("[8/8]")));
}

TEST_F(ConvergeCommand, RefusesFewerThanThreeLevels) {
  expect_refused({"--set", "converge.element_size=[0.5]"}, HasSubstr("an array of at least 3"));
}

TEST_F(ConvergeCommand, RefusesLevelsThatDoNotBecomeFiner) {
  expect_refused({"--set", "converge.element_size=[0.25, 0.25, 0.125]"}, HasSubstr("does not become smaller"));
  expect_refused({"--set", "converge.size=layer-thickness"}, HasSubstr("level 2 is not finer than level 1"));
}

TEST_F(ConvergeCommand, RefusesAnUnknownQuantity) {
  expect_refused({"--set", "converge.expect.0.quantity=settlements"}, HasSubstr("did you mean settlement?"));
}

TEST_F(ConvergeCommand, RefusesACaseWithoutLevels) {
  study.converge.reset();
  write();
  expect_refused({}, HasSubstr("the case has no table [converge]"));
}

TEST_F(ConvergeCommand, RefusesSizesThatASolverCannotUse) {
  const std::string refuses = "for word in \"$@\"; do [ \"$word\" = --check ] && echo 'does not fit' && exit 2; done\n";
  const auto script = folder.script("picky", refuses);
  setenv("SETTLE_MPM", script.c_str(), 1);
  expect_refused({}, HasSubstr("does not fit"));
}

} // namespace
} // namespace settle::compare::test
