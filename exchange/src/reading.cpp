#include "settle/exchange/reading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/exchange/spelling.hpp"

namespace settle::exchange {

void Reading::complain_type(const Given& given, const std::string& allowed) {
  complain({.where = given.value.where,
            .what = given.path + " has the wrong type",
            .given = fmt::format("{}: {}", document::type_name(given.value), document::to_inline_toml(given.value)),
            .allowed = allowed,
            .remedy = {}});
}

void Reading::complain_value(const Given& given, const std::string& allowed, const std::string& remedy) {
  complain({.where = given.value.where,
            .what = given.path + " is not an allowed value",
            .given = document::to_inline_toml(given.value),
            .allowed = allowed,
            .remedy = remedy});
}

void Reading::complain_word(const Given& given, const std::vector<std::string>& words) {
  const std::string& word = std::get<std::string>(given.value.data);
  const auto nearest = nearest_spelling(word, words);
  complain_value(given, fmt::format("{}", fmt::join(words, ", ")),
                 nearest ? fmt::format("did you mean {}?", *nearest) : std::string());
}

void Reading::throw_if_any() const {
  if (complaints_.empty()) return;
  std::vector<std::string> texts;
  for (const Complaint& complaint : complaints_)
    texts.push_back(to_text(complaint));
  throw InputError(fmt::format("{}", fmt::join(texts, "\n")));
}

std::string join(const std::string& path, const std::string& key) {
  return path.empty() ? key : fmt::format("{}.{}", path, key);
}

} // namespace settle::exchange
