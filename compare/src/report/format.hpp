/// \file
/// Numbers and texts as a report shows them.
#pragma once

#include <string>
#include <string_view>

namespace settle::compare::report {

/// What stands where there is no number.
inline constexpr std::string_view no_value = "–";

/// A number with so many significant digits: plain between 1e-4 and 1e6, with an exponent outside.
std::string number(double value, int significant = 4);
/// A number with the decimals that `scale`, the largest of its column, has with so many significant digits.
std::string number_beside(double value, double scale, int significant = 5);
/// A ratio: in percent from 1e-5 upwards, with an exponent below.
std::string ratio(double value);
/// A ratio in whole percent.
std::string percent(double value);
/// A difference relative to `reference`, in percent with its sign.
std::string difference(double value, double reference);
/// A duration: "0.03 s", "12.4 s", "2 min 05 s".
std::string duration(double seconds);
/// An identifier made of lower-case letters, digits and hyphens.
std::string slug(std::string_view text);
/// The text as valid UTF-8 without control characters (newline and tabulator stay) and terminal colours.
std::string printable(const std::string& text);

} // namespace settle::compare::report
