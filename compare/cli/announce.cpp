#include "announce.hpp"

#include <cstdlib>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "settle/compare/gates.hpp"
#include "settle/compare/report.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::cli {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

bool in_github_actions() {
  return variable("GITHUB_ACTIONS") == "true";
}

/// CTest sets it, to 0 or 1, for every test it starts.
bool in_ctest() {
  return std::getenv("CTEST_INTERACTIVE_DEBUG_MODE") != nullptr;
}

void append_summary(const std::string& file, const std::string& text) {
  std::ofstream output(file, std::ios::binary | std::ios::app);
  output << text << '\n';
  if (output.flush()) return;
  throw exchange::FileError({.where = file,
                             .what = "the summary of the step cannot be written",
                             .given = {},
                             .allowed = {},
                             .remedy = "GITHUB_STEP_SUMMARY must name a file that can be written"});
}

} // namespace

bool somebody_listens() {
  return in_github_actions() || in_ctest();
}

void announce(const CampaignOutcome& outcome) {
  if (in_ctest()) fmt::print("{}", ctest_measurements(outcome));
  if (!in_github_actions()) return;
  fmt::print("{}", github_annotations(outcome, variable("GITHUB_WORKSPACE")));
  if (const std::string file = variable("GITHUB_STEP_SUMMARY"); !file.empty())
    append_summary(file, summary_markdown(outcome));
}

} // namespace settle::compare::cli
