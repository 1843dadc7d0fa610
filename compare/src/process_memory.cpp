#include "settle/compare/process_memory.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace settle::compare {
namespace {

namespace fs = std::filesystem;

double own_memory(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/statm", process));
  double size = 0, resident = 0, shared = 0; // pages
  if (!(file >> size >> resident >> shared)) return 0;
  return (resident - shared) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double own_peak_memory(pid_t process) {
  constexpr double kibibyte = 1024.0;
  std::ifstream file(fmt::format("/proc/{}/status", process));
  for (std::string word; file >> word;)
    if (double most = 0; word == "VmHWM:" && file >> most) return kibibyte * most;
  return 0;
}

std::vector<pid_t> children_of(pid_t process) {
  std::vector<pid_t> all;
  std::error_code gone; // a process may end at any moment
  for (const fs::directory_entry& thread : fs::directory_iterator(fmt::format("/proc/{}/task", process), gone)) {
    std::ifstream children(thread.path() / "children");
    for (pid_t child = 0; children >> child;)
      all.push_back(child);
  }
  return all;
}

/// What a control group allows [B]; infinite where it says "max" or there is no such file.
double allowed_by(const fs::path& file) {
  double bytes = 0;
  return std::ifstream(file) >> bytes ? bytes : std::numeric_limits<double>::infinity();
}

/// What Slurm has given to the job this runs in [B]; infinite outside one.
double allowed_by_slurm() {
  constexpr double mebibyte = 1048576.0;
  const char* given = std::getenv("SLURM_MEM_PER_NODE");
  const double mebibytes = given != nullptr ? std::atof(given) : 0.0; // 0: all of the node's
  return mebibytes > 0 ? mebibytes * mebibyte : std::numeric_limits<double>::infinity();
}

} // namespace

double memory_of(pid_t process) {
  double memory = own_memory(process);
  for (const pid_t child : children_of(process))
    memory += memory_of(child);
  return memory;
}

double peak_memory_of(pid_t process) {
  double memory = own_peak_memory(process);
  for (const pid_t child : children_of(process))
    memory = std::max(memory, peak_memory_of(child));
  return memory;
}

double machine_memory() {
  const double physical = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::min({physical, allowed_by_slurm(), allowed_by("/sys/fs/cgroup/memory.max"),
                   allowed_by("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
}

} // namespace settle::compare
