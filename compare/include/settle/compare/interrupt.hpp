/// \file
/// Ctrl-C: remembered, so that children can be stopped in order.
#pragma once

#include <atomic>

namespace settle::compare {

/// Becomes true on SIGINT or SIGTERM after `watch_interrupts`; a second signal ends the program at once.
const std::atomic<bool>& interrupted();

/// Installs the handlers, once, from the program's main thread.
void watch_interrupts();

} // namespace settle::compare
