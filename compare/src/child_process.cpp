#include "child_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "settle/compare/process_memory.hpp"

namespace settle::compare {
namespace {

/// A file descriptor that no other child inherits.
class Descriptor {
public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { reset(); }
  void reset(int number = -1) {
    if (number_ >= 0) close(number_);
    number_ = number;
  }
  [[nodiscard]] int number() const { return number_; }

private:
  int number_;
};

/// What the child does between vfork and exec, in its parent's memory: nothing but calls of the system. Writes `errno`
/// where it fails.
[[noreturn]] void become(const char* program, char* const* arguments, int input, int log, int complaint, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const bool orphaned = getppid() != parent; // the parent died before the line above
  if (!orphaned && dup2(input, STDIN_FILENO) >= 0 && dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0)
    execv(program, arguments);
  const int failure = errno;
  [[maybe_unused]] const auto ignored = write(complaint, &failure, sizeof failure);
  _exit(127);
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double peak_memory(const rusage& used) {
  constexpr double kibibyte = 1024.0;
  return kibibyte * static_cast<double>(used.ru_maxrss);
}

/// Of this program [B].
double own_peak_memory() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return peak_memory(used);
}

} // namespace

Child::Child(const ProcessRequest& request) {
  start(request);
  if (id_ > 0) handle_ = static_cast<int>(syscall(SYS_pidfd_open, id_, 0));
}

void Child::start(const ProcessRequest& request) {
  std::vector<std::string> words{request.program.string()};
  words.insert(words.end(), request.arguments.begin(), request.arguments.end());
  const std::vector<char*> arguments = pointers_to(words);
  constexpr mode_t for_all = 0666;
  const Descriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const Descriptor log(open(request.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, for_all));
  std::array<int, 2> ends{-1, -1};
  if (log.number() < 0 || input.number() < 0 || pipe2(ends.data(), O_CLOEXEC) != 0) {
    problem_ = (log.number() < 0 ? request.log.string() + ": " : "") + std::strerror(errno);
    return;
  }
  const Descriptor reading(ends[0]);
  Descriptor writing(ends[1]);
  const pid_t parent = getpid();
  id_ = vfork(); // a copy of the driver's pages would cost both of them more than the rest of the start
  if (id_ == 0)
    become(request.program.c_str(), arguments.data(), input.number(), log.number(), writing.number(), parent);
  starters_peak_ = own_peak_memory();
  writing.reset(); // ours: the child's closes when it becomes the program
  int failure = id_ < 0 ? errno : 0;
  if (id_ > 0 && read(reading.number(), &failure, sizeof failure) > 0) {
    waitpid(id_, nullptr, 0);
    id_ = -1;
  }
  if (id_ < 0) problem_ = std::strerror(failure);
}

Child::~Child() {
  if (id_ > 0) {
    kill_group();
    waitpid(id_, nullptr, 0);
  }
  if (handle_ >= 0) close(handle_);
}

bool Child::wait(std::chrono::milliseconds most) {
  if (has_ended_within(most)) return true;
  seen_peak_ = std::max(seen_peak_, peak_memory_of(id_));
  return false;
}

bool Child::has_ended_within(std::chrono::milliseconds most) const {
  if (handle_ >= 0) {
    pollfd ended{.fd = handle_, .events = POLLIN, .revents = 0};
    return poll(&ended, 1, static_cast<int>(most.count())) > 0;
  }
  siginfo_t info{};
  const auto id = static_cast<id_t>(id_);
  if (waitid(P_PID, id, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == id_) return true;
  std::this_thread::sleep_for(std::min(most, std::chrono::milliseconds(2)));
  return false;
}

void Child::kill_group() const {
  kill(-id_, SIGKILL); // the group's number is not given away while its leader is not reaped
}

void Child::reap(ProcessOutcome& outcome) {
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOWAIT);
  kill_group();
  int status = 0;
  rusage used{};
  wait4(id_, &status, 0, &used);
  id_ = -1;
  outcome.end = WIFSIGNALED(status) ? ProcessEnd::signalled : ProcessEnd::exited;
  outcome.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  outcome.cpu_time = seconds(used.ru_utime) + seconds(used.ru_stime);
  // What the kernel tells is never less than what its starter had at the start, whose memory it shared for a moment.
  const double told = peak_memory(used);
  outcome.peak_memory = told > starters_peak_ || seen_peak_ == 0 ? told : seen_peak_;
}

} // namespace settle::compare
