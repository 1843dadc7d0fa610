#include <gmock/gmock.h>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class WrongInput : public CommandLine {
protected:
  /// Refused with exit code 2, nothing run, nothing written.
  void expect_refused(const std::vector<std::string>& more, const testing::Matcher<const std::string&>& message) const {
    const Answer answer = run_case(more);
    EXPECT_EQ(answer.code, 2) << answer.text;
    EXPECT_THAT(answer.text, message);
    EXPECT_EQ(runs_of("mpm") + runs_of("fem"), 0);
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
};

TEST_F(WrongInput, UnknownKeysWrongTypesAndRangesAreRefused) {
  expect_refused({"--set", "material.fill.youngs_modulos=1e5"}, HasSubstr("did you mean youngs_modulus?"));
  expect_refused({"--set", "construction.layers=many"}, HasSubstr("construction.layers"));
  expect_refused({"--set", "material.fill.youngs_modulus=-400e3"}, HasSubstr("-400000"));
  expect_refused({"--set", "material.fill.poissons_ratio=0.5"}, HasSubstr("0.5"));
  expect_refused({"--set", "construction.convention=refil"}, HasSubstr("did you mean refill?"));
}

TEST_F(WrongInput, OverridesNeedAKeyAndAValue) {
  expect_refused({"--set", "construction.layers"}, HasSubstr("key=value"));
}

TEST_F(WrongInput, UnknownSolversAndOptionsAreUsageErrors) {
  expect_refused({"--solvers", "mpm,abaqus"}, HasSubstr("abaqus"));
  expect_refused({"--frash"}, HasSubstr("frash"));
  expect_refused({"-j", "0"}, HasSubstr("jobs"));
}

TEST_F(WrongInput, NoOrUnknownCommandsAreUsageErrors) {
  EXPECT_EQ(settle({}).code, 2);
  EXPECT_EQ(settle({"settle"}).code, 2);
  EXPECT_EQ(settle({"run"}).code, 2);
}

TEST_F(WrongInput, ACaseThatIsNotThereIsRefused) {
  const Answer answer = settle({"run", "/nowhere/case.toml", "--out", out().string()});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, HasSubstr("/nowhere/case.toml"));
}

TEST_F(WrongInput, AFolderThatCannotBeWrittenIsExitCodeFour) {
  const auto file = folder.file("occupied", "a file, not a folder");
  const Answer answer = settle({"run", case_file.string(), "--out", (file / "out").string()});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("occupied"), HasSubstr("--out")));
  EXPECT_EQ(content_of(file), "a file, not a folder");
  EXPECT_EQ(runs_of("mpm"), 0);
}

TEST_F(WrongInput, CampaignMistakesNameFileAndLine) {
  const auto file = folder.file("campaign.toml", "format = 1\n[[run]]\nname = \"a\"\ncsae = \"column.toml\"\n");
  const Answer answer = settle({"campaign", file.string(), "--out", out().string()});
  EXPECT_EQ(answer.code, 2);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("campaign.toml:4:1"), HasSubstr("did you mean case?")));
}

TEST_F(WrongInput, AFolderWithoutAnOutcomeCannotBeChecked) {
  for (const std::string command : {"check", "report"}) {
    EXPECT_EQ(settle({command, folder.path().string()}).code, 4);
  }
  const auto damaged = folder.file("outcome.json", "{\"version\": 1}");
  EXPECT_EQ(settle({"check", folder.path().string()}).code, 4);
  EXPECT_EQ(content_of(damaged), "{\"version\": 1}");
}

TEST_F(WrongInput, ASlipInTheCaseDoesNotTouchEarlierResults) {
  ASSERT_EQ(run_case().code, 0);
  const std::string before = content_of(out() / "report.html");
  EXPECT_EQ(run_case({"--set", "gravity=-1"}).code, 2);
  EXPECT_EQ(content_of(out() / "report.html"), before);
  EXPECT_TRUE(std::filesystem::exists(result("mpm")));
}

} // namespace
} // namespace settle::compare::test
