/// \file
/// "Did you mean": the nearest spelling among allowed words.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace settle::exchange {

/// The candidate with the smallest edit distance to `word`, if it is near enough to be a likely slip.
std::optional<std::string> nearest_spelling(std::string_view word, const std::vector<std::string>& candidates);

} // namespace settle::exchange
