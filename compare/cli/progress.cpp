#include "progress.hpp"

#include <cstdio>

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace settle::compare::cli {
namespace {

constexpr std::size_t line_width = 110;

std::string ended_line(const Progress& progress) {
  const SolverRun& solver = *progress.ended;
  return fmt::format("[{}/{}] {}, {}: {}{}, {:.2f} s\n", progress.finished, progress.total, progress.run, solver.solver,
                     name_of(solver.status), solver.reused ? " (up to date, used again)" : "", solver.wall_time);
}

} // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const Progress& progress) {
  const bool failed = progress.ended != nullptr && progress.ended->status != SolverStatus::finished;
  if (progress.ended != nullptr && (failed || !terminal_)) {
    clear();
    fmt::print(stderr, "{}", ended_line(progress));
  }
  if (!terminal_) return;
  std::string line = fmt::format("[{}/{}] {}", progress.finished, progress.total, fmt::join(progress.running, "; "));
  if (line.size() > line_width) line = line.substr(0, line_width - 3) + "...";
  fmt::print(stderr, "\r\x1b[K{}", line);
  std::fflush(stderr);
}

void ProgressLine::clear() const {
  if (terminal_) fmt::print(stderr, "\r\x1b[K");
}

} // namespace settle::compare::cli
