#include "settle/compare/command_words.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "settle/exchange/errors.hpp"

namespace settle::compare {
namespace {

using exchange::InputError;

constexpr std::string_view blanks = " \t\n";

[[noreturn]] void complain(const std::string& command, const std::string& where, const std::string& what,
                           const std::string& allowed, const std::string& remedy) {
  throw InputError({.where = where, .what = what, .given = command, .allowed = allowed, .remedy = remedy});
}

/// Is the word, as it was typed, something that only a shell understands?
bool is_operator(std::string_view typed) {
  constexpr std::array<std::string_view, 6> between{"|", "||", "&&", "&", ";", "<"};
  if (std::find(between.begin(), between.end(), typed) != between.end()) return true;
  const bool numbered = typed.size() > 1 && (typed.front() == '1' || typed.front() == '2');
  return typed.substr(numbered ? 1 : 0).starts_with('>'); // > file, 2>&1, >>log
}

/// Reads one word after another.
class Splitter {
public:
  Splitter(const std::string& command, const std::string& where) : text_(command), where_(where) {}

  std::optional<std::string> next() {
    at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
    if (at_ == text_.size()) return {};
    const std::size_t begin = at_;
    std::string word;
    while (at_ < text_.size() && blanks.find(text_[at_]) == std::string_view::npos)
      take(word);
    const std::string typed = text_.substr(begin, at_ - begin);
    if (is_operator(typed)) {
      complain(text_, where_, "the command uses " + typed + ", but is run without a shell",
               "a program and its arguments", "write sh -c '...', or quote the word");
    }
    return word;
  }

private:
  void take(std::string& word) {
    const char letter = text_[at_++];
    if (letter == '\'') {
      take_quoted(word, '\'');
    } else if (letter == '"') {
      take_quoted(word, '"');
    } else if (letter == '\\' && at_ < text_.size()) {
      word += text_[at_++];
    } else {
      word += letter;
    }
  }
  /// Up to the closing quote; inside double quotes a backslash keeps its meaning before $ ` " and itself only.
  void take_quoted(std::string& word, char quote) {
    for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
      const bool escapes = quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() &&
                           std::string_view("$`\"\\").find(text_[at_ + 1]) != std::string_view::npos;
      if (escapes) ++at_;
      word += text_[at_];
    }
    if (at_ == text_.size()) {
      complain(text_, where_, std::string("a quote ") + quote + " is not closed", "quotes in pairs", {});
    }
    ++at_;
  }

  const std::string& text_;
  const std::string& where_;
  std::size_t at_ = 0;
};

} // namespace

std::vector<std::string> split_command(const std::string& command, const std::string& where) {
  std::vector<std::string> words;
  Splitter splitter(command, where);
  while (std::optional<std::string> word = splitter.next())
    words.push_back(std::move(*word));
  return words;
}

std::string quoted(const std::string& word) {
  const char* harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+:,@%";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string text(1, '\'');
  for (const char letter : word) {
    if (letter == '\'') text += "'\\'"; // leaves the quotes, a quote, enters them again
    text += letter;
  }
  text += '\'';
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words)
    line.append(line.empty() ? "" : " ").append(quoted(word));
  return line;
}

} // namespace settle::compare
