#include "settle/exchange/errors.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "settle/exchange/assert.hpp"

namespace settle::exchange {

std::string to_text(const Complaint& complaint) {
  std::string text = complaint.where.empty() ? complaint.what : complaint.where + ": " + complaint.what;
  const auto add = [&text](std::string_view label, const std::string& value) {
    if (!value.empty()) text += fmt::format("\n  {:<9}{}", label, value);
  };
  add("given:", complaint.given);
  add("allowed:", complaint.allowed);
  add("remedy:", complaint.remedy);
  return text;
}

void assertion_failed(const char* condition, const char* file, int line, const std::string& values) {
  fmt::print(stderr, "{}:{}: assertion failed: {}{}{}\n", file, line, condition, values.empty() ? "" : " with ",
             values);
  std::abort();
}

} // namespace settle::exchange
