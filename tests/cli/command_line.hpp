/// \file
/// Running `settle` in a test, with solvers played by shell scripts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scratch_folder.hpp"
#include "settle/exchange/case.hpp"

namespace settle::compare::test {

/// How a program ended and what it printed.
struct Answer {
  int code = -1;
  std::string text; ///< standard output and standard error
};

/// `time_limit`: wall time, which it is a failure to reach [s].
Answer run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   double time_limit = 60.0);

/// A folder, a case in it, and solvers that hand over a perfect result unless a test says otherwise.
class CommandLine : public testing::Test {
protected:
  CommandLine();
  ~CommandLine() override;
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  [[nodiscard]] static Answer settle(const std::vector<std::string>& arguments);
  /// `settle run` of the case into `out`.
  [[nodiscard]] Answer run_case(const std::vector<std::string>& more = {}) const;

  /// Shell commands that play a solver once it is not asked to --check; `$out` is the result it has to write.
  void play(const std::string& solver, const std::string& body) const;
  /// The solver copies this file to its result.
  void play_perfect(const std::string& solver) const;
  /// How often a played solver has run (not counting --check).
  [[nodiscard]] int runs_of(const std::string& solver) const;

  [[nodiscard]] std::filesystem::path out() const { return folder.path() / "out"; }
  [[nodiscard]] std::filesystem::path result(const std::string& solver) const;
  [[nodiscard]] std::filesystem::path prepared(const std::string& solver) const;

  ScratchFolder folder;
  exchange::Case study;
  std::filesystem::path case_file;
};

/// The whole content of a file.
std::string content_of(const std::filesystem::path& file);

} // namespace settle::compare::test
