/// \file
/// The page: complete, self-contained, escaped, honest about what did not pass.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report_fixture.hpp"
#include "settle/compare/report.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Every value of an attribute.
std::vector<std::string> attributes(const std::string& page, const std::string& name) {
  const std::regex pattern(fmt::format("[ \\n]{}=[\"']([^\"']*)[\"']", name));
  std::vector<std::string> values;
  for (std::sregex_iterator match(page.begin(), page.end(), pattern), end; match != end; ++match) {
    values.push_back((*match)[1]);
  }
  return values;
}

TEST(Page, HasASectionForEveryRunAndItsOwnFigures) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 3});
  outcome.campaign.report.fields = false;
  const std::string page = html_report(outcome);
  for (int run = 1; run <= 3; ++run) {
    EXPECT_THAT(page, HasSubstr(fmt::format("id=\"run-{0}-run-{0}\"", run)));
  }
  // The campaign's figure; settlement and stress of three runs, and their differences; what they share.
  EXPECT_EQ(occurrences(page, "<svg"), 1U + 3U * 4U + 1U);
  EXPECT_EQ(occurrences(page, "Balance, stage by stage</caption>"), 3U);
}

TEST(Page, LoadsNothingFromOutside) {
  std::string page = html_report(synthetic_campaign());
  for (const std::string name : {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"}) {
    page = std::regex_replace(page, std::regex("=\"" + name + "\""), "");
  }
  for (const std::string part : {"http://", "https://", "<link", "<iframe", "@import", "url("}) {
    EXPECT_THAT(page, Not(HasSubstr(part)));
  }
  EXPECT_EQ(occurrences(page, "<script"), 1U); // its own, which its content security policy names by its hash
  EXPECT_THAT(page,
              HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src 'sha256-"));
  for (const std::string& address : attributes(page, "href"))
    EXPECT_THAT(address, testing::AnyOf(testing::StartsWith("#"), testing::StartsWith("data:image/png;base64,")));
  EXPECT_TRUE(attributes(page, "src").empty());
}

TEST(Page, HasUniqueIdsAndNoDeadLinks) {
  const std::string page = html_report(synthetic_campaign({.runs = 3}));
  std::set<std::string> ids;
  for (const std::string& id : attributes(page, "id"))
    EXPECT_TRUE(ids.insert(id).second) << id;
  for (const std::string& address : attributes(page, "href"))
    EXPECT_TRUE(address.starts_with("data:") || ids.contains(address.substr(1))) << address;
  for (const std::string& id : attributes(page, "aria-labelledby"))
    EXPECT_TRUE(ids.contains(id)) << id;
}

TEST(Page, KeepsIdsUniqueWhereNamesDifferOnlyInSigns) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[0].name = "a b";
  outcome.runs[1].name = "a/b";
  outcome.campaign.figures.push_back(outcome.campaign.figures[0]);
  outcome.campaign.figures[0].name = "x y";
  outcome.campaign.figures[1].name = "x-y";
  std::set<std::string> ids;
  for (const std::string& id : attributes(html_report(outcome), "id"))
    EXPECT_TRUE(ids.insert(id).second) << id;
}

TEST(Page, EscapesEveryTextThatComesFromFiles) {
  const std::string evil = "<script>alert(1)</script>";
  CampaignOutcome outcome = synthetic_campaign();
  outcome.campaign.title = outcome.campaign.description = outcome.command = evil;
  outcome.campaign.figures[0].title = outcome.campaign.figures[0].caption = evil;
  outcome.campaign.figures[0].curves[0].label = evil;
  outcome.campaign.published[0].label = outcome.campaign.published[0].why = evil;
  RunOutcome& run = outcome.runs[1];
  run.name = run.note = run.study.title = run.study.source = run.overrides[0] = evil;
  run.verdicts[0].what = run.verdicts[0].why = run.verdicts[0].scale = evil;
  run.solvers[0].command = evil;
  run.solvers[0].result->case_text = run.solvers[0].result->provenance.commit = evil;
  run.solvers[1].status = SolverStatus::crashed;
  run.solvers[1].message = run.solvers[1].tail = evil;
  run.solvers[1].result.reset();
  const std::string page = html_report(outcome);
  EXPECT_EQ(occurrences(page, "<script"), 1U); // the page's own
  EXPECT_GE(occurrences(page, "&lt;script"), 20U);
}

TEST(Page, ShowsWhatDidNotPassFirst) {
  CampaignOutcome outcome = synthetic_campaign();
  outcome.runs[1].verdicts.push_back(verdict_of(Status::failed, "a failed one", 0.5, 0.1));
  outcome.runs[1].verdicts.push_back(verdict_of(Status::error, "a broken one", std::nan(""), 0.1));
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr("1 error, 1 failed, 4 passed"));
  EXPECT_LT(page.find("a broken one"), page.find("a failed one"));
  EXPECT_LT(page.find("a failed one"), page.find("settlement, mpm - exact"));
  EXPECT_THAT(page, HasSubstr("<details class=\"run\" id=\"run-2-run-2\" open>"));
  EXPECT_THAT(page, HasSubstr("<details class=\"run\" id=\"run-1-run-1\">"));
}

TEST(Page, IndexesEveryCaseWhatDidNotPassFirst) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 3});
  outcome.runs[2].verdicts[0].status = Status::failed;
  const std::string page = html_report(outcome);
  const std::size_t index = page.find("id=\"index-table\"");
  const std::size_t matrix = page.find("id=\"matrix-table\"");
  ASSERT_LT(index, matrix);
  for (const std::size_t table : {index, matrix}) {
    EXPECT_LT(page.find("data-case=\"run-3-run-3\"", table), page.find("data-case=\"run-1-run-1\"", table));
    EXPECT_LT(page.find("data-case=\"run-1-run-1\"", table), page.find("data-case=\"run-2-run-2\"", table));
  }
  EXPECT_LT(page.find("id=\"problem-table\""), index);
}

TEST(Page, TellsInTheMatrixHowEachLegWentOfEachCase) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  outcome.runs[0].verdicts[0].leg = "mpm - exact";
  outcome.runs[0].verdicts[1].leg = "mpm";
  outcome.runs[0].verdicts.push_back(verdict_of(Status::failed, "density", 0.5, 0.1));
  outcome.runs[0].verdicts.back().leg = "mpm - exact";
  const std::string page = html_report(outcome);
  EXPECT_LT(page.find("<th scope=\"col\">mpm − exact</th>"), page.find("<th scope=\"col\">mpm alone</th>"));
  EXPECT_THAT(page, HasSubstr("<b class=\"failed\">✗ 1 of 2</b>"));
  EXPECT_THAT(page, HasSubstr("<b class=\"passed\">✓ 1 of 1</b>"));
}

TEST(Page, UnfoldsWhatDidNotPassOnlyWhereThatIsLittle) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 6});
  for (RunOutcome& run : outcome.runs)
    run.verdicts[0].status = Status::failed;
  EXPECT_THAT(html_report(outcome), Not(HasSubstr("\" open>")));
  outcome.runs[0].verdicts[0].status = Status::passed;
  EXPECT_EQ(occurrences(html_report(outcome), "\" open>"), 5U);
}

TEST(Page, NeverShowsNotANumberAsPassed) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  outcome.runs[0].verdicts.resize(1);
  outcome.runs[0].verdicts[0].value = std::nan("");
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, Not(HasSubstr("✓ passed")));
  EXPECT_THAT(page, HasSubstr("? missing"));
  EXPECT_THAT(page, Not(HasSubstr(">nan")));
}

TEST(Page, ShowsChecksInPercentAndAuditsAsTheyAre) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  outcome.runs[0].verdicts[0] = verdict_of(Status::passed, "a band", 1.0, 1.013);
  outcome.runs[0].verdicts[0].at_least = 0.987;
  outcome.runs[0].verdicts[1] = verdict_of(Status::passed, "stages", 5.0, 5.0);
  outcome.runs[0].verdicts[1].at_least = 5.0;
  outcome.runs[0].verdicts[1].kind = "audit";
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr(">98.7 % … 101 %<"));
  EXPECT_THAT(page, HasSubstr(">1 %<")); // 0.013 of 1.013 are left on either side
  EXPECT_THAT(page, HasSubstr("<td>5<td>5<td>"));
}

TEST(Page, MarksRunsThatAreOutOfEquilibrium) {
  CampaignOutcome outcome = synthetic_campaign();
  EXPECT_THAT(html_report(outcome), Not(HasSubstr("out of equilibrium")));
  outcome.runs[0].solvers[0].result->stages[4].in_equilibrium = false;
  outcome.runs[0].solvers[0].result->stages[4].out_of_balance = 0.09;
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr("<span class=\"badge unheld\">≈ out of equilibrium</span>"));
  EXPECT_THAT(page, HasSubstr("mpm ended 1 of 5 stages out of equilibrium (up to 9.00 % out of balance)"));
}

TEST(Page, SetsPublishedNumbersBesideOursAndTheExactOnes) {
  CampaignOutcome outcome = synthetic_campaign({.mpm_error = 0.0});
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr("Largest vertical stress"));
  EXPECT_THAT(page, HasSubstr("83.00"));   // printed
  EXPECT_THAT(page, HasSubstr("92.78"));   // exact
  EXPECT_THAT(page, HasSubstr("−10.5 %")); // 83 / 92.78 - 1
  EXPECT_THAT(page, HasSubstr("The ramp was not held."));
}

TEST(Page, SurvivesRunsWithoutAnyResult) {
  CampaignOutcome outcome = synthetic_campaign();
  for (SolverRun& solver : outcome.runs[0].solvers) {
    solver.result.reset();
    solver.status = SolverStatus::crashed;
    solver.message = "ended by signal 11";
    solver.tail = "last line";
  }
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr("ended by signal 11"));
  EXPECT_THAT(page, HasSubstr("last line"));
  EXPECT_THAT(page, HasSubstr("Not drawn"));
}

TEST(Page, SurvivesAColumnTooSoftToStand) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  RunOutcome& run = outcome.runs[0];
  run.study.materials.at("fill").youngs_modulus = 10.0;
  EXPECT_THAT(html_report(outcome), HasSubstr("Not drawn"));
}

TEST(Page, GivesParametersWithTheirUnits) {
  const std::string page = html_report(synthetic_campaign({.runs = 1}));
  EXPECT_THAT(page, HasSubstr("material.fill.youngs_modulus"));
  EXPECT_THAT(page, HasSubstr("[Pa]"));
  EXPECT_THAT(page, HasSubstr("mpm.quasi_static.increments"));
  EXPECT_THAT(page, Not(HasSubstr("mpm.explicit.damping"))); // not read by this run
}

TEST(Page, ShowsTheHashOfAMeshAndNotItsText) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  exchange::Mesh& mesh = outcome.runs[0].study.geometry.mesh.emplace();
  mesh.file = "dam.msh";
  mesh.text = std::string(5000, '7');
  const std::string page = html_report(outcome);
  EXPECT_THAT(page, HasSubstr("5002 characters, SHA-256 " + exchange::sha256('"' + mesh.text + '"')));
  EXPECT_THAT(page, Not(HasSubstr(std::string(200, '7'))));
}

TEST(Page, IsTheSameForTheSameOutcome) {
  const CampaignOutcome outcome = synthetic_campaign();
  EXPECT_EQ(html_report(outcome), html_report(outcome));
}

TEST(Page, StaysSmallForTheWholePaper) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 25, .layers = 20, .points_per_layer = 8});
  const std::size_t with_fields = html_report(outcome).size();
  outcome.campaign.report.fields = false;
  const std::size_t without = html_report(outcome).size();
  EXPECT_LT(without, 25U * 130'000U); // 20 layers: profiles with their differences, and a row a stage of each balance
  EXPECT_LT(with_fields - without, 25U * 2U * 60'000U); // a field picture takes 60 kB or less
}

TEST(Page, LeavesOutFieldPicturesOnRequest) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 1});
  EXPECT_EQ(occurrences(html_report(outcome), "<figure class=\"fields\""), 2U);
  outcome.campaign.report.fields = false;
  EXPECT_EQ(occurrences(html_report(outcome), "<figure class=\"fields\""), 0U);
}

TEST(Page, IsBelow25KilobytesACase) {
  const auto size = [](int runs) {
    CampaignOutcome outcome = synthetic_campaign({.runs = runs});
    outcome.campaign.report.fields = false;
    return html_report(outcome).size();
  };
  EXPECT_LT((size(12) - size(2)) / 10, 25'000U); // 200 cases below 5 MB
}

TEST(WriteReport, LeavesFourFilesAndNothingElse) {
  const fs::path folder = fs::path(testing::TempDir()) / "settle-report" / "new";
  fs::remove_all(folder);
  write_report(synthetic_campaign(), folder);
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names.insert(entry.path().filename());
  EXPECT_THAT(names, testing::ElementsAre("junit.xml", "report.html", "summary.md", "verdicts.json"));
  EXPECT_EQ(text_of(folder / "verdicts.json"), verdicts_json(synthetic_campaign()));
  fs::remove_all(folder);
}

TEST(WriteReport, RefusesAFolderThatIsAFile) {
  const fs::path file = fs::path(testing::TempDir()) / "settle-report-file";
  std::ofstream(file) << "occupied";
  EXPECT_THROW(write_report(synthetic_campaign(), file), exchange::FileError);
  EXPECT_EQ(text_of(file), "occupied");
  fs::remove(file);
}

} // namespace
} // namespace settle::compare::test
