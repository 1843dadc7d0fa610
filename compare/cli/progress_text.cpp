#include "progress_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace settle::compare::cli {
namespace {

std::string bar(std::size_t finished, std::size_t total) {
  constexpr std::size_t width = 20;
  const std::size_t full = total > 0 ? width * finished / total : width;
  return fmt::format("[{}{}]", std::string(full, '#'), std::string(width - full, '-'));
}

} // namespace

std::string time_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  constexpr long minute = 60;
  constexpr long hour = 3600;
  if (whole < minute) return fmt::format("{} s", whole);
  if (whole < hour) return fmt::format("{} min {} s", whole / minute, whole % minute);
  return fmt::format("{} h {} min", whole / hour, whole % hour / minute);
}

std::string ended_line(const Progress& progress) {
  const SolverRun& solver = *progress.ended;
  return fmt::format("[{}/{}] {}, {}: {}{}, {:.2f} s", progress.finished, progress.total, progress.run, progress.solver,
                     name_of(solver.status), solver.reused ? " (up to date, used again)" : "", solver.wall_time);
}

std::string progress_line(const Progress& progress, std::size_t width) {
  std::string line = fmt::format("{} {}/{}", bar(progress.finished, progress.total), progress.finished, progress.total);
  if (progress.seconds_left && progress.finished < progress.total)
    line += fmt::format(", {} left", time_text(*progress.seconds_left));
  if (!progress.running.empty()) line += fmt::format(": {}", fmt::join(progress.running, "; "));
  return line.size() > width ? line.substr(0, width - 3) + "..." : line;
}

std::string plan_text(const Plan& plan) {
  std::string text;
  for (const std::size_t index : order_of(plan)) {
    const Task& task = plan.tasks[index];
    if (!task.is_due()) continue;
    const std::string cost = task.record ? fmt::format(", {:.2f} s the last time", task.record->wall_time) : "";
    text += fmt::format("{}, {}: {}{}\n", plan.runs[task.run].name, task.job.solver, name_of(task.reason), cost);
  }
  const std::size_t to_run = due(plan);
  return text + fmt::format("{} of {} solver runs to do, {} up to date\n", to_run, plan.tasks.size(),
                            plan.tasks.size() - to_run);
}

} // namespace settle::compare::cli
