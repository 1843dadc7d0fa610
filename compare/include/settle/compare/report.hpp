/// \file
/// What a campaign leaves to read: a page, a summary, and the verdicts for machines.
#pragma once

#include <filesystem>
#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// Writes report.html, summary.md, verdicts.json and junit.xml into `directory`, which is created where needed.
/// The same outcome gives the same bytes. What machines read is written first, so it is there even if the page fails.
/// Throws FileError where a file cannot be written, or gnuplot, which draws the figures, is missing or fails.
/// `jobs`: threads and gnuplots at a time; 0: as many as there are cores.
void write_report(const CampaignOutcome& outcome, const std::filesystem::path& directory, int jobs = 0);

/// The whole report as one self-contained page: style, figures (SVG) and the script of its index inside, nothing
/// loaded. Without the script, and on paper, everything is shown. Throws FileError where gnuplot is missing or fails.
std::string html_report(const CampaignOutcome& outcome, int jobs = 0);

/// A short Markdown summary, as the job page of a CI service shows it.
std::string summary_markdown(const CampaignOutcome& outcome);

/// Every verdict with all its fields and every key figure, as JSON; a number that is not finite is null.
std::string verdicts_json(const CampaignOutcome& outcome);

/// Every verdict as CSV (RFC 4180), a line each: case, status, kind, quantity, leg, what, value, at_least, limit,
/// margin, scale, why, where, message. What is no finite number is empty.
std::string verdicts_csv(const CampaignOutcome& outcome);

/// The key figures of every solver and reference table as CSV: case, source, figure, unit, value, exact,
/// relative_difference; SI units.
std::string figures_csv(const CampaignOutcome& outcome);

/// The verdicts as JUnit XML: a suite a refinement family and a run, a test case a verdict; missing and error are
/// errors.
std::string junit_xml(const CampaignOutcome& outcome);

/// The verdicts of one run as a report states them: a check or an audit that claims to have passed without a finite
/// value is missing, and a run in which nothing was judged has one missing verdict that says so.
std::vector<Verdict> reported_verdicts(const RunOutcome& run);

} // namespace settle::compare
