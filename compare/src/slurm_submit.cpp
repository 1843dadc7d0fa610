#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/campaign_run.hpp"
#include "settle/compare/command_words.hpp"
#include "settle/compare/slurm_campaign.hpp"
#include "settle/compare/slurm_jobs.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "slurm_states.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_array = 1000; // Slurm's MaxArraySize, where nobody has changed it, less one

/// What the jobs of one array have in common.
using Budget = std::pair<double, std::optional<double>>; // [s], [B]

double seconds_since_1970() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// A name that no other submission has.
std::string new_name(const fs::path& folder, double moment) {
  const std::string text = fmt::format("{} {} {}", fs::absolute(folder).string(), moment, getpid());
  return "settle-" + exchange::sha256(text).substr(0, 10);
}

/// Notes that a task is about to be submitted: what its record says of an earlier attempt must not be taken for the end
/// of this one. What it has cost stays.
void note_submitted(const Task& task) {
  RunRecord record = task.record.value_or(RunRecord{});
  record.made_from = task.made_from;
  record.result.reset();
  record.failure = {.status = std::string(submitted), .message = "it was submitted to Slurm, which has not run it"};
  note_record(task.job.result_file, record);
}

std::vector<SubmittedArray> arrays_of(const Plan& plan, const std::vector<std::string>& folder_complaints,
                                      const std::string& name) {
  std::vector<SubmittedArray> arrays;
  std::map<Budget, std::size_t> open; // the array of a budget that is being filled
  for (const std::size_t index : order_of(plan)) {
    const Task& task = plan.tasks[index];
    if (!task.is_due() || !folder_complaints[task.run].empty()) continue;
    const Budget budget{plan.runs[task.run].time_limit, plan.runs[task.run].memory_limit};
    const auto found = open.find(budget);
    if (found == open.end() || arrays[found->second].titles.size() == longest_array) {
      open[budget] = arrays.size();
      arrays.push_back({.name = fmt::format("{}-{}", name, arrays.size() + 1),
                        .time_limit = budget.first,
                        .memory_limit = budget.second});
    }
    arrays[open.at(budget)].titles.push_back(title_of(plan, task));
    note_submitted(task);
  }
  return arrays;
}

/// A path in which sbatch finds no pattern to fill in.
std::string without_patterns(const fs::path& path) {
  std::string text;
  for (const char letter : path.string())
    text += letter == '%' ? "%%" : std::string(1, letter);
  return text;
}

/// Writes a script beside the note; it says what it was written for. Its path.
std::string write_script(const fs::path& folder, const std::string& name, const std::string& body) {
  const fs::path file = slurm_folder(folder) / (name + ".sh");
  write_text(file, "#!/bin/bash\n# written by settle for sbatch\n" + body);
  return file.string();
}

std::vector<std::string> common_arguments(const std::string& name, const std::string& log,
                                          const SlurmOptions& options) {
  return {"--job-name=" + name, "--chdir=" + fs::current_path().string(),
          "--output=" + without_patterns(fs::absolute(slurm_folder(options.folder))) + "/" + log};
}

/// Minutes that are enough for a solver to reach its own limit, and for what comes before and after it.
int minutes_for(double time_limit) {
  constexpr double minute = 60.0;
  return static_cast<int>(std::ceil(time_limit / minute)) + 1;
}

/// The same of memory [MiB]: settle itself takes some ten.
long mebibytes_for(double memory_limit) {
  constexpr double mebibyte = 1048576.0;
  constexpr long for_settle = 100;
  return static_cast<long>(std::ceil(memory_limit / mebibyte)) + for_settle;
}

std::vector<std::string> array_arguments(const SubmittedArray& array, const SlurmOptions& options) {
  std::vector<std::string> arguments = common_arguments(array.name, "%x_%a.log", options);
  const std::string limit = options.at_once ? fmt::format("%{}", *options.at_once) : "";
  arguments.push_back(fmt::format("--array=0-{}{}", array.titles.size() - 1, limit));
  arguments.push_back(fmt::format("--time={}", minutes_for(array.time_limit)));
  if (array.memory_limit) arguments.push_back(fmt::format("--mem={}M", mebibytes_for(*array.memory_limit)));
  arguments.insert(arguments.end(), options.options.begin(), options.options.end());
  std::string titles;
  for (const std::string& title : array.titles)
    titles += "  " + quoted(title) + "\n";
  arguments.push_back(write_script(options.folder, array.name,
                                   fmt::format("runs=(\n{})\nexec {} --only-run \"${{runs[$SLURM_ARRAY_TASK_ID]}}\"\n",
                                               titles, joined(options.command))));
  return arguments;
}

std::vector<std::string> judge_arguments(const Submission& submission, const SlurmOptions& options) {
  std::vector<std::string> arguments = common_arguments(submission.judge_name, "%x.log", options);
  std::vector<std::string> ids;
  for (const SubmittedArray& array : submission.arrays)
    ids.push_back(array.id);
  if (!ids.empty()) arguments.push_back(fmt::format("--dependency=afterany:{}", fmt::join(ids, ":")));
  arguments.insert(arguments.end(), options.options.begin(), options.options.end());
  arguments.push_back(write_script(options.folder, submission.judge_name,
                                   fmt::format("exec {} --judge-only --progress lines\n", joined(options.command))));
  return arguments;
}

void submit_rest(Submission& submission, const SlurmStates& known, const SlurmOptions& options) {
  for (SubmittedArray& array : submission.arrays) {
    if (!array.id.empty()) continue;
    const SlurmJob* job = known.find(array.name, 0);
    array.id = job != nullptr ? job->id : submit_job(array_arguments(array, options));
    write_submission(submission, options.folder);
  }
  if (!submission.judge_id.empty()) return;
  const SlurmJob* job = known.find(submission.judge_name);
  submission.judge_id = job != nullptr ? job->id : submit_job(judge_arguments(submission, options));
  write_submission(submission, options.folder);
}

} // namespace

void require_free_options(const std::vector<std::string>& options, const std::string& where) {
  constexpr std::array<std::string_view, 14> taken{"--array",    "-a",       "--dependency", "-d",      "--job-name",
                                                   "-J",         "--output", "-o",           "--chdir", "-D",
                                                   "--parsable", "--wrap",   "--wait",       "-W"};
  for (const std::string& option : options) {
    const std::string name = option.substr(0, option.find('='));
    const bool is_taken = std::find(taken.begin(), taken.end(), name) != taken.end();
    if (option.starts_with("-") && !is_taken) continue;
    throw exchange::InputError(
        {.where = where,
         .what = is_taken ? "settle sets this option of sbatch itself" : "this is no option of sbatch",
         .given = option,
         .allowed = fmt::format("options of sbatch but {}", fmt::join(taken, ", ")),
         .remedy = "for example --partition=short"});
  }
}

std::string fingerprint_of(const Plan& plan) {
  std::string text;
  for (const Task& task : plan.tasks)
    text += fmt::format("{}\n{} {} {}\n", title_of(plan, task), task.made_from.case_hash, task.made_from.solver_hash,
                        task.made_from.format);
  return exchange::sha256(text);
}

Submission plan_submission(const Plan& plan, const SlurmOptions& options, const std::string& command) {
  Submission submission{.fingerprint = fingerprint_of(plan), .command = command, .moment = seconds_since_1970()};
  const std::string name = new_name(options.folder, submission.moment);
  submission.arrays = arrays_of(plan, prepare_run_folders(plan, options.folder), name);
  submission.judge_name = name + "-judge";
  write_submission(submission, options.folder);
  return submission;
}

void submit(Submission& submission, const SlurmOptions& options) {
  const SlurmStates known(listed_jobs(names_of(submission)));
  try {
    submit_rest(submission, known, options);
  } catch (const exchange::InputError& refusal) {
    const std::vector<std::string> ids = job_ids(submission);
    if (ids.empty()) discard_submission(options.folder);
    if (ids.empty()) throw;
    throw exchange::InputError(fmt::format("{}\n  submitted before, and going on: the same command submits the rest, "
                                           "scancel {} ends them",
                                           refusal.what(), fmt::join(ids, " ")));
  }
}

std::vector<std::string> job_ids(const Submission& submission) {
  std::vector<std::string> ids;
  for (const SubmittedArray& array : submission.arrays)
    ids.push_back(array.id);
  ids.push_back(submission.judge_id);
  std::erase(ids, "");
  return ids;
}

bool is_at_work(const Submission& submission) {
  const std::vector<SlurmJob> jobs = listed_jobs(names_of(submission));
  return std::any_of(jobs.begin(), jobs.end(), [](const SlurmJob& job) { return !has_ended(job.state); });
}

} // namespace settle::compare
