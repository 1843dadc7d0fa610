#include "settle/compare/process.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/group.hpp>
#include <boost/process/io.hpp>
#include <boost/process/search_path.hpp>

#include "settle/exchange/errors.hpp"

namespace settle::compare {
namespace {

namespace bp = boost::process;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void fill_from_status(int status, ProcessOutcome& outcome) {
  if (WIFSIGNALED(status)) {
    outcome.end = ProcessEnd::signalled;
    outcome.code = WTERMSIG(status);
  } else {
    outcome.end = ProcessEnd::exited;
    outcome.code = WEXITSTATUS(status);
  }
}

void kill_group(bp::child& child, bp::group& group) {
  std::error_code gone; // it may have ended in the meantime
  group.terminate(gone);
  child.wait(gone);
}

/// Waits by asking: waiting with a time limit by signals does not work with several threads that all have children.
void wait(const ProcessRequest& request, const std::atomic<bool>& stop, Clock::time_point start, bp::child& child,
          bp::group& group, ProcessOutcome& outcome) {
  auto pause = std::chrono::milliseconds(1);
  constexpr auto longest_pause = std::chrono::milliseconds(20);
  std::error_code failure;
  while (child.running(failure)) {
    const bool late = seconds_since(start) > request.time_limit;
    if (stop || late) {
      kill_group(child, group);
      outcome.end = stop ? ProcessEnd::stopped : ProcessEnd::timed_out;
      return;
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, longest_pause);
  }
  if (failure) {
    outcome.problem = failure.message();
    return;
  }
  fill_from_status(child.native_exit_code(), outcome);
}

/// A file with a name of its own that is gone afterwards.
class ScratchFile {
public:
  ScratchFile() : path_((std::filesystem::temp_directory_path() / "settle-output-XXXXXX").string()) {
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) {
      throw exchange::FileError({.where = path_,
                                 .what = "a temporary file cannot be created",
                                 .given = {},
                                 .allowed = {},
                                 .remedy = "set TMPDIR to a folder that can be written"});
    }
    close(descriptor);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() {
    std::error_code ignored; // nothing is lost with a temporary file that stays
    std::filesystem::remove(path_, ignored);
  }
  [[nodiscard]] std::filesystem::path path() const { return path_; }

private:
  std::string path_;
};

} // namespace

ProcessOutcome run_process(const ProcessRequest& request, const std::atomic<bool>& stop) {
  ProcessOutcome outcome;
  const auto start = Clock::now();
  std::error_code failure;
  bp::group group;
  try {
    bp::child child(request.program.string(), bp::args(request.arguments),
                    bp::std_in<bp::null, (bp::std_out & bp::std_err)> request.log.string(), group, failure);
    if (failure) {
      outcome.problem = failure.message();
    } else {
      wait(request, stop, start, child, group, outcome);
    }
  } catch (const std::exception& error) { // a log that cannot be opened
    outcome.problem = error.what();
  }
  outcome.wall_time = seconds_since(start);
  return outcome;
}

CapturedOutput run_captured(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                            double time_limit, const std::atomic<bool>& stop) {
  const ScratchFile log;
  CapturedOutput output;
  output.outcome =
      run_process({.program = program, .arguments = arguments, .log = log.path(), .time_limit = time_limit}, stop);
  constexpr std::size_t all_lines = 1000;
  output.text = tail_of(log.path(), all_lines);
  return output;
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
