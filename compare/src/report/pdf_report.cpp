#include "settle/compare/pdf_report.hpp"

#include <atomic>
#include <cctype>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>

#include "settle/compare/interrupt.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/report.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "temporary_folder.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
using exchange::FileError;

namespace {

fs::path browser_or_throw(const std::string& named) {
  const fs::path browser = find_browser(named);
  if (!browser.empty()) return browser;
  const char* variable = std::getenv("SETTLE_BROWSER");
  const std::string asked = !named.empty() ? named : variable != nullptr ? variable : "";
  throw FileError({.where = "browser",
                   .what = "there is no browser that could print the report",
                   .given = asked.empty() ? "none in PATH" : asked,
                   .allowed = "chromium, google-chrome, or a program of their kind",
                   .remedy = "install one (Debian: apt-get install chromium), or name it with --browser or "
                             "SETTLE_BROWSER"});
}

/// Replaces the digits of every date behind `key` by those of another one of the same length.
void set_dates(std::string& pdf, const std::string& key, const std::string& digits) {
  const std::string begin = key + " (D:";
  for (std::size_t at = pdf.find(begin); at != std::string::npos; at = pdf.find(begin, at + 1)) {
    const std::size_t first = at + begin.size();
    if (pdf.find_first_not_of("0123456789", first) == first + digits.size()) pdf.replace(first, digits.size(), digits);
  }
}

/// "20240131120000" of "2024-01-31T12:00:00Z".
std::string digits_of(const std::string& date) {
  std::string digits;
  for (const char c : date) {
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) digits += c;
  }
  return digits;
}

std::string printed(const fs::path& browser, const std::string& page) {
  constexpr double time_limit = 600.0; // hundreds of cases take about a minute
  const TemporaryFolder folder;
  const fs::path pdf = folder.file("report.pdf");
  write_text(folder.file("report.html"), page);
  std::vector<std::string> arguments{"--headless",
                                     "--disable-gpu",
                                     "--no-first-run",
                                     "--no-pdf-header-footer",
                                     "--user-data-dir=" + folder.file("profile").string(),
                                     "--print-to-pdf=" + pdf.string(),
                                     "file://" + folder.file("report.html").string()};
  if (geteuid() == 0) arguments.emplace_back("--no-sandbox"); // root cannot have one
  const ProcessRequest request{
      .program = browser, .arguments = arguments, .log = folder.file("messages"), .time_limit = time_limit};
  const ProcessOutcome ended = run_process(request, interrupted());
  std::error_code failure;
  if (ended.end == ProcessEnd::exited && ended.code == 0 && fs::exists(pdf, failure)) return read_text(pdf);
  throw FileError({.where = browser.string(),
                   .what = fmt::format("the browser did not print the report (code {}{})", ended.code, ended.problem),
                   .given = tail_of(request.log, 10),
                   .allowed = "",
                   .remedy = "try another one with --browser, or print report.html by hand"});
}

} // namespace

fs::path find_browser(const std::string& named) {
  const char* variable = std::getenv("SETTLE_BROWSER");
  const std::string asked = !named.empty() ? named : variable != nullptr ? variable : "";
  std::error_code failure;
  if (!asked.empty()) return fs::is_regular_file(asked, failure) ? fs::absolute(asked) : find_in_path(asked);
  for (const char* name : {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"}) {
    if (const fs::path found = find_in_path(name); !found.empty()) return found;
  }
  return {};
}

void write_pdf(const CampaignOutcome& outcome, const fs::path& file, const std::string& browser, int jobs) {
  const fs::path program = browser_or_throw(browser);
  std::string pdf = printed(program, html_report(outcome, jobs));
  const std::string digits = digits_of(outcome.created);
  set_dates(pdf, "/CreationDate", digits);
  set_dates(pdf, "/ModDate", digits);
  write_text(file, pdf);
}

} // namespace settle::compare
