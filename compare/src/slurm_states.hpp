/// \file
/// How the jobs of a submission are, task by task.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "settle/compare/slurm_jobs.hpp"
#include "settle/compare/submission.hpp"

namespace settle::compare {

class SlurmStates {
public:
  explicit SlurmStates(const std::vector<SlurmJob>& jobs);
  /// A job by its name and, in an array, its number; nullptr where Slurm does not know it any more.
  [[nodiscard]] const SlurmJob* find(const std::string& name, std::size_t number) const;
  [[nodiscard]] const SlurmJob* find(const std::string& name) const;

private:
  std::map<std::pair<std::string, std::string>, SlurmJob> jobs_; ///< (name, number)
  std::map<std::string, SlurmJob> rest_;                         ///< tasks of an array that are listed as one
};

/// The names of all jobs of a submission.
std::vector<std::string> names_of(const Submission& submission);

} // namespace settle::compare
