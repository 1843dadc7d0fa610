#include "settle/compare/gates.hpp"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "format.hpp"
#include "reported_verdicts.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

/// A place in a file; line and column 1 where only the file is known.
struct Place {
  std::string file;
  int line = 1, column = 1;
};

/// Takes ":NUMBER" off the end of a text; nothing where it does not end in one.
std::optional<int> take_number(std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {};
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + colon + 1, end, number);
  if (problem != std::errc() || stop != end) return {};
  text.resize(colon);
  return number;
}

/// `file:line:column` or `file`. An override ("--set ...") has no place in a file.
Place place_of(std::string where) {
  if (where.starts_with("--set")) return {};
  Place place;
  const auto last = take_number(where);
  const auto before = last ? take_number(where) : std::nullopt;
  if (last) place.line = before.value_or(*last);
  if (before) place.column = *last;
  place.file = where;
  return place;
}

std::string relative_to(const fs::path& root, const std::string& file) {
  if (root.empty() || file.empty()) return file;
  const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(root.lexically_normal());
  return relative.empty() || *relative.begin() == ".." ? file : relative.string();
}

/// What GitHub asks to be escaped in a message, and more of it in a property.
std::string escaped(const std::string& text, bool property) {
  std::string result;
  for (const char letter : report::printable(text)) {
    const bool escape =
        letter == '%' || letter == '\r' || letter == '\n' || (property && (letter == ':' || letter == ','));
    result += escape ? fmt::format("%{:02X}", static_cast<unsigned char>(letter)) : std::string(1, letter);
  }
  return result;
}

std::string escaped_xml(const std::string& text) {
  std::string result;
  for (const char letter : report::printable(text)) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '>')
      result += "&gt;";
    else if (letter == '"')
      result += "&quot;";
    else
      result += letter;
  }
  return result;
}

/// "failed: settlement, mpm - exact: 0.012 is above the limit 0.01".
std::string sentence_of(const Verdict& verdict) {
  const std::string& reason = verdict.message.empty() ? verdict.why : verdict.message;
  return fmt::format("{}: {}{}{}", name_of(verdict.status), verdict.what, reason.empty() ? "" : ": ", reason);
}

std::string annotation_of(const Verdict& verdict, const fs::path& root) {
  const Place place = place_of(verdict.where);
  const std::string at = place.file.empty()
                             ? ""
                             : fmt::format("file={},line={},col={},", escaped(relative_to(root, place.file), true),
                                           place.line, place.column);
  return fmt::format("::error {}title={}::{}\n", at, escaped(verdict.run, true), escaped(sentence_of(verdict), false));
}

} // namespace

std::string github_annotations(const CampaignOutcome& outcome, const fs::path& root) {
  std::string text;
  for (const Verdict& verdict : report::worst_first(report::all_verdicts(outcome))) {
    if (verdict.status != Status::passed) text += annotation_of(verdict, root);
  }
  return text;
}

std::string gitlab_code_quality(const CampaignOutcome& outcome) {
  nlohmann::ordered_json issues = nlohmann::ordered_json::array();
  for (const Verdict& verdict : report::worst_first(report::all_verdicts(outcome))) {
    if (verdict.status == Status::passed) continue;
    const Place place = place_of(verdict.where);
    issues.push_back({{"description", fmt::format("{}: {}", verdict.run, report::printable(sentence_of(verdict)))},
                      {"check_name", fmt::format("settle.{}", verdict.kind)},
                      {"fingerprint", exchange::sha256(verdict.run + "\n" + verdict.kind + "\n" + verdict.what)},
                      {"severity", verdict.status == Status::failed ? "major" : "critical"},
                      {"location", {{"path", place.file}, {"lines", {{"begin", place.line}}}}}});
  }
  return issues.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string ctest_measurements(const CampaignOutcome& outcome) {
  std::string text;
  for (const Verdict& verdict : report::all_verdicts(outcome)) {
    const bool measured = verdict.kind == "check" || verdict.kind == "convergence";
    if (!measured || !std::isfinite(verdict.value)) continue;
    text += fmt::format("<CTestMeasurement type=\"numeric/double\" name=\"{}\">{}</CTestMeasurement>\n",
                        escaped_xml(verdict.run + ": " + verdict.what), verdict.value);
  }
  return text;
}

} // namespace settle::compare
