#include "settle/compare/campaign_progress.hpp"

#include <algorithm>

namespace settle::compare {

Observer::Observer(const Plan& plan, int jobs, std::function<void(const Progress&)> tell)
    : plan_(plan), jobs_(jobs), tell_(std::move(tell)) {
  progress_.total = plan.tasks.size();
  for (const Task& task : plan.tasks)
    if (task.is_due()) waiting_.push_back(&task);
}

void Observer::started(const Task& task) {
  const std::scoped_lock lock(mutex_);
  std::erase(waiting_, &task);
  running_[&task] = Clock::now();
  progress_.running.push_back(title(task));
  report(task, nullptr);
}

void Observer::ended(const Task& task, const SolverRun& solver) {
  const std::scoped_lock lock(mutex_);
  running_.erase(&task);
  progress_.running.erase(std::find(progress_.running.begin(), progress_.running.end(), title(task)));
  ++progress_.finished;
  if (!solver.reused) {
    auto& [sum, count] = measured_[solver.solver];
    sum += solver.wall_time;
    ++count;
  }
  report(task, &solver);
}

void Observer::report(const Task& task, const SolverRun* ended) {
  progress_.run = plan_.runs[task.run].name;
  progress_.solver = task.job.solver;
  progress_.reason = task.reason;
  progress_.ended = ended;
  progress_.seconds_left = seconds_left();
  if (tell_) tell_(progress_);
}

std::string Observer::title(const Task& task) const {
  return title_of(plan_, task);
}

/// What a task cost the last time, else what tasks of its solver have cost so far, on average [s].
std::optional<double> Observer::cost_of(const Task& task) const {
  if (task.record) return task.record->wall_time;
  const auto found = measured_.find(task.job.solver);
  if (found == measured_.end()) return {};
  const auto& [sum, count] = found->second;
  return sum / count;
}

std::optional<double> Observer::seconds_left() const {
  double sum = 0;
  double longest = 0;
  for (const Task* task : waiting_) {
    const auto cost = cost_of(*task);
    if (!cost) return {};
    sum += *cost;
    longest = std::max(longest, *cost);
  }
  for (const auto& [task, start] : running_) {
    const auto cost = task->is_due() ? cost_of(*task) : std::optional(0.0);
    if (!cost) return {};
    const double left = std::max(0.0, *cost - std::chrono::duration<double>(Clock::now() - start).count());
    sum += left;
    longest = std::max(longest, left);
  }
  return std::max(longest, sum / jobs_);
}

} // namespace settle::compare
