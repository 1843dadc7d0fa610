#include "settle/compare/campaign_plan.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include "settle/compare/process_memory.hpp"
#include "settle/compare/run_folder.hpp"
#include "settle/compare/solver_programs.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/spelling.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

std::string hash_of(const fs::path& program) {
  return program.empty() ? std::string() : exchange::sha256(read_text(program));
}

std::string hash_of(const JoinedSolver& solver) {
  return program_of(solver).empty() ? std::string() : exchange::sha256(key_of(solver));
}

std::optional<JoinedSolver> joined_in(const ExpandedRun& run, const std::string& solver) {
  const auto found = run.joined.find(solver);
  return found != run.joined.end() ? std::optional(found->second) : std::nullopt;
}

/// Hashes of the solvers' programs, each read once.
class SolverHashes {
public:
  const std::string& of(const std::string& solver, const std::optional<JoinedSolver>& joined) {
    const auto [entry, is_new] = hashes_.try_emplace(solver);
    if (is_new) entry->second = joined ? hash_of(*joined) : hash_of(find_solver(solver));
    return entry->second;
  }

private:
  std::map<std::string, std::string> hashes_;
};

/// What a solver may have where its run does not say [B]: more would drive the machine into the arms of the kernel's
/// own killer, which may choose somebody else.
double default_memory_limit() {
  constexpr double left_to_others = 0.1;
  return (1.0 - left_to_others) * machine_memory();
}

SolverJob job_of(const ExpandedRun& run, const std::string& solver, const fs::path& folder, double memory_limit) {
  return {.solver = solver,
          .joined = joined_in(run, solver),
          .case_file = run.case_file,
          .overrides = run.overrides,
          .result_file = result_in(run_folder(folder, run.name), solver),
          .time_limit = run.time_limit,
          .memory_limit = run.memory_limit.value_or(memory_limit)};
}

double cost_of(const Task& task) {
  return task.record ? task.record->wall_time : std::numeric_limits<double>::infinity();
}

} // namespace

Plan plan_campaign(std::vector<ExpandedRun> runs, const fs::path& folder, bool fresh) {
  Plan plan{.runs = std::move(runs), .tasks = {}};
  SolverHashes hashes;
  const double memory_limit = default_memory_limit();
  for (std::size_t r = 0; r < plan.runs.size(); ++r) {
    const ExpandedRun& run = plan.runs[r];
    const std::string case_text = exchange::to_toml(run.study);
    for (std::size_t s = 0; s < run.solvers.size(); ++s)
      plan.tasks.push_back(
          {.run = r,
           .solver = s,
           .job = job_of(run, run.solvers[s], folder, memory_limit),
           .made_from = made_from(case_text, hashes.of(run.solvers[s], joined_in(run, run.solvers[s])))});
  }
  look_again(plan, fresh);
  return plan;
}

void look_again(Plan& plan, bool fresh) {
  for (Task& task : plan.tasks) {
    look_again(task);
    if (fresh && task.reason == Reason::up_to_date) task.reason = Reason::forced;
  }
}

void look_again(Task& task) {
  task.record = read_record(task.job.result_file);
  task.reason = reason_to_run(task.job.result_file, task.record, task.made_from);
}

std::string title_of(const Plan& plan, const Task& task) {
  return plan.runs[task.run].name + ", " + task.job.solver;
}

Task& task_titled(Plan& plan, const std::string& title) {
  std::vector<std::string> titles;
  for (Task& task : plan.tasks) {
    titles.push_back(title_of(plan, task));
    if (titles.back() == title) return task;
  }
  const auto nearest = exchange::nearest_spelling(title, titles);
  throw exchange::InputError({.where = "--only-run",
                              .what = "the campaign has no such run",
                              .given = title,
                              .allowed = "RUN, SOLVER as progress and --dry-run show them",
                              .remedy = nearest ? "did you mean " + *nearest + "?" : ""});
}

std::vector<std::size_t> order_of(const Plan& plan) {
  std::vector<std::size_t> order(plan.tasks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Task& first = plan.tasks[a];
    const Task& second = plan.tasks[b];
    if (first.is_due() != second.is_due()) return first.is_due();
    return first.is_due() && cost_of(first) > cost_of(second);
  });
  return order;
}

std::size_t due(const Plan& plan) {
  return static_cast<std::size_t>(
      std::count_if(plan.tasks.begin(), plan.tasks.end(), [](const Task& task) { return task.is_due(); }));
}

} // namespace settle::compare
