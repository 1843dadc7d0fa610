#include "settle/compare/process.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

#include <boost/process/search_path.hpp>

#include "child_process.hpp"
#include "settle/compare/process_memory.hpp"
#include "settle/compare/text_file.hpp"
#include "temporary_folder.hpp"

namespace settle::compare {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Why a child that runs has to be killed; `exited` where it may go on.
ProcessEnd reason_to_kill(const ProcessRequest& request, const std::atomic<bool>& stop, Clock::time_point start,
                          const Child& child) {
  if (stop) return ProcessEnd::stopped;
  if (seconds_since(start) > request.time_limit) return ProcessEnd::timed_out;
  if (memory_of(child.id()) > request.memory_limit) return ProcessEnd::out_of_memory;
  return ProcessEnd::exited;
}

/// A scheduler that ends a job tells each of its processes by itself, the child maybe a moment before this one.
bool is_told_too(const ProcessOutcome& outcome, const std::atomic<bool>& stop) {
  constexpr int looks = 25;
  constexpr auto pause = std::chrono::milliseconds(20);
  if (outcome.end != ProcessEnd::signalled || outcome.code != SIGTERM) return false;
  for (int look = 0; look < looks && !stop; ++look)
    std::this_thread::sleep_for(pause);
  return stop;
}

/// Runs a program, what it prints into a file that is gone afterwards.
CapturedOutput captured(ProcessRequest request, const std::atomic<bool>& stop,
                        const std::function<std::string(const std::filesystem::path&)>& read) {
  const TemporaryFolder folder;
  request.log = folder.file("output");
  CapturedOutput output{.outcome = run_process(request, stop), .text = {}};
  output.text = read(request.log);
  return output;
}

} // namespace

ProcessOutcome run_process(const ProcessRequest& request, const std::atomic<bool>& stop) {
  ProcessOutcome outcome;
  const auto start = Clock::now();
  constexpr auto between_looks = std::chrono::milliseconds(20);
  Child child(request);
  if (!child.problem().empty()) {
    outcome.problem = child.problem();
    return outcome;
  }
  ProcessEnd killed_for = ProcessEnd::exited;
  while (killed_for == ProcessEnd::exited && !child.wait(between_looks))
    killed_for = reason_to_kill(request, stop, start, child);
  if (killed_for != ProcessEnd::exited) child.kill_group();
  child.reap(outcome);
  if (killed_for != ProcessEnd::exited) outcome.end = killed_for;
  if (is_told_too(outcome, stop)) outcome.end = ProcessEnd::stopped;
  outcome.wall_time = seconds_since(start);
  return outcome;
}

CapturedOutput run_captured(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                            double time_limit, const std::atomic<bool>& stop) {
  constexpr std::size_t all_lines = 1000;
  return captured({.program = program, .arguments = arguments, .time_limit = time_limit}, stop,
                  [](const std::filesystem::path& log) { return tail_of(log, all_lines); });
}

CapturedOutput run_captured_whole(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                  double time_limit, const std::atomic<bool>& stop) {
  return captured({.program = program, .arguments = arguments, .time_limit = time_limit}, stop, read_text);
}

std::filesystem::path find_in_path(const std::string& program) {
  return {boost::process::search_path(program).string()};
}

std::string tail_of(const std::filesystem::path& file, std::size_t lines) {
  std::ifstream input(file, std::ios::binary | std::ios::ate);
  if (!input) return {};
  constexpr std::streamoff most = 16384;
  const auto size = static_cast<std::streamoff>(input.tellg());
  const std::streamoff length = std::min(size, most);
  input.seekg(size - length);
  std::string text(static_cast<std::size_t>(length), '\0');
  input.read(text.data(), length);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r'))
    text.pop_back();
  std::size_t begin = text.size();
  for (std::size_t line = 0; line < lines && begin != std::string::npos; ++line) {
    begin = begin == 0 ? std::string::npos : text.rfind('\n', begin - 1);
  }
  return begin == std::string::npos ? text : text.substr(begin + 1);
}

} // namespace settle::compare
