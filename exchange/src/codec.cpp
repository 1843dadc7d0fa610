#include "settle/exchange/codec.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace settle::exchange {
namespace {

using document::entry;
using document::List;
using document::Table;
using document::Value;

Value text_value(std::string text) {
  return {std::move(text), {}};
}

document::Entry type_entry(std::string type) {
  return entry("type", text_value(std::move(type)));
}

std::string with_unit(std::string text, std::string_view unit) {
  return unit.empty() ? text : fmt::format("{} [{}]", text, unit);
}

/// The JSON Schema of a range, its limits written as `Number`.
template <class Number>
void add_range(const Range& range, Table& schema) {
  const auto add = [&schema](const char* key, double limit) {
    schema.push_back(entry(key, {static_cast<Number>(limit), {}}));
  };
  if (range.lowest) add(range.lowest_open ? "exclusiveMinimum" : "minimum", *range.lowest);
  if (range.highest) add(range.highest_open ? "exclusiveMaximum" : "maximum", *range.highest);
}

} // namespace

void RealCodec::read(const Given& given, double& member, Reading& reading) const {
  const auto* integer = std::get_if<std::int64_t>(&given.value.data);
  const auto* real = std::get_if<double>(&given.value.data);
  if (integer == nullptr && real == nullptr) {
    reading.complain_type(given, allowed());
    return;
  }
  const double number = real != nullptr ? *real : static_cast<double>(*integer);
  if (std::isfinite(number) && info_.range.contains(number)) {
    member = number;
  } else {
    reading.complain_value(given, allowed(), std::string(info_.hint));
  }
}

std::optional<Value> RealCodec::write(const double& member) const {
  return Value{member, {}};
}

Table RealCodec::schema() const {
  Table schema{type_entry("number")};
  add_range<double>(info_.range, schema);
  return schema;
}

std::string RealCodec::allowed() const {
  return with_unit("a number" + info_.range.text(), info_.unit);
}

void IntegerCodec::read(const Given& given, int& member, Reading& reading) const {
  const auto* integer = std::get_if<std::int64_t>(&given.value.data);
  if (integer == nullptr) {
    reading.complain_type(given, allowed());
    return;
  }
  const bool fits = *integer >= std::numeric_limits<int>::min() && *integer <= std::numeric_limits<int>::max();
  if (fits && info_.range.contains(static_cast<double>(*integer))) {
    member = static_cast<int>(*integer);
  } else {
    reading.complain_value(given, allowed(), std::string(info_.hint));
  }
}

std::optional<Value> IntegerCodec::write(const int& member) const {
  return Value{std::int64_t{member}, {}};
}

Table IntegerCodec::schema() const {
  Table schema{type_entry("integer")};
  add_range<std::int64_t>(info_.range, schema);
  using Limits = std::numeric_limits<int>;
  if (!info_.range.lowest) schema.push_back(entry("minimum", {std::int64_t{Limits::min()}, {}}));
  if (!info_.range.highest) schema.push_back(entry("maximum", {std::int64_t{Limits::max()}, {}}));
  return schema;
}

std::string IntegerCodec::allowed() const {
  return with_unit("an integer" + info_.range.text(), info_.unit);
}

void BooleanCodec::read(const Given& given, bool& member, Reading& reading) const {
  if (const auto* boolean = std::get_if<bool>(&given.value.data)) {
    member = *boolean;
  } else {
    reading.complain_type(given, allowed());
  }
}

std::optional<Value> BooleanCodec::write(const bool& member) const {
  return Value{member, {}};
}

Table BooleanCodec::schema() const {
  return {type_entry("boolean")};
}

std::string BooleanCodec::allowed() const {
  return "true or false";
}

void TextCodec::read(const Given& given, std::string& member, Reading& reading) const {
  const auto* text = std::get_if<std::string>(&given.value.data);
  if (text == nullptr) {
    reading.complain_type(given, allowed());
  } else if (text->empty() && info_.required) {
    reading.complain_value(given, allowed(), std::string(info_.hint));
  } else {
    member = *text;
  }
}

std::optional<Value> TextCodec::write(const std::string& member) const {
  return text_value(member);
}

Table TextCodec::schema() const {
  Table schema{type_entry("string")};
  if (info_.required) schema.push_back(entry("minLength", {std::int64_t{1}, {}}));
  return schema;
}

std::string TextCodec::allowed() const {
  return info_.required ? "a text that is not empty" : "a text";
}

void RealOrWordCodec::read(const Given& given, std::optional<double>& member, Reading& reading) const {
  const auto* text = std::get_if<std::string>(&given.value.data);
  if (text == nullptr) {
    real_.read(given, member.emplace(), reading);
  } else if (*text == word_) {
    member.reset();
  } else {
    reading.complain_value(given, allowed());
  }
}

std::optional<Value> RealOrWordCodec::write(const std::optional<double>& member) const {
  return member ? real_.write(*member) : text_value(word_);
}

Table RealOrWordCodec::schema() const {
  const Table word{entry("const", text_value(word_))};
  return {entry("anyOf", {List{{real_.schema(), {}}, {word, {}}}, {}})};
}

std::string RealOrWordCodec::allowed() const {
  return fmt::format("\"{}\" or {}", word_, real_.allowed());
}

Words::Words(std::span<const std::string_view> names, std::optional<std::size_t> unwritable)
    : names_(names.begin(), names.end()), unwritable_(unwritable) {}

std::optional<std::size_t> Words::read(const Given& given, Reading& reading) const {
  const auto* word = std::get_if<std::string>(&given.value.data);
  if (word == nullptr) {
    reading.complain_type(given, "one of the words " + allowed());
    return std::nullopt;
  }
  std::vector<std::string> writable;
  for (std::size_t index = 0; index < names_.size(); ++index) {
    if (index == unwritable_) continue;
    if (names_[index] == *word) return index;
    writable.push_back(names_[index]);
  }
  reading.complain_word(given, writable);
  return std::nullopt;
}

std::optional<Value> Words::write(std::size_t index) const {
  return index == unwritable_ ? std::nullopt : std::optional(text_value(names_[index]));
}

Table Words::schema() const {
  List words;
  for (std::size_t index = 0; index < names_.size(); ++index)
    if (index != unwritable_) words.push_back(text_value(names_[index]));
  return {entry("enum", {std::move(words), {}})};
}

std::string Words::allowed() const {
  std::vector<std::string> words;
  for (std::size_t index = 0; index < names_.size(); ++index)
    if (index != unwritable_) words.push_back(fmt::format("\"{}\"", names_[index]));
  return fmt::format("{}", fmt::join(words, ", "));
}

} // namespace settle::exchange
