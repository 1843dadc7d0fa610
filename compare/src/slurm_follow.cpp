#include <algorithm>
#include <array>
#include <chrono>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/process.hpp"
#include "settle/compare/slurm_campaign.hpp"
#include "settle/compare/slurm_jobs.hpp"
#include "settle/compare/task_run.hpp"
#include "settle/exchange/errors.hpp"
#include "slurm_states.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

bool is_awaited(const Task& task) {
  return task.record && task.record->failure && task.record->failure->status == submitted;
}

/// A task with its place among the jobs.
struct Followed {
  Task* task = nullptr;
  std::string name{}; ///< of its array
  std::size_t number = 0;
  bool started = false;
  int looks = 0; ///< since its job has ended, without a record that says so
};

std::vector<Followed> followed_of(Plan& plan, const Submission& submission) {
  std::vector<Followed> all;
  for (const SubmittedArray& array : submission.arrays) {
    for (std::size_t number = 0; number < array.titles.size(); ++number)
      all.push_back({.task = &task_titled(plan, array.titles[number]), .name = array.name, .number = number});
  }
  return all;
}

/// Waits between two looks: hardly at first, up to ten seconds for what takes minutes.
void pause_after(Clock::time_point start, const std::atomic<bool>& stop) {
  constexpr double shortest = 0.3, longest = 10.0, share = 0.05;
  const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  const auto until = Clock::now() + std::chrono::duration<double>(std::clamp(share * elapsed, shortest, longest));
  while (!stop && Clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

/// Does a job wait for its turn, as all do?
bool is_ordinary(const std::string& reason) {
  constexpr std::array<std::string_view, 6> ordinary{"None",       "Priority",          "Resources",
                                                     "Dependency", "JobArrayTaskLimit", "BeginTime"};
  return std::find(ordinary.begin(), ordinary.end(), reason) != ordinary.end();
}

class Following {
public:
  Following(Plan& plan, const Submission& submission, const SlurmNews& news)
      : submission_(submission), waiting_(followed_of(plan, submission)),
        observer_(plan, static_cast<int>(std::max<std::size_t>(waiting_.size(), 1)), news.progress), news_(news) {
    for (Task& task : plan.tasks) {
      const bool is_followed = std::any_of(waiting_.begin(), waiting_.end(),
                                           [&](const Followed& followed) { return followed.task == &task; });
      if (!is_followed) show_end(task, true);
    }
  }

  /// True: everything has ended.
  bool look() {
    const std::vector<SlurmJob> jobs = listed_jobs(names_of(submission_));
    say_why(jobs);
    const SlurmStates states(jobs);
    const SlurmJob* judge = states.find(submission_.judge_name);
    const bool is_over = judge == nullptr || has_ended(judge->state);
    for (Followed& followed : waiting_)
      look_at(followed, states.find(followed.name, followed.number), is_over);
    std::erase_if(waiting_, [](const Followed& followed) { return followed.task == nullptr; });
    return is_over;
  }

private:
  /// Once for each set of reasons.
  void say_why(const std::vector<SlurmJob>& jobs) {
    std::set<std::string> reasons;
    for (const SlurmJob& job : jobs) {
      if (job.state == "PENDING" && !is_ordinary(job.reason)) reasons.insert(job.reason);
    }
    if (reasons == said_) return;
    said_ = reasons;
    if (!reasons.empty()) news_.waiting(fmt::format("jobs wait: {}", fmt::join(reasons, ", ")));
  }

  void look_at(Followed& followed, const SlurmJob* job, bool is_over) {
    const bool waits =
        job != nullptr && !has_ended(job->state) && job->state != "RUNNING" && job->state != "COMPLETING";
    if (waits && !is_over) return;
    if (!followed.started) observer_.started(*followed.task);
    followed.started = true;
    const bool runs = job != nullptr && !has_ended(job->state);
    if (runs && !is_over) return;
    look_again(*followed.task);
    constexpr int patience = 3; // a record may reach this machine later than the news that its job has ended
    if (is_awaited(*followed.task) && !is_over && ++followed.looks < patience) return;
    show_end(*followed.task, false);
    followed.task = nullptr;
  }

  void show_end(const Task& task, bool was_done_before) {
    SolverRun run = recorded_end(task);
    run.reused = was_done_before;
    if (was_done_before) observer_.started(task);
    observer_.ended(task, run);
  }

  const Submission& submission_;
  std::vector<Followed> waiting_;
  Observer observer_;
  const SlurmNews& news_;
  std::set<std::string> said_;
};

/// What Slurm knows of the jobs, now or from its accounting.
SlurmStates all_states(const Submission& submission) {
  std::vector<SlurmJob> jobs = accounted_jobs(job_ids(submission));
  const std::vector<SlurmJob> listed = listed_jobs(names_of(submission));
  jobs.insert(jobs.end(), listed.begin(), listed.end()); // these are newer
  return SlurmStates(jobs);
}

SolverStatus status_of(const std::string& state) {
  if (state == "TIMEOUT" || state == "DEADLINE") return SolverStatus::timed_out;
  if (state == "OUT_OF_MEMORY") return SolverStatus::out_of_memory;
  return SolverStatus::crashed;
}

/// The end of a task that its job did not live to note.
FailedAttempt lost(const SlurmJob* job, const fs::path& log) {
  constexpr std::size_t last_lines = 15;
  FailedAttempt failure{.tail = tail_of(log, last_lines)};
  if (job == nullptr) {
    failure.status = name_of(SolverStatus::no_result);
    failure.message = "its job in Slurm has ended without noting how, and Slurm does not know it any more";
    return failure;
  }
  failure.status = name_of(status_of(job->state));
  failure.message = fmt::format("Slurm has ended its job {}_{}: {}", job->id, job->task, job->state);
  return failure;
}

} // namespace

void follow(Plan& plan, const Submission& submission, const SlurmNews& news, const std::atomic<bool>& stop) {
  const auto start = Clock::now();
  Following following(plan, submission, news);
  while (!stop && !following.look())
    pause_after(start, stop);
  if (stop)
    throw exchange::Error(exchange::ExitCode::interrupted,
                          fmt::format("no longer followed; the runs go on in Slurm, and the same command follows them "
                                      "again\n  to end them: scancel {}",
                                      fmt::join(job_ids(submission), " ")));
}

void note_lost_jobs(Plan& plan, const Submission& submission, const fs::path& folder) {
  std::vector<Followed> awaited = followed_of(plan, submission);
  std::erase_if(awaited, [](const Followed& followed) { return !is_awaited(*followed.task); });
  if (awaited.empty()) return;
  const SlurmStates states = all_states(submission);
  for (const Followed& followed : awaited) {
    const fs::path log = slurm_folder(folder) / fmt::format("{}_{}.log", followed.name, followed.number);
    followed.task->record->failure = lost(states.find(followed.name, followed.number), log);
    note_record(followed.task->job.result_file, *followed.task->record);
  }
}

} // namespace settle::compare
