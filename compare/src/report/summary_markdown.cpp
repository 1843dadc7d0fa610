#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "case_entries.hpp"
#include "format.hpp"
#include "html_parts.hpp"
#include "reported_verdicts.hpp"
#include "settle/compare/convergence_text.hpp"
#include "settle/compare/refinement_levels.hpp"
#include "statistic_text.hpp"

namespace settle::compare {

using namespace report;

namespace {

constexpr std::size_t longest_list = 30; // verdicts that did not pass; the page has the rest

/// Text inside a cell of a Markdown table: one line, nothing that a renderer would take for markup.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : printable(text)) {
    if (c == '\n') {
      result += ' ';
      continue;
    }
    if (c == '<') {
      result += "&lt;";
      continue;
    }
    if (c == '|' || c == '*' || c == '_' || c == '`' || c == '[' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string problems(const std::vector<Verdict>& verdicts) {
  std::string text =
      "## Did not pass\n\n| status | run | what | value | accepted | reason |\n|---|---|---|---:|---:|---|\n";
  std::size_t listed = 0, left = 0;
  for (const Verdict& verdict : worst_first(verdicts)) {
    if (verdict.status == Status::passed) break;
    if (listed == longest_list) {
      ++left;
      continue;
    }
    const std::string band = accepted_band(verdict);
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", status_text(verdict.status), cell(verdict.run),
                        cell(verdict.what), band.empty() ? "" : value_text(verdict, verdict.value), band,
                        cell(verdict.message.empty() ? verdict.why : verdict.message));
    ++listed;
  }
  if (left > 0) text += fmt::format("\n{} more are in report.html.\n", left);
  return listed == 0 ? "" : text + "\n";
}

std::string figure(const RunOutcome& run, const std::string& solver, Statistic statistic) {
  const double value = measured(run, solver, statistic);
  if (!std::isfinite(value)) return std::string(no_value);
  return fmt::format("{} ({})", value_text(statistic, value),
                     difference_text(statistic, value, exact_value(run, solver, statistic)));
}

std::string key_figures(const CampaignOutcome& outcome) {
  const std::vector<const SolverRun*> joined = outcome.joined_solvers();
  std::string text = "## Runs\n\nLast stage; in brackets the difference from the exact solution of the same model.\n\n"
                     "| run | verdicts | MPM settlement [m] | MPM stress [kPa] | MPM mean density [kg/m³] "
                     "| FEM settlement [m] | FEM stress [kPa] |";
  std::string rule = "\n|---|---|---:|---:|---:|---:|---:|";
  for (const SolverRun* solver : joined) {
    text += fmt::format(" {0} settlement [m] | {0} stress [kPa] |", cell(title_of(*solver)));
    rule += "---:|---:|";
  }
  text += rule + "\n";
  for (const RunOutcome& run : outcome.runs) {
    const std::string remark = out_of_equilibrium(run).empty() ? "" : " — out of equilibrium";
    text +=
        fmt::format("| {}{} | {} | {} | {} | {} | {} | {} |", cell(run.name), remark,
                    count_text(count(reported_verdicts(run))), figure(run, "mpm", Statistic::max_settlement),
                    figure(run, "mpm", Statistic::max_vertical_stress), figure(run, "mpm", Statistic::mean_density),
                    figure(run, "fem", Statistic::max_settlement), figure(run, "fem", Statistic::max_vertical_stress));
    for (const SolverRun* solver : joined) {
      text += fmt::format(" {} | {} |", figure(run, solver->solver, Statistic::max_settlement),
                          figure(run, solver->solver, Statistic::max_vertical_stress));
    }
    text += "\n";
  }
  return text;
}

/// A line a case, a column a leg: the sign of the worst verdict, and how many passed of all.
std::string matrix(const CampaignOutcome& outcome) {
  const std::vector<CaseEntry> cases = case_entries(outcome);
  const Facets facets = facets_of(cases);
  std::string text =
      "## Cases and legs\n\nHow many verdicts passed of all, with the sign of the worst.\n\n| case | verdict |";
  std::string rule = "\n|---|---|";
  for (const std::string& leg : facets.legs) {
    text += fmt::format(" {} |", cell(Facets::title_of_leg(leg)));
    rule += "---|";
  }
  text += rule + "\n";
  for (const CaseEntry& entry : cases) {
    text += fmt::format("| {} | {} |", cell(entry.name), status_text(entry.status));
    for (const std::string& leg : facets.legs)
      text += fmt::format(" {} |", matrix_cell(entry, leg).text);
    text += "\n";
  }
  return text + "\n";
}

std::string convergence(const CampaignOutcome& outcome) {
  std::string text;
  for (const Family& family : outcome.families) {
    text += fmt::format("## Convergence of {}\n\n", cell(family.name));
    for (const ConvergenceStudy& study : family.studies) {
      text += fmt::format("{}: **{}**\n\n| {} | norm [{}] | {} | order |\n|---:|---:|---:|---:|\n", cell(study.title()),
                          cell(conclusion_of(study)), size_title(family.size), study.unit,
                          study.errors.empty() ? "change" : "error");
      for (const ConvergenceRow& row : rows_of(study))
        text += fmt::format("| {} | {} | {} | {} |\n", row.size, row.value, row.error, row.order);
      text += "\n";
    }
  }
  return text;
}

} // namespace

std::string summary_markdown(const CampaignOutcome& outcome) {
  const std::vector<Verdict> verdicts = all_verdicts(outcome);
  const std::string head =
      fmt::format("# {}\n\n**{}** — {} in {} runs, {}\n\n", cell(outcome.campaign.title), status_text(worst(verdicts)),
                  count_text(count(verdicts)), outcome.runs.size(), duration(outcome.wall_time));
  const std::string tail = fmt::format("\nsettle {} ({}), {}. Again: `{}`\n", outcome.program_version, outcome.commit,
                                       outcome.created, printable(outcome.command));
  return head + problems(verdicts) + matrix(outcome) + convergence(outcome) + key_figures(outcome) + tail;
}

} // namespace settle::compare
