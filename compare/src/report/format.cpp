#include "format.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace settle::compare::report {

namespace {

/// Without escape sequences (ESC [ ... letter) and control characters.
std::string without_control_characters(const std::string& text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == 0x1b && i + 1 < text.size() && text[i + 1] == '[') {
      i += 2;
      while (i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) == 0)
        ++i;
      continue;
    }
    if ((c >= 0x20 && c != 0x7f) || c == '\n' || c == '\t') kept += text[i];
  }
  return kept;
}

/// Decimals with which a number of this size has so many significant digits.
int decimals_of(double size, int significant) {
  return std::max(0, significant - 1 - static_cast<int>(std::floor(std::log10(size))));
}

} // namespace

std::string number(double value, int significant) {
  if (std::isnan(value)) return std::string(no_value);
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  const std::string sign = value < 0 ? "−" : "";
  if (size < 1e-4 || size >= 1e6) return fmt::format("{}{:.{}e}", sign, size, std::max(0, significant - 2));
  return fmt::format("{}{:.{}f}", sign, size, decimals_of(size, significant));
}

std::string number_beside(double value, double scale, int significant) {
  const double largest = std::abs(scale);
  if (!std::isfinite(value) || !(largest >= 1e-4 && largest < 1e6)) return number(value, significant);
  return fmt::format("{}{:.{}f}", value < 0 ? "−" : "", std::abs(value), decimals_of(largest, significant));
}

std::string ratio(double value) {
  if (!std::isfinite(value) || (std::abs(value) < 1e-5 && value != 0.0)) return number(value, 3);
  return number(100.0 * value, 3) + " %";
}

std::string percent(double value) {
  const long whole = std::lround(100.0 * value);
  return fmt::format("{}{} %", whole < 0 ? "−" : "", std::labs(whole));
}

std::string difference(double value, double reference) {
  const double relative = (value - reference) / std::abs(reference);
  if (!std::isfinite(relative)) return std::string(no_value);
  if (std::abs(relative) < 1e-6) return "0.0 %";
  const double percent = 100.0 * relative;
  const int decimals = std::abs(percent) < 0.1 ? 3 : std::abs(percent) < 10 ? 2 : 1;
  return fmt::format("{}{:.{}f} %", percent < 0 ? "−" : "+", std::abs(percent), decimals);
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return std::string(no_value);
  if (seconds < 10.0) return fmt::format("{:.2f} s", seconds);
  if (seconds < 60.0) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long>(std::lround(seconds));
  return fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

std::string slug(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (letter < 0x80 && std::isalnum(letter) != 0) {
      name += static_cast<char>(std::tolower(letter));
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-')
    name.pop_back();
  return name;
}

std::string printable(const std::string& text) {
  using nlohmann::json;
  const std::string valid = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  return without_control_characters(json::parse(valid).get<std::string>());
}

} // namespace settle::compare::report
