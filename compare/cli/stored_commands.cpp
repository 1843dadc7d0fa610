#include <filesystem>

#include <fmt/format.h>

#include "announce.hpp"
#include "command.hpp"
#include "settle/compare/campaign_run.hpp"
#include "settle/compare/gates.hpp"
#include "settle/compare/outcome_io.hpp"
#include "settle/compare/pdf_report.hpp"
#include "settle/compare/report.hpp"
#include "settle/compare/text_file.hpp"
#include "summary.hpp"

namespace settle::compare::cli {

using exchange::ExitCode;

namespace {

class CheckCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "check"; }
  [[nodiscard]] std::string purpose() const override { return "judge existing results again, without running"; }
  void declare(CLI::App& app) override {
    app.add_option("DIR", folder_, "folder of a run or campaign, or a file in it")->required();
    app.add_option("--format", format_,
                   "text; gitlab: a code quality report; junit; json: the verdicts; left out: text")
        ->check(CLI::IsMember({"text", "gitlab", "junit", "json"}));
  }
  ExitCode run(const std::string&) override {
    const std::filesystem::path given(folder_);
    const CampaignOutcome outcome = read_outcome(std::filesystem::is_regular_file(given) ? given.parent_path() : given);
    fmt::print("{}", text_of(outcome));
    if (format_ == "text" && somebody_listens()) announce(outcome);
    return exit_code_of(outcome.runs, outcome.families);
  }

private:
  [[nodiscard]] std::string text_of(const CampaignOutcome& outcome) const {
    if (format_ == "gitlab") return gitlab_code_quality(outcome);
    if (format_ == "junit") return junit_xml(outcome);
    if (format_ == "json") return verdicts_json(outcome);
    return summary_text(outcome);
  }

  std::string folder_, format_ = "text";
};

class ReportCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "report"; }
  [[nodiscard]] std::string purpose() const override { return "write the report of existing results again"; }
  void declare(CLI::App& app) override {
    app.add_option("DIR", folder_, "folder of a run or campaign")->required();
    app.add_option("--format", formats_,
                   "what to write, separated by commas. html: report.html; md: summary.md; json: verdicts.json; csv: "
                   "verdicts.csv and figures.csv; pdf: report.pdf, printed by Chromium; left out: html, md, json and "
                   "junit.xml")
        ->delimiter(',')
        ->check(CLI::IsMember({"html", "md", "json", "csv", "pdf"}));
    app.add_option("--browser", browser_,
                   "program that prints the pdf; left out: the one that SETTLE_BROWSER names, or chromium or "
                   "google-chrome in PATH");
    app.add_flag("--no-fields", no_fields_, "without field pictures, which are some 20 to 60 kB each");
  }
  ExitCode run(const std::string&) override {
    CampaignOutcome outcome = read_outcome(folder_);
    if (no_fields_) outcome.campaign.report.fields = false;
    if (formats_.empty()) {
      write_report(outcome, folder_);
      fmt::print("report: {}\n", file("report.html").string());
    }
    for (const std::string& format : formats_)
      write(outcome, format);
    return exit_code_of(outcome.runs, outcome.families);
  }

private:
  [[nodiscard]] std::filesystem::path file(const char* name) const { return std::filesystem::path(folder_) / name; }

  void write(const CampaignOutcome& outcome, const std::string& format) const {
    if (format == "html") put("report.html", html_report(outcome));
    if (format == "md") put("summary.md", summary_markdown(outcome));
    if (format == "json") put("verdicts.json", verdicts_json(outcome));
    if (format == "csv") put("verdicts.csv", verdicts_csv(outcome));
    if (format == "csv") put("figures.csv", figures_csv(outcome));
    if (format != "pdf") return;
    write_pdf(outcome, file("report.pdf"), browser_);
    fmt::print("report: {}\n", file("report.pdf").string());
  }

  void put(const char* name, const std::string& text) const {
    write_text(file(name), text);
    fmt::print("report: {}\n", file(name).string());
  }

  std::string folder_, browser_;
  std::vector<std::string> formats_;
  bool no_fields_ = false;
};

} // namespace

std::unique_ptr<Command> make_check_command() {
  return std::make_unique<CheckCommand>();
}
std::unique_ptr<Command> make_report_command() {
  return std::make_unique<ReportCommand>();
}

} // namespace settle::compare::cli
