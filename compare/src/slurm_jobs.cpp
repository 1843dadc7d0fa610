#include "settle/compare/slurm_jobs.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/process.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

constexpr double patience = 120.0; ///< with Slurm's controller, which its commands try to reach for a while [s]

/// What was asked of Slurm is not left half done: whoever interrupts this waits for the answer, or interrupts again.
const std::atomic<bool> never{false};

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream parts(line);
  for (std::string field; std::getline(parts, field, '|');)
    fields.push_back(field);
  return fields;
}

/// "12_3", "12_[4-9]" or "12": number of the job, and in its array.
void split_id(const std::string& text, SlurmJob& job) {
  const auto line = text.find('_');
  job.id = text.substr(0, line);
  job.task = line == std::string::npos ? "N/A" : text.substr(line + 1);
}

bool has_succeeded(const CapturedOutput& answer) {
  return answer.outcome.end == ProcessEnd::exited && answer.outcome.code == 0;
}

std::string said(const CapturedOutput& answer) {
  if (answer.outcome.end == ProcessEnd::timed_out) return fmt::format("no answer within {} s", patience);
  const auto last = answer.text.find_last_not_of(" \n");
  return last == std::string::npos ? "nothing" : answer.text.substr(0, last + 1);
}

} // namespace

bool has_ended(std::string_view state) {
  constexpr std::array<std::string_view, 10> ends{"BOOT_FAIL", "CANCELLED",     "COMPLETED", "DEADLINE", "FAILED",
                                                  "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "REVOKED",  "TIMEOUT"};
  return std::find(ends.begin(), ends.end(), state) != ends.end();
}

void require_slurm() {
  if (!find_in_path("sbatch").empty()) return;
  throw exchange::InputError({.where = "--executor slurm",
                              .what = "there is no Slurm on this machine",
                              .given = "no sbatch in PATH",
                              .allowed = {},
                              .remedy = "run this where jobs are submitted, or leave --executor out"});
}

std::string submit_job(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"--parsable"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const CapturedOutput answer = run_captured(find_in_path("sbatch"), words, patience, never);
  const std::string id = answer.text.substr(0, answer.text.find_first_of(";\n")); // "12" or "12;cluster"
  const bool is_number = !id.empty() && id.find_first_not_of("0123456789") == std::string::npos;
  if (has_succeeded(answer) && is_number) return id;
  throw exchange::InputError({.where = "sbatch",
                              .what = "Slurm does not take the job",
                              .given = said(answer),
                              .allowed = {},
                              .remedy = fmt::format("the options it was given: {}", fmt::join(arguments, " "))});
}

std::vector<SlurmJob> listed_jobs(const std::vector<std::string>& names) {
  const fs::path program = find_in_path("squeue");
  const std::vector<std::string> words{"--noheader",
                                       "--array",
                                       "--me",
                                       "--states=all",
                                       fmt::format("--name={}", fmt::join(names, ",")),
                                       "--format=%F|%K|%T|%r|%j"};
  CapturedOutput answer;
  if (!program.empty()) answer = run_captured_whole(program, words, patience, never);
  if (!has_succeeded(answer))
    throw exchange::FileError({.where = "squeue",
                               .what = "Slurm does not say how its jobs are",
                               .given = program.empty() ? "no squeue in PATH" : said(answer),
                               .allowed = {},
                               .remedy = "what was submitted goes on; the same command finds it again"});
  std::vector<SlurmJob> jobs;
  std::istringstream lines(answer.text);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() == 5)
      jobs.push_back({.id = fields[0], .task = fields[1], .state = fields[2], .reason = fields[3], .name = fields[4]});
  }
  return jobs;
}

std::vector<SlurmJob> accounted_jobs(const std::vector<std::string>& ids) {
  const fs::path program = find_in_path("sacct");
  if (program.empty()) return {};
  const CapturedOutput answer =
      run_captured_whole(program,
                         {"--noheader", "--parsable2", "--allocations", "--format=JobID,State,JobName",
                          fmt::format("--jobs={}", fmt::join(ids, ","))},
                         patience, never);
  if (!has_succeeded(answer)) return {};
  std::vector<SlurmJob> jobs;
  std::istringstream lines(answer.text);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != 3) continue;
    SlurmJob& job = jobs.emplace_back();
    split_id(fields[0], job);
    job.state = fields[1].substr(0, fields[1].find(' ')); // "CANCELLED by 1000"
    job.name = fields[2];
  }
  return jobs;
}

} // namespace settle::compare
