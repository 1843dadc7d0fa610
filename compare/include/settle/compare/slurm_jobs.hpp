/// \file
/// Slurm as its users see it: sbatch, squeue, and sacct where accounting is on.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace settle::compare {

/// A job, or one task of an array of jobs.
struct SlurmJob {
  std::string id{};    ///< of the job, or of the whole array
  std::string task{};  ///< its number in the array; "N/A" of a job that is none, "0-9" of tasks that Slurm lists as one
  std::string state{}; ///< "PENDING", "RUNNING", "COMPLETED", ...
  std::string reason{}; ///< why it waits, or ended
  std::string name{};
};

/// Will a job of this state never run again?
bool has_ended(std::string_view state);

/// Throws InputError where there is no Slurm to submit to.
void require_slurm();

/// Submits a job (`sbatch --parsable ARGUMENTS`); its number. Throws InputError with what sbatch says where it refuses.
std::string submit_job(const std::vector<std::string>& arguments);

/// All jobs of some names that Slurm still knows, those that have ended for some minutes too, the tasks of an array one
/// by one. Throws FileError where squeue is not there, or gets no answer.
std::vector<SlurmJob> listed_jobs(const std::vector<std::string>& names);

/// The same by number and from Slurm's accounting; nothing where there is none.
std::vector<SlurmJob> accounted_jobs(const std::vector<std::string>& ids);

} // namespace settle::compare
