#include <fmt/format.h>

#include "settle/exchange/codec.hpp"

namespace settle::exchange {

bool Range::contains(double number) const {
  const bool high_enough = !lowest || (lowest_open ? number > *lowest : number >= *lowest);
  const bool low_enough = !highest || (highest_open ? number < *highest : number <= *highest);
  return high_enough && low_enough;
}

std::string Range::text() const {
  if (lowest && highest && *lowest == *highest) return fmt::format(" equal to {}", *lowest);
  std::string result;
  if (lowest) result += fmt::format(" {} {}", lowest_open ? "above" : highest ? "from" : "of at least", *lowest);
  if (lowest && highest) result += lowest_open ? " and" : " to";
  if (highest)
    result += fmt::format(" {}{}", highest_open ? "below " : lowest && !lowest_open ? "" : "up to ", *highest);
  return result;
}

Range above(double lowest) {
  return {.lowest = lowest, .lowest_open = true};
}

Range at_least(double lowest) {
  return {.lowest = lowest};
}

Range exactly(double number) {
  return {.lowest = number, .highest = number};
}

Range from_to(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest};
}

Range from_to_below(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest, .highest_open = true};
}

Range above_to(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest, .lowest_open = true};
}

Range between(double lowest, double highest) {
  return {.lowest = lowest, .highest = highest, .lowest_open = true, .highest_open = true};
}

} // namespace settle::exchange
