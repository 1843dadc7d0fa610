#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A case whose second check fails: FEM, small strain, is held against MPM, finite strain.
class Gates : public CommandLine {
protected:
  Gates() {
    study.checks.back().quantity = exchange::Quantity::settlement;
    study.checks.back().between = {"fem", "mpm"};
    (void)folder.file("column.toml", exchange::to_toml(study));
    unsetenv("CTEST_INTERACTIVE_DEBUG_MODE");
  }
  ~Gates() override {
    for (const char* name :
         {"GITHUB_ACTIONS", "GITHUB_STEP_SUMMARY", "GITHUB_WORKSPACE", "CTEST_INTERACTIVE_DEBUG_MODE"})
      unsetenv(name);
  }
  Gates(const Gates&) = delete;
  Gates& operator=(const Gates&) = delete;

  [[nodiscard]] std::filesystem::path summary() const { return folder.path() / "step-summary.md"; }
  void be_github() const {
    setenv("GITHUB_ACTIONS", "true", 1);
    setenv("GITHUB_STEP_SUMMARY", summary().c_str(), 1);
    setenv("GITHUB_WORKSPACE", folder.path().c_str(), 1);
  }
  [[nodiscard]] int line_of_second_check() const {
    const std::string text = content_of(case_file);
    const std::size_t second = text.find("[[check]]", text.find("[[check]]") + 1);
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(second), '\n'));
  }
};

TEST_F(Gates, NobodyIsToldWhereNobodyListens) {
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, AllOf(Not(HasSubstr("::error")), Not(HasSubstr("CTestMeasurement"))));
}

TEST_F(Gates, GitHubGetsAnnotationsAtTheCheckAndASummary) {
  be_github();
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 1);
  const std::string place = fmt::format("::error file=column.toml,line={},", line_of_second_check() + 1);
  EXPECT_THAT(answer.text, HasSubstr(place));
  EXPECT_THAT(answer.text, HasSubstr("title=column::failed: settlement, fem - mpm"));
  EXPECT_THAT(content_of(summary()), AllOf(HasSubstr("## Did not pass"), HasSubstr("settlement, fem - mpm")));
}

TEST_F(Gates, CheckingAgainFindsTheSamePlace) {
  ASSERT_EQ(run_case().code, 1);
  be_github();
  const Answer answer = settle({"check", out().string()});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr(fmt::format("file=column.toml,line={},", line_of_second_check() + 1)));
}

TEST_F(Gates, ACampaignThatIsUpToDateIsAnnouncedAllTheSame) {
  ASSERT_EQ(run_case().code, 1);
  be_github();
  EXPECT_THAT(run_case().text, AllOf(HasSubstr("up to date"), HasSubstr("::error file=column.toml")));
}

TEST_F(Gates, ASummaryThatCannotBeWrittenIsExitCodeFour) {
  be_github();
  setenv("GITHUB_STEP_SUMMARY", "/nowhere/summary.md", 1);
  const Answer answer = run_case();
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, HasSubstr("GITHUB_STEP_SUMMARY"));
}

TEST_F(Gates, CTestGetsMeasurements) {
  setenv("CTEST_INTERACTIVE_DEBUG_MODE", "1", 1);
  const Answer answer = run_case();
  EXPECT_THAT(answer.text, HasSubstr("<CTestMeasurement type=\"numeric/double\" name=\"column: settlement, fem - mpm, "
                                     "l2 over probes, last stage\">0."));
}

TEST_F(Gates, GitLabGetsACodeQualityReport) {
  ASSERT_EQ(run_case().code, 1);
  const Answer answer = settle({"check", out().string(), "--format", "gitlab"});
  EXPECT_EQ(answer.code, 1);
  const auto issues = nlohmann::json::parse(answer.text);
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_EQ(issues[0].at("location").at("path"), case_file.string());
  EXPECT_EQ(issues[0].at("location").at("lines").at("begin"), line_of_second_check() + 1);
  EXPECT_EQ(issues[0].at("severity"), "major");
  EXPECT_EQ(issues[0].at("check_name"), "settle.check");
}

TEST_F(Gates, CheckPrintsWhatItIsAskedFor) {
  ASSERT_EQ(run_case().code, 1);
  EXPECT_THAT(settle({"check", out().string(), "--format", "junit"}).text,
              AllOf(HasSubstr("<testcase name=\"settlement, mpm - exact"), HasSubstr("<failure type=\"failed\"")));
  EXPECT_TRUE(nlohmann::json::accept(settle({"check", (out() / "outcome.json").string(), "--format", "json"}).text));
  EXPECT_EQ(settle({"check", out().string(), "--format", "xml"}).code, 2);
}

} // namespace
} // namespace settle::compare::test
