#include "settle/compare/folder_lock.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// When a process started, in the kernel's ticks, so that its number given to another is noticed; 0 where there is
/// none, or one that has ended and waits to be reaped.
unsigned long long start_of(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::stringstream content;
  content << file.rdbuf();
  const std::string text = content.str();
  const auto name_end = text.rfind(')'); // a name may hold anything
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(text.substr(name_end + 1));
  constexpr int between = 18; // the state is field 3, the start is field 22 (proc(5))
  std::string state, skipped;
  if (!(fields >> state) || state == "Z" || state == "X") return 0;
  for (int i = 0; i < between; ++i)
    fields >> skipped;
  unsigned long long start = 0;
  fields >> start;
  return start;
}

/// Who holds a lock, as it has written it.
struct Holder {
  pid_t process = 0;
  unsigned long long start = 0;
  std::string host{}, since{};

  [[nodiscard]] bool is_dead() const { return host == host_name() && process > 0 && start_of(process) != start; }
};

Holder holder_of(const fs::path& file) {
  Holder holder;
  std::ifstream(file) >> holder.process >> holder.start >> holder.host >> holder.since;
  return holder;
}

void write_holder(int descriptor) {
  const std::string text = fmt::format("{} {} {} {}\n", getpid(), start_of(getpid()), host_name(), exchange::utc_now());
  if (ftruncate(descriptor, 0) != 0) return; // a full disk: the lock holds without the text
  [[maybe_unused]] const auto written = pwrite(descriptor, text.data(), text.size(), 0);
}

/// Has a process inherited the lock that `dead` has taken? Whoever only waits for it has the file open without a lock.
bool has_inherited(const fs::path& process, const fs::path& file, pid_t dead) {
  std::error_code gone; // a process may end at any moment, or be somebody else's
  for (const fs::directory_entry& entry : fs::directory_iterator(process / "fd", gone)) {
    if (fs::read_symlink(entry.path(), gone) != file) continue;
    std::ifstream facts(process / "fdinfo" / entry.path().filename());
    for (std::string word; facts >> word;) { // lock: 1: FLOCK ADVISORY WRITE 4711 ... (proc(5))
      std::string kind, mode;
      pid_t taker = -1; // 0 where a process that is dead has no number in this namespace
      if (word == "FLOCK" && facts >> kind >> mode >> taker && (taker == dead || taker == 0)) return true;
    }
  }
  return false;
}

/// Ends what a campaign that has died has left running: every process that has inherited its lock.
void end_leftovers(const fs::path& file, pid_t dead) {
  std::error_code failure;
  const fs::path whole = fs::canonical(file, failure);
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", failure)) {
    const pid_t process = std::atoi(entry.path().filename().c_str()); // 0 for what is no process
    if (process > 0 && has_inherited(entry.path(), whole, dead)) kill(process, SIGKILL);
  }
}

bool take(int descriptor, LockKind kind = LockKind::alone) {
  return flock(descriptor, (kind == LockKind::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0;
}

bool wait_for_share(int descriptor) {
  constexpr int attempts = 600;
  constexpr auto pause = std::chrono::milliseconds(100);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (take(descriptor, LockKind::shared)) return true;
    std::this_thread::sleep_for(pause);
  }
  return false;
}

/// Takes the lock of a campaign that has died, as soon as what it has left running has ended.
bool take_over(int descriptor, const fs::path& file) {
  constexpr int attempts = 50;
  constexpr auto pause = std::chrono::milliseconds(20);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Holder holder = holder_of(file);
    if (!holder.is_dead()) return false;
    end_leftovers(file, holder.process);
    if (take(descriptor)) return true;
    std::this_thread::sleep_for(pause);
  }
  return false;
}

[[noreturn]] void throw_locked(const fs::path& folder, const Holder& holder) {
  throw exchange::InputError(
      {.where = folder.string(),
       .what = "another campaign is at work in this folder",
       .given = fmt::format("process {} on {}, since {}", holder.process, holder.host, holder.since),
       .allowed = "one campaign at a time",
       .remedy = "wait for its end, or choose another folder with --out"});
}

[[noreturn]] void throw_shared(const fs::path& folder) {
  throw exchange::InputError({.where = folder.string(),
                              .what = "single runs of this campaign are at work in this folder",
                              .given = {},
                              .allowed = "a campaign, or single runs (--only-run)",
                              .remedy = "wait for their end, or choose another folder with --out"});
}

} // namespace

FolderLock::FolderLock(const fs::path& folder, LockKind kind) {
  const fs::path file = folder / ".lock";
  constexpr mode_t for_all = 0666;
  descriptor_ = open(file.c_str(), O_RDWR | O_CREAT, for_all); // inherited by solvers on purpose
  if (descriptor_ < 0)
    throw exchange::FileError({.where = file.string(),
                               .what = "the folder cannot be locked",
                               .given = std::strerror(errno),
                               .allowed = {},
                               .remedy = "choose another place with --out"});
  if (kind == LockKind::shared && wait_for_share(descriptor_)) return;
  if (kind == LockKind::alone && (take(descriptor_) || take_over(descriptor_, file))) {
    write_holder(descriptor_);
    return;
  }
  const bool is_shared = take(descriptor_, LockKind::shared);
  close(descriptor_);
  if (is_shared) throw_shared(folder);
  throw_locked(folder, holder_of(file));
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

} // namespace settle::compare
