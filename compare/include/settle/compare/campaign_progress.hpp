/// \file
/// What somebody who waits for a campaign wants to know.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/campaign_plan.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// The state of a campaign at the start or the end of a solver run.
struct Progress {
  std::size_t finished = 0, total = 0; ///< solver runs
  std::vector<std::string> running;    ///< "RUN, SOLVER"
  std::optional<double> seconds_left;  ///< by what was measured, now and the last time; nothing where nothing was
  std::string run, solver;             ///< which have just started or ended
  Reason reason = Reason::never_run;   ///< why it is run, or not
  const SolverRun* ended = nullptr;    ///< what has just ended, valid during the call only; nullptr: it has started
};

/// Keeps count and tells somebody, one thread at a time.
class Observer {
public:
  Observer(const Plan& plan, int jobs, std::function<void(const Progress&)> tell);
  void started(const Task& task);
  void ended(const Task& task, const SolverRun& solver);

private:
  using Clock = std::chrono::steady_clock;
  void report(const Task& task, const SolverRun* ended);
  [[nodiscard]] std::string title(const Task& task) const;
  [[nodiscard]] std::optional<double> cost_of(const Task& task) const;
  [[nodiscard]] std::optional<double> seconds_left() const;

  const Plan& plan_;
  int jobs_;
  std::function<void(const Progress&)> tell_;
  std::mutex mutex_;
  Progress progress_;
  std::vector<const Task*> waiting_; ///< due, not started
  std::map<const Task*, Clock::time_point> running_;
  std::map<std::string, std::pair<double, int>> measured_; ///< by solver: sum of wall times [s], and how many
};

} // namespace settle::compare
