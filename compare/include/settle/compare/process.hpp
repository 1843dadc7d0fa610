/// \file
/// Running another program: its output to a file, limits on its time and memory, and an end that is always accounted
/// for.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace settle::compare {

/// What is started.
struct ProcessRequest {
  std::filesystem::path program{};
  std::vector<std::string> arguments{};
  std::filesystem::path log{};                                   ///< standard output and standard error, together
  double time_limit = 0;                                         ///< wall time [s]
  double memory_limit = std::numeric_limits<double>::infinity(); ///< of it and its children, see process_memory.hpp [B]
};

enum class ProcessEnd { exited, signalled, timed_out, out_of_memory, stopped, not_started };

struct ProcessOutcome {
  ProcessEnd end = ProcessEnd::not_started;
  int code = 0;           ///< exit code, or the number of the signal
  double wall_time = 0;   ///< [s]
  double cpu_time = 0;    ///< user and system, with its children [s]
  double peak_memory = 0; ///< largest resident set of it or one of its children [B]; where that is less than this
                          ///< program's own was at the start, as seen some milliseconds before the end at the latest
  std::string problem{};  ///< why it could not be started
};

/// Runs a program in a process group of its own and waits for its end. At a limit, or when `stop` becomes true, the
/// whole group is killed; when the program ends, what it has left running in its group is killed too. The program is
/// killed when this one dies, whatever from. Never throws for what the program does, or for a program that cannot be
/// started.
ProcessOutcome run_process(const ProcessRequest& request, const std::atomic<bool>& stop);

/// How a program ended and the end of what it printed.
struct CapturedOutput {
  ProcessOutcome outcome;
  std::string text; ///< standard output and standard error, at most the last 16 KiB
};

/// Runs a program for what it prints. Throws FileError where there is no place for a temporary file.
CapturedOutput run_captured(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                            double time_limit, const std::atomic<bool>& stop);

/// The same with all it printed, however long that is.
CapturedOutput run_captured_whole(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                  double time_limit, const std::atomic<bool>& stop);

/// A file in the folders of PATH; empty where there is none.
std::filesystem::path find_in_path(const std::string& program);

/// The last lines of a text file, without trailing blank lines; empty where it cannot be read.
std::string tail_of(const std::filesystem::path& file, std::size_t lines);

} // namespace settle::compare
