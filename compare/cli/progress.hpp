/// \file
/// What somebody, or a program, that waits for a campaign sees.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "settle/compare/campaign_plan.hpp"
#include "settle/compare/campaign_progress.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::cli {

/// Where the plan, the progress and the end of a campaign go.
class Display {
public:
  Display() = default;
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  virtual ~Display() = default;

  /// Instead of running: what would be run, in which order, and why.
  virtual void plan(const Plan& plan) = 0;
  /// Called by one thread at a time.
  virtual void progress(const Progress& progress) = 0;
  /// `summary`: the verdicts, for people; `report`: the page, empty where it could not be written.
  virtual void end(exchange::ExitCode code, const std::string& summary, const std::string& report) = 0;
};

/// The kinds of display: "auto", "line", "lines", "json".
const std::vector<std::string>& display_kinds();

/// "line": one line on standard error that is written over, with a bar, what runs, and the time left. "lines": one line
/// on standard error for each solver run that has ended. "json": one JSON object a line on standard output, and nothing
/// else there. "auto": "line" on a terminal, "lines" otherwise.
std::unique_ptr<Display> make_display(const std::string& kind);

} // namespace settle::compare::cli
