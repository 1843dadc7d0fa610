/// \file
/// What of a campaign has been submitted to Slurm, noted in DIR/slurm/submission.json beside scripts and logs of its
/// jobs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace settle::compare {

/// An array of jobs, one a solver run, all of one budget.
struct SubmittedArray {
  std::string name{};
  std::string id{};                     ///< Slurm's number; empty: not submitted yet
  double time_limit = 0;                ///< of each [s]
  std::optional<double> memory_limit{}; ///< of each [B]; nothing: the partition's
  std::vector<std::string> titles{};    ///< "RUN, SOLVER" of each, by its number in the array
};

struct Submission {
  std::string fingerprint{}; ///< of the plan it was made from
  std::string command{};     ///< that submitted it
  double moment = 0;         ///< of submission [s since 1970]
  std::vector<SubmittedArray> arrays{};
  std::string judge_name{};
  std::string judge_id{}; ///< of the job that judges when all others have ended
  bool judged = false;    ///< it has written verdicts and report
};

/// DIR/slurm.
std::filesystem::path slurm_folder(const std::filesystem::path& campaign_folder);

/// Nothing where nothing is submitted. Throws FileError for a note that cannot be read.
std::optional<Submission> read_submission(const std::filesystem::path& campaign_folder);

/// Throws FileError where it cannot be written.
void write_submission(const Submission& submission, const std::filesystem::path& campaign_folder);

/// Forgets a submission whose end has been shown.
void discard_submission(const std::filesystem::path& campaign_folder);

} // namespace settle::compare
