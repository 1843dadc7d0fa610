/// \file
/// Internal assertions: our own bugs, never the user's input. On in Debug and audit builds.
#pragma once

#include <string>

#include <fmt/format.h>

namespace settle::exchange {

/// Prints the failed condition with its arguments to standard error and aborts.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line, const std::string& values);

/// The arguments of a failed assertion, separated by commas.
template <class... Values>
std::string assertion_values(const Values&... values) {
  std::string text;
  ((text += fmt::format("{}{}", text.empty() ? "" : ", ", values)), ...);
  return text;
}

} // namespace settle::exchange

#ifdef SETTLE_ENABLE_ASSERTIONS
/// Aborts with the values printed when `condition` does not hold.
#define SETTLE_ASSERT(condition, ...)                                                                                  \
  ((condition) ? void(0)                                                                                               \
               : ::settle::exchange::assertion_failed(#condition, __FILE__, __LINE__,                                  \
                                                      ::settle::exchange::assertion_values(__VA_ARGS__)))
#else
#define SETTLE_ASSERT(condition, ...) void(0)
#endif
