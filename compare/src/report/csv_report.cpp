#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "format.hpp"
#include "key_figures.hpp"
#include "reported_verdicts.hpp"

namespace settle::compare {

namespace {

/// A cell as RFC 4180 has it.
std::string cell(const std::string& text) {
  const std::string shown = report::printable(text);
  if (shown.find_first_of(",\"\n") == std::string::npos) return shown;
  std::string quoted = "\"";
  for (const char c : shown) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

/// The shortest text that reads back as the same number; nothing for what is none.
std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string line(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& each : cells)
    text += (text.empty() && &each == &cells.front() ? "" : ",") + each;
  return text + "\n";
}

} // namespace

std::string verdicts_csv(const CampaignOutcome& outcome) {
  std::string text = "case,status,kind,quantity,leg,what,value,at_least,limit,margin,scale,why,where,message\n";
  for (const Verdict& verdict : report::all_verdicts(outcome)) {
    text += line({cell(verdict.run), cell(std::string(name_of(verdict.status))), cell(verdict.kind),
                  cell(verdict.quantity), cell(verdict.leg), cell(verdict.what), cell(verdict.value),
                  cell(verdict.at_least), cell(verdict.limit), cell(report::margin(verdict)), cell(verdict.scale),
                  cell(verdict.why), cell(verdict.where), cell(verdict.message)});
  }
  return text;
}

std::string figures_csv(const CampaignOutcome& outcome) {
  std::string text = "case,source,figure,unit,value,exact,relative_difference\n";
  for (const report::KeyFigure& figure : report::key_figures_of(outcome)) {
    text += line({cell(figure.run), cell(figure.source), cell(std::string(exchange::name_of(figure.statistic))),
                  report::si_unit(figure.statistic), cell(figure.value), cell(figure.exact),
                  cell(report::relative_difference(figure))});
  }
  return text;
}

} // namespace settle::compare
