#include "settle/compare/verdict.hpp"

#include <algorithm>

namespace settle::compare {
namespace {

/// How bad a status is: passed 0 ... error 3.
int severity(Status status) {
  switch (status) {
  case Status::passed:
    return 0;
  case Status::failed:
    return 1;
  case Status::missing:
    return 2;
  case Status::error:
    return 3;
  }
  return 3;
}

} // namespace

std::string_view name_of(Status status) {
  switch (status) {
  case Status::passed:
    return "passed";
  case Status::failed:
    return "failed";
  case Status::missing:
    return "missing";
  case Status::error:
    return "error";
  }
  return "error";
}

Status worst(const std::vector<Verdict>& verdicts) {
  if (verdicts.empty()) return Status::missing;
  const auto milder = [](const Verdict& a, const Verdict& b) { return severity(a.status) < severity(b.status); };
  return std::max_element(verdicts.begin(), verdicts.end(), milder)->status;
}

} // namespace settle::compare
