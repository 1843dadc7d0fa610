#include "reported_verdicts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "format.hpp"

namespace settle::compare {

namespace {

Verdict nothing_judged(const RunOutcome& run) {
  Verdict verdict;
  verdict.status = Status::missing;
  verdict.run = run.name;
  verdict.what = "any verdict";
  verdict.kind = "check";
  verdict.message = "nothing was judged in this run";
  return verdict;
}

} // namespace

std::vector<Verdict> reported_verdicts(const RunOutcome& run) {
  if (run.verdicts.empty()) return {nothing_judged(run)};
  std::vector<Verdict> verdicts = run.verdicts;
  for (Verdict& verdict : verdicts) {
    verdict.run = run.name;
    const bool is_number = verdict.kind == "check" || verdict.kind == "audit";
    if (verdict.status != Status::passed || !is_number || std::isfinite(verdict.value)) continue;
    verdict.status = Status::missing;
    verdict.message = "there is no finite value, so it cannot have passed";
  }
  return verdicts;
}

namespace report {

int rank(Status status) {
  switch (status) {
  case Status::error:
    return 0;
  case Status::missing:
    return 1;
  case Status::failed:
    return 2;
  case Status::passed:
    return 3;
  }
  return 0;
}

std::vector<Verdict> all_verdicts(const CampaignOutcome& outcome) {
  std::vector<Verdict> all;
  for (const Family& family : outcome.families)
    all.insert(all.end(), family.verdicts.begin(), family.verdicts.end());
  for (const RunOutcome& run : outcome.runs) {
    const std::vector<Verdict> verdicts = reported_verdicts(run);
    all.insert(all.end(), verdicts.begin(), verdicts.end());
  }
  return all;
}

std::vector<Verdict> worst_first(std::vector<Verdict> verdicts) {
  std::stable_sort(verdicts.begin(), verdicts.end(),
                   [](const Verdict& a, const Verdict& b) { return rank(a.status) < rank(b.status); });
  return verdicts;
}

std::vector<Verdict> for_reading(std::vector<Verdict> verdicts) {
  std::stable_partition(verdicts.begin(), verdicts.end(), [](const Verdict& verdict) {
    return verdict.kind == "check" || verdict.kind == "convergence";
  });
  return worst_first(std::move(verdicts));
}

std::map<Status, int> count(const std::vector<Verdict>& verdicts) {
  std::map<Status, int> counts{{Status::passed, 0}, {Status::failed, 0}, {Status::missing, 0}, {Status::error, 0}};
  for (const Verdict& verdict : verdicts)
    ++counts[verdict.status];
  return counts;
}

std::string count_text(const std::map<Status, int>& counts) {
  std::string text;
  for (const Status status : {Status::error, Status::missing, Status::failed, Status::passed}) {
    if (counts.at(status) == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts.at(status), name_of(status));
  }
  return text.empty() ? "no verdict" : text;
}

std::string value_text(const Verdict& verdict, double value) {
  if (verdict.kind == "check") return ratio(value);
  const bool counted = std::trunc(value) == value && std::abs(value) < 1e6;
  return counted ? fmt::format("{:.0f}", value) : number(value, 3);
}

std::string accepted_band(const Verdict& verdict) {
  if (std::isnan(verdict.limit)) return "";
  if (!std::isfinite(verdict.value) && !(verdict.limit > 0.0)) return "";
  if (verdict.at_least == verdict.limit) return value_text(verdict, verdict.limit);
  if (!(verdict.at_least > 0.0)) return "≤ " + value_text(verdict, verdict.limit);
  return fmt::format("{} … {}", value_text(verdict, verdict.at_least), value_text(verdict, verdict.limit));
}

double margin(const Verdict& verdict) {
  if (!(verdict.limit > verdict.at_least)) return std::numeric_limits<double>::quiet_NaN();
  double left = verdict.limit - verdict.value;
  if (verdict.at_least > 0.0) left = std::min(left, verdict.value - verdict.at_least);
  return left / verdict.limit;
}

std::string margin_text(double left) {
  if (!std::isfinite(left)) return "";
  return left < -10.0 ? "far outside" : percent(left);
}

} // namespace report

} // namespace settle::compare
