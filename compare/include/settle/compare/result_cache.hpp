/// \file
/// Results that need not be computed again: a record beside each result says what it was made from, what it holds, and
/// what it has cost. A result counts as whole only with a record that fits its content, so nothing that a kill, a full
/// disk or a power cut leaves behind is taken for one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace settle::compare {

/// What a result is made from.
struct MadeFrom {
  std::string case_hash;   ///< SHA-256 of the case with its defaults
  std::string solver_hash; ///< of the program; empty where it is not installed
  int format = 0;          ///< version of the result format

  bool operator==(const MadeFrom&) const = default;
};

/// For this build's result format.
MadeFrom made_from(const std::string& case_text, const std::string& solver_hash);

/// A file's content, and what tells in a moment that nobody has touched it since.
struct FileStamp {
  std::uintmax_t size = 0;  ///< [B]
  std::int64_t changed = 0; ///< modification time [ns]
  std::string hash;         ///< SHA-256
};

/// How an attempt has ended that left no result.
struct FailedAttempt {
  std::string status{}; ///< "crashed", ... as `SolverStatus` is called, or `submitted`
  int exit_code = 0;
  std::string message{};
  std::string tail{}; ///< the last lines of the solver's output
};

/// The status of an attempt that a scheduler was asked for and that has not ended yet.
constexpr std::string_view submitted = "submitted";

/// The last attempt of a solver at a run.
struct RunRecord {
  MadeFrom made_from{};
  double wall_time = 0;              ///< of the process [s]
  double cpu_time = 0;               ///< of it and its children [s]
  double peak_memory = 0;            ///< largest resident set [B]
  std::optional<FileStamp> result{}; ///< nothing where the attempt failed
  std::optional<FailedAttempt> failure{};
};

/// Why a solver is run, or not.
enum class Reason {
  up_to_date,
  never_run,
  failed_before,
  case_changed,
  solver_changed,
  format_changed,
  damaged,
  forced
};

/// "up to date", "new", "failed before", "case changed", ...
std::string_view name_of(Reason reason);

/// The record of a result; nothing where there is none that can be read.
std::optional<RunRecord> read_record(const std::filesystem::path& result_file);

/// Is the result there, whole, and made from this? Reads its content only where size or time have changed.
Reason reason_to_run(const std::filesystem::path& result_file, const std::optional<RunRecord>& record,
                     const MadeFrom& made_from);

/// Removes a result and what is unfinished of it; its record stays, without which its cost would be forgotten.
void discard_result(const std::filesystem::path& result_file);

/// Makes sure that the result is on the disk, stamps it, and then notes the record beside it. Throws FileError.
void note_success(const std::filesystem::path& result_file, RunRecord record);

/// Writes the record as it is: without a stamp, of an attempt that failed. Throws FileError.
void note_record(const std::filesystem::path& result_file, const RunRecord& record);

} // namespace settle::compare
