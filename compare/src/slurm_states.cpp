#include "slurm_states.hpp"

namespace settle::compare {

namespace {

constexpr const char* no_array = "N/A";

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

} // namespace

SlurmStates::SlurmStates(const std::vector<SlurmJob>& jobs) {
  for (const SlurmJob& job : jobs) {
    const bool is_one = is_number(job.task) || job.task == no_array;
    (is_one ? jobs_[{job.name, job.task}] : rest_[job.name]) = job;
  }
}

const SlurmJob* SlurmStates::find(const std::string& name, std::size_t number) const {
  if (const auto found = jobs_.find({name, std::to_string(number)}); found != jobs_.end()) return &found->second;
  const auto rest = rest_.find(name);
  return rest != rest_.end() ? &rest->second : nullptr;
}

const SlurmJob* SlurmStates::find(const std::string& name) const {
  const auto found = jobs_.find({name, no_array});
  return found != jobs_.end() ? &found->second : nullptr;
}

std::vector<std::string> names_of(const Submission& submission) {
  std::vector<std::string> names;
  for (const SubmittedArray& array : submission.arrays)
    names.push_back(array.name);
  names.push_back(submission.judge_name);
  return names;
}

} // namespace settle::compare
