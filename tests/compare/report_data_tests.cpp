/// \file
/// What machines and CI pages read: verdicts.json, junit.xml, summary.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "report_fixture.hpp"
#include "settle/compare/report.hpp"

namespace settle::compare::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Two runs: the second has one verdict of every kind that is not "passed".
CampaignOutcome campaign_with_problems() {
  CampaignOutcome outcome = synthetic_campaign();
  std::vector<Verdict>& verdicts = outcome.runs[1].verdicts;
  verdicts.push_back(verdict_of(Status::failed, "mass & <weight>", 0.5, 0.1));
  verdicts.push_back(verdict_of(Status::missing, "density", nan, 0.1));
  verdicts.push_back(verdict_of(Status::error, "fem finished", nan, 0.0));
  return outcome;
}

std::size_t place_of(const std::string& text, const std::string& part) {
  return text.find(part);
}

TEST(VerdictsJson, HoldsEveryVerdictWithAllItsFields) {
  const CampaignOutcome outcome = campaign_with_problems();
  const json document = json::parse(verdicts_json(outcome));
  ASSERT_EQ(document.at("verdicts").size(), 7U);
  std::size_t i = 0;
  for (const RunOutcome& run : outcome.runs) {
    for (const Verdict& verdict : run.verdicts) {
      const json& entry = document.at("verdicts").at(i++);
      EXPECT_EQ(entry.at("run"), run.name);
      EXPECT_EQ(entry.at("status"), name_of(verdict.status));
      EXPECT_EQ(entry.at("what"), verdict.what);
      EXPECT_EQ(entry.at("kind"), verdict.kind);
      EXPECT_EQ(entry.at("limit"), verdict.limit);
      EXPECT_EQ(entry.at("at_least"), verdict.at_least);
      EXPECT_EQ(entry.at("scale"), verdict.scale);
      EXPECT_EQ(entry.at("why"), verdict.why);
      EXPECT_EQ(entry.at("message"), verdict.message);
    }
  }
}

TEST(VerdictsJson, SaysWhichCampaignProgramAndStatus) {
  const json document = json::parse(verdicts_json(campaign_with_problems()));
  EXPECT_EQ(document.at("campaign"), "A campaign");
  EXPECT_EQ(document.at("program_version"), "0.1.0");
  EXPECT_EQ(document.at("commit"), "abcdef");
  EXPECT_EQ(document.at("status"), "error");
  EXPECT_EQ(document.at("counts"), json({{"passed", 4}, {"failed", 1}, {"missing", 1}, {"error", 1}}));
}

TEST(VerdictsJson, WritesNumbersInFullAndNotANumberAsNull) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[0].verdicts[0].value = 1.0 / 3.0;
  outcome.runs[0].verdicts[1] = verdict_of(Status::missing, "density", nan, 0.1);
  const json verdicts = json::parse(verdicts_json(outcome)).at("verdicts");
  EXPECT_EQ(verdicts.at(0).at("value"), 1.0 / 3.0);
  EXPECT_TRUE(verdicts.at(1).at("value").is_null());
}

TEST(VerdictsJson, HoldsTheKeyFiguresInSiUnits) {
  const json figures = json::parse(verdicts_json(synthetic_campaign({.runs = 1, .mpm_error = 0.0}))).at("figures");
  const auto found = std::find_if(figures.begin(), figures.end(), [](const json& figure) {
    return figure.at("source") == "fem" && figure.at("figure") == "max-vertical-stress";
  });
  ASSERT_NE(found, figures.end());
  EXPECT_EQ(found->at("run"), "run 1");
  EXPECT_EQ(found->at("unit"), "Pa");
  EXPECT_NEAR(found->at("value").get<double>(), 1720.0 * 9.81 * 5.0, 1e-6);
  EXPECT_NEAR(found->at("relative_difference").get<double>(), 0.0, 1e-12);
}

TEST(VerdictsJson, SurvivesMessagesThatAreNoUtf8) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[0].verdicts[0].message = "crashed: \xff\x1b[31mred\x1b[0m";
  EXPECT_EQ(json::parse(verdicts_json(outcome)).at("verdicts").at(0).at("message"), "crashed: \uFFFDred");
}

/// The cells of the lines of a table without quotes.
std::vector<std::vector<std::string>> table_of(const std::string& text) {
  std::vector<std::vector<std::string>> table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    table.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');)
      table.back().push_back(cell);
  }
  return table;
}

TEST(Csv, HasALineAVerdictAndANumberThatReadsBack) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 2});
  for (RunOutcome& run : outcome.runs) {
    for (Verdict& verdict : run.verdicts)
      verdict.what = "settlement";
  }
  outcome.runs[1].verdicts[1].value = 0.1 + 0.2;
  const auto table = table_of(verdicts_csv(outcome));
  ASSERT_EQ(table.size(), 5U);
  for (const auto& line : table)
    EXPECT_EQ(line.size(), 14U);
  EXPECT_EQ(table[0][0], "case");
  EXPECT_EQ(table[4][0], "run 2");
  EXPECT_EQ(table[0][6], "value");
  EXPECT_EQ(std::stod(table[4][6]), 0.1 + 0.2);
}

TEST(Csv, QuotesWhatWouldBreakALineAndLeavesOutWhatIsNoNumber) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  outcome.runs[0].verdicts = {verdict_of(Status::missing, "a, \"b\"", nan, 0.1)};
  outcome.runs[0].verdicts[0].message = "two\nlines";
  const std::string text = verdicts_csv(outcome);
  EXPECT_THAT(text, HasSubstr(",\"a, \"\"b\"\"\",,0,0.1,,"));
  EXPECT_THAT(text, HasSubstr("\"two\nlines\"\n"));
}

TEST(Csv, HasTheKeyFiguresOfEverySolver) {
  const auto table = table_of(figures_csv(synthetic_campaign({.runs = 1})));
  ASSERT_EQ(table.size(), 10U); // five figures of mpm, four of fem, which refills nothing
  EXPECT_EQ(table[0],
            (std::vector<std::string>{"case", "source", "figure", "unit", "value", "exact", "relative_difference"}));
  for (const auto& line : table)
    EXPECT_EQ(line.size(), 7U);
}

TEST(ReportedVerdicts, NotANumberNeverPasses) {
  for (const double value : {nan, std::numeric_limits<double>::infinity()}) {
    for (const std::string kind : {"check", "audit"}) {
      RunOutcome run = synthetic_campaign().runs[0];
      run.verdicts[0].value = value;
      run.verdicts[0].kind = kind;
      EXPECT_EQ(reported_verdicts(run)[0].status, Status::missing);
      EXPECT_EQ(reported_verdicts(run)[1].status, Status::passed);
    }
  }
}

TEST(ReportedVerdicts, ARunWithoutVerdictsIsMissingNotGreen) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[1].verdicts.clear();
  ASSERT_EQ(reported_verdicts(outcome.runs[1]).size(), 1U);
  EXPECT_EQ(reported_verdicts(outcome.runs[1])[0].status, Status::missing);
  EXPECT_EQ(json::parse(verdicts_json(outcome)).at("status"), "missing");
}

TEST(ReportedVerdicts, ACampaignWithoutRunsIsMissing) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs.clear();
  outcome.campaign.published.clear();
  outcome.campaign.figures.clear();
  EXPECT_EQ(json::parse(verdicts_json(outcome)).at("status"), "missing");
  EXPECT_THAT(html_report(outcome), HasSubstr("no verdict"));
}

TEST(Junit, HasASuiteARunAndATestCaseAVerdict) {
  pugi::xml_document document;
  const std::string text = junit_xml(campaign_with_problems());
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node suites = document.child("testsuites");
  EXPECT_EQ(suites.attribute("tests").as_int(), 7);
  EXPECT_EQ(suites.attribute("failures").as_int(), 1);
  EXPECT_EQ(suites.attribute("errors").as_int(), 2);
  const pugi::xml_node second = suites.find_child_by_attribute("testsuite", "name", "run 2");
  EXPECT_EQ(second.attribute("tests").as_int(), 5);
  EXPECT_EQ(second.attribute("errors").as_int(), 2);
  EXPECT_EQ(std::distance(second.children("testcase").begin(), second.children("testcase").end()), 5);
}

TEST(Junit, TellsWhyATestFailed) {
  pugi::xml_document document;
  const std::string text = junit_xml(campaign_with_problems());
  ASSERT_TRUE(document.load_string(text.c_str()));
  const pugi::xml_node suite = document.child("testsuites").find_child_by_attribute("name", "run 2");
  const pugi::xml_node failed = suite.find_child_by_attribute("testcase", "name", "mass & <weight>");
  EXPECT_STREQ(failed.child("failure").attribute("message").value(), "this is what happened");
  EXPECT_THAT(failed.child("failure").text().get(), HasSubstr("value: 50.0 %, accepted: ≤ 10.0 %"));
  const pugi::xml_node missing = suite.find_child_by_attribute("testcase", "name", "density");
  EXPECT_STREQ(missing.child("error").attribute("type").value(), "missing");
  const pugi::xml_node error = suite.find_child_by_attribute("testcase", "name", "fem finished");
  EXPECT_STREQ(error.child("error").attribute("type").value(), "error");
}

TEST(Junit, StaysXmlWhateverASolverPrints) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[0].verdicts[0] = verdict_of(Status::error, "mpm finished", nan, 0.0);
  outcome.runs[0].verdicts[0].message = std::string("a\0b\x01 ]]> <tag> \xc3", 15);
  pugi::xml_document document;
  const std::string text = junit_xml(outcome);
  ASSERT_TRUE(document.load_string(text.c_str()));
  EXPECT_EQ(text.find('\x01'), std::string::npos);
  EXPECT_EQ(text.find('\0'), std::string::npos);
}

TEST(Summary, CountsAndShowsFailuresBeforeTheRuns) {
  const std::string text = summary_markdown(campaign_with_problems());
  EXPECT_THAT(text, HasSubstr("1 error, 1 missing, 1 failed, 4 passed"));
  EXPECT_THAT(text, HasSubstr("this is what happened"));
  EXPECT_LT(place_of(text, "## Did not pass"), place_of(text, "## Runs"));
  EXPECT_THAT(text, HasSubstr("| run 1 | 2 passed |"));
}

TEST(Summary, HasNoFailureSectionWhereAllPassed) {
  EXPECT_THAT(summary_markdown(synthetic_campaign()), Not(HasSubstr("Did not pass")));
}

TEST(Summary, GivesKeyFiguresWithTheirDifferenceFromTheExactSolution) {
  const std::string text = summary_markdown(synthetic_campaign());
  EXPECT_THAT(text, HasSubstr("1892 (0.0 %)"));                     // MPM mean density: made without error
  EXPECT_THAT(text, HasSubstr("0.2988 (0.0 %) | 84.37 (0.0 %) |")); // FEM at its probes: without error too
  EXPECT_THAT(text, HasSubstr("93.00 (+0.23 %)")); // MPM stress: + 1 % on its lowest point, 1/24 m above the base
}

TEST(Summary, HasAMatrixOfCasesAndLegs) {
  CampaignOutcome outcome = campaign_with_problems();
  for (RunOutcome& run : outcome.runs) {
    for (Verdict& verdict : run.verdicts)
      verdict.leg = "mpm - exact";
  }
  const std::string text = summary_markdown(outcome);
  EXPECT_THAT(text, HasSubstr("| case | verdict | mpm − exact |"));
  EXPECT_LT(place_of(text, "| run 2 | ! error | ! 2 of 5 |"), place_of(text, "| run 1 | ✓ passed | ✓ 2 of 2 |"));
}

TEST(Summary, KeepsMarkupOutOfTables) {
  CampaignOutcome outcome = campaign_with_problems();
  const std::string text = summary_markdown(outcome);
  EXPECT_THAT(text, Not(HasSubstr("<weight>")));
  outcome.runs[1].verdicts[2].message = "a | b\nc";
  EXPECT_THAT(summary_markdown(outcome), HasSubstr("a \\| b c"));
}

} // namespace
} // namespace settle::compare::test
