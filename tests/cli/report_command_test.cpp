/// \file
/// `settle report --format`: what it writes, the same bytes each time, and what happens without a browser.
#include <cstdlib>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "command_line.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class ReportCommand : public CommandLine {
protected:
  ReportCommand() {
    EXPECT_EQ(run_case().code, 0);
    for (const char* name : {"report.html", "summary.md", "verdicts.json", "junit.xml"})
      fs::remove(out() / name);
  }
  ~ReportCommand() override { unsetenv("SETTLE_BROWSER"); }

  [[nodiscard]] Answer report(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"report", out().string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return settle(arguments);
  }
  [[nodiscard]] std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(out())) {
      const std::string name = entry.path().filename();
      if (entry.is_regular_file() && name.front() != '.' && name != "outcome.json" && name != "finished.json")
        found[name] = content_of(entry.path());
    }
    return found;
  }
  /// A browser that prints a file with dates of now.
  void play_browser(const std::string& end) const {
    const fs::path script = folder.script(
        "browser", "for word in \"$@\"; do case \"$word\" in --print-to-pdf=*) pdf=\"${word#*=}\";; esac; done\n"
                   "echo \"/CreationDate (D:20991231235959+00'00') /ModDate (D:20991231235959+00'00')\" > \"$pdf\"\n" +
                       end + "\n");
    setenv("SETTLE_BROWSER", script.c_str(), 1);
  }
};

TEST_F(ReportCommand, WritesWhatItIsAskedForAndNothingElse) {
  EXPECT_EQ(report({"--format", "csv"}).code, 0);
  EXPECT_THAT(files(), testing::ElementsAre(testing::Key("figures.csv"), testing::Key("verdicts.csv")));
  const Answer answer = report({"--format", "md,json"});
  EXPECT_THAT(answer.text, AllOf(HasSubstr("summary.md"), HasSubstr("verdicts.json")));
  EXPECT_EQ(files().size(), 4U);
  EXPECT_EQ(report({"--format", "doc"}).code, 2);
}

TEST_F(ReportCommand, GivesTheSameBytesForTheSameResults) {
  ASSERT_EQ(report({"--format", "html,md,json,csv"}).code, 0);
  const auto first = files();
  EXPECT_EQ(first.size(), 5U);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // another second on every clock
  ASSERT_EQ(report({"--format", "html,md,json,csv"}).code, 0);
  EXPECT_EQ(files(), first);
}

TEST_F(ReportCommand, SetsTheDatesOfAPdfToThoseOfTheResults) {
  play_browser("exit 0");
  ASSERT_EQ(report({"--format", "pdf"}).code, 0);
  const std::string pdf = files().at("report.pdf");
  EXPECT_THAT(pdf, testing::ContainsRegex("^/CreationDate \\(D:20[0-9]{12}\\+00'00'\\) /ModDate \\(D:20[0-9]{12}"));
  EXPECT_THAT(pdf, testing::Not(HasSubstr("20991231")));
}

TEST_F(ReportCommand, SaysWhatToInstallWhereThereIsNoBrowser) {
  setenv("SETTLE_BROWSER", "/nowhere/chromium", 1);
  const Answer answer = report({"--format", "pdf"});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("no browser that could print"), HasSubstr("/nowhere/chromium"),
                                 HasSubstr("apt-get install chromium"), HasSubstr("--browser")));
  EXPECT_TRUE(files().empty());
}

TEST_F(ReportCommand, SaysWhatABrowserSaidThatFails) {
  play_browser("echo 'no display'; exit 7");
  const Answer answer = report({"--format", "pdf"});
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("did not print the report (code 7"), HasSubstr("no display")));
  EXPECT_TRUE(files().empty());
}

TEST_F(ReportCommand, OutlivesNoResults) {
  ASSERT_EQ(report({"--format", "csv"}).code, 0);
  EXPECT_EQ(run_case({"--fresh"}).code, 0);
  EXPECT_FALSE(fs::exists(out() / "verdicts.csv"));
}

} // namespace
} // namespace settle::compare::test
