/// \file
/// Errors meant for the people who run the programs, and the exit codes they end in.
#pragma once

#include <stdexcept>
#include <string>

namespace settle::exchange {

/// What every program of the suite returns to the shell.
enum class ExitCode : int {
  success = 0,         ///< finished; for `settle`: every verdict passed
  verdict_failed = 1,  ///< the programs ran, at least one verdict is not "passed"
  bad_input = 2,       ///< a case, a campaign or a command line cannot be used
  solver_failed = 3,   ///< a solver did not converge, crashed or ran out of time
  file_failed = 4,     ///< a result or reference is missing or corrupt, or an output cannot be written
  internal_error = 70, ///< a defect of the program itself
  interrupted = 130,   ///< Ctrl-C
};

/// One complaint in the order a reader needs it. Empty members are not printed.
struct Complaint {
  std::string where{};   ///< `file:line:column`, a command-line option, or a path
  std::string what{};    ///< what is wrong, one clause, no full stop
  std::string given{};   ///< the value that was found
  std::string allowed{}; ///< what would have been accepted
  std::string remedy{};  ///< what to do about it
};

/// `where: what`, then one indented line for each of given, allowed and remedy.
std::string to_text(const Complaint& complaint);

/// Base of all errors that end a program with a message and an exit code.
class Error : public std::runtime_error {
public:
  Error(ExitCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
  [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
  ExitCode code_;
};

/// The user's input cannot be used (exit code 2).
class InputError : public Error {
public:
  explicit InputError(const Complaint& complaint) : Error(ExitCode::bad_input, to_text(complaint)) {}
  explicit InputError(const std::string& text) : Error(ExitCode::bad_input, text) {}
};

/// A solver did not reach a solution (exit code 3).
class NotConverged : public Error {
public:
  explicit NotConverged(const Complaint& complaint) : Error(ExitCode::solver_failed, to_text(complaint)) {}
};

/// A file cannot be read as what it should be, or cannot be written (exit code 4).
class FileError : public Error {
public:
  explicit FileError(const Complaint& complaint) : Error(ExitCode::file_failed, to_text(complaint)) {}
};

/// A file has a version of its format that this build does not read.
class VersionError : public FileError {
public:
  using FileError::FileError;
};

} // namespace settle::exchange
