/// \file
/// A campaign by Slurm: its solver runs as arrays of jobs, each `settle campaign FILE --only-run`, and a job that
/// judges them all (`--judge-only`) when they have ended. Nothing here runs or judges: the jobs do what a person could
/// type.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/campaign_plan.hpp"
#include "settle/compare/campaign_progress.hpp"
#include "settle/compare/submission.hpp"

namespace settle::compare {

struct SlurmOptions {
  std::filesystem::path folder{};     ///< of the campaign
  std::vector<std::string> command{}; ///< settle campaign FILE --out DIR ..., without what is to be run of it
  std::vector<std::string> options{}; ///< for sbatch, with every job
  std::optional<int> at_once{};       ///< so many jobs of an array at a time; nothing: as many as Slurm likes
};

/// Throws InputError for an option that is none, or one of those that `settle` sets itself. `where` names their place.
void require_free_options(const std::vector<std::string>& options, const std::string& where);

/// What a plan's submission is recognised by: its tasks, what they are made from, in their order.
std::string fingerprint_of(const Plan& plan);

/// The arrays for all tasks that are due, one for each budget and thousand tasks, the longest runs first; nothing is
/// submitted, but the tasks' records say that it is about to be. `command`: as it was typed. Throws FileError where the
/// campaign's folder cannot be written.
Submission plan_submission(const Plan& plan, const SlurmOptions& options, const std::string& command);

/// Submits what of it has not been submitted yet, and notes each number as soon as Slurm has given it; what an earlier
/// attempt has submitted without being able to note it is found by its name. Throws InputError where Slurm refuses.
void submit(Submission& submission, const SlurmOptions& options);

/// The numbers of all its jobs, for squeue and scancel.
std::vector<std::string> job_ids(const Submission& submission);

/// Is one of its jobs waiting or running? Throws FileError where Slurm does not say.
bool is_at_work(const Submission& submission);

/// What somebody who follows a campaign is told: how it comes along, and in words why jobs wait where that is not only
/// for their turn.
struct SlurmNews {
  std::function<void(const Progress&)> progress{};
  std::function<void(const std::string&)> waiting{};
};

/// Tells how the tasks come along until the job that judges has ended. Throws FileError where Slurm does not say, and
/// Error with exit code 130 when `stop` becomes true: the jobs go on.
void follow(Plan& plan, const Submission& submission, const SlurmNews& news, const std::atomic<bool>& stop);

/// Notes in the record of every task whose job has ended without doing so what Slurm says of that: out of time, out of
/// memory, cancelled, ...
void note_lost_jobs(Plan& plan, const Submission& submission, const std::filesystem::path& folder);

} // namespace settle::compare
