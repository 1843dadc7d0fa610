/// \file
/// Writing and reading result files (HDF5). The only part of the project that knows HDF5.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "settle/exchange/result.hpp"

namespace settle::exchange {

/// Version of the result format this build writes and reads.
inline constexpr int result_version = 1;

/// Writes a result stage by stage to `NAME.partial`; `finish` renames it, so a file with its final name is complete.
/// A writer that is destroyed before `finish` leaves the partial file for inspection and the final name untouched.
class ResultWriter {
public:
  /// Creates the partial file. Throws FileError where that cannot be done.
  ResultWriter(std::filesystem::path file, const Case& study, const std::string& solver, const Used& used);
  ResultWriter(ResultWriter&&) noexcept;
  ResultWriter& operator=(ResultWriter&&) noexcept;
  ~ResultWriter();

  /// Appends one stage. Throws FileError on a failed write, std::logic_error for vectors whose sizes do not
  /// belong together (a defect of the solver that calls).
  void write(const Stage& stage);
  /// Writes wall time, thread count, failure and status, closes and renames. Throws FileError.
  void finish(double wall_time, int threads, const std::optional<Failure>& failure = {});

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads a whole result. Throws FileError for a missing, truncated, incomplete or foreign file, another version
/// (VersionError), or a dataset that is missing or has another shape than its fellows.
Result read_result(const std::filesystem::path& file);

} // namespace settle::exchange
