#include "settle/compare/report.hpp"
#include "settle/compare/text_file.hpp"

namespace settle::compare {

void write_report(const CampaignOutcome& outcome, const std::filesystem::path& directory, int jobs) {
  make_folder(directory);
  write_text(directory / "verdicts.json", verdicts_json(outcome));
  write_text(directory / "junit.xml", junit_xml(outcome));
  write_text(directory / "summary.md", summary_markdown(outcome));
  write_text(directory / "report.html", html_report(outcome, jobs));
}

} // namespace settle::compare
