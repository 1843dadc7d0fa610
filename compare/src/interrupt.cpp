#include "settle/compare/interrupt.hpp"

#include <csignal>

namespace settle::compare {
namespace {

// Signal handlers reach nothing but static storage.
std::atomic<bool> flag{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void remember(int signal) {
  flag = true;
  std::signal(signal, SIG_DFL);
}

} // namespace

const std::atomic<bool>& interrupted() {
  return flag;
}

void watch_interrupts() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

} // namespace settle::compare
