#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "settle/exchange/document.hpp"

namespace settle::exchange::document {
namespace {

bool is_bare_key(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char letter) {
    return letter < 128 && (std::isalnum(letter) != 0 || letter == '_' || letter == '-');
  });
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') {
      result += fmt::format("\\{}", letter);
    } else if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
    } else {
      result += letter;
    }
  }
  return result + '"';
}

std::string key_text(const std::string& key) {
  return is_bare_key(key) ? key : quoted(key);
}

/// A table stands under a header of its own; so does a list of tables.
bool has_header(const Value& value) {
  const auto* list = std::get_if<List>(&value.data);
  const bool tables = list != nullptr && !list->empty() && std::holds_alternative<Table>(list->front().data);
  return tables || std::holds_alternative<Table>(value.data);
}

void write_table(const Table& table, const std::string& path, std::string& text);

/// A table of nothing but tables needs no header of its own.
bool holds_only_tables(const Table& table) {
  return !table.empty() &&
         std::all_of(table.begin(), table.end(), [](const Entry& entry) { return has_header(entry.value); });
}

void write_section(const std::string& header, const Table& table, const std::string& path, std::string& text) {
  text += fmt::format("{}{}\n", text.empty() ? "" : "\n", header);
  write_table(table, path, text);
}

void write_headed(const Entry& entry, const std::string& path, std::string& text) {
  const std::string inside = path.empty() ? key_text(entry.key) : path + "." + key_text(entry.key);
  if (const auto* table = std::get_if<Table>(&entry.value.data)) {
    if (holds_only_tables(*table)) {
      write_table(*table, inside, text);
    } else {
      write_section("[" + inside + "]", *table, inside, text);
    }
    return;
  }
  for (const Value& item : std::get<List>(entry.value.data))
    write_section("[[" + inside + "]]", std::get<Table>(item.data), inside, text);
}

void write_table(const Table& table, const std::string& path, std::string& text) {
  for (const Entry& entry : table)
    if (!has_header(entry.value)) text += fmt::format("{} = {}\n", key_text(entry.key), to_inline_toml(entry.value));
  for (const Entry& entry : table)
    if (has_header(entry.value)) write_headed(entry, path, text);
}

std::string real_text(double real) {
  const std::string text = fmt::format("{}", real);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

struct InlineToml {
  std::string operator()(bool boolean) const { return boolean ? "true" : "false"; }
  std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
  std::string operator()(double real) const { return real_text(real); }
  std::string operator()(const std::string& text) const { return quoted(text); }
  std::string operator()(const List& list) const {
    std::string text;
    for (const Value& item : list)
      text += (text.empty() ? "" : ", ") + to_inline_toml(item);
    return "[" + text + "]";
  }
  std::string operator()(const Table& table) const {
    std::string text;
    for (const Entry& entry : table)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key_text(entry.key), to_inline_toml(entry.value));
    return "{" + text + "}";
  }
};

nlohmann::ordered_json json_of(const Value& value);

struct Json {
  nlohmann::ordered_json operator()(bool boolean) const { return boolean; }
  nlohmann::ordered_json operator()(std::int64_t integer) const { return integer; }
  nlohmann::ordered_json operator()(double real) const { return real; }
  nlohmann::ordered_json operator()(const std::string& text) const { return text; }
  nlohmann::ordered_json operator()(const List& list) const {
    auto json = nlohmann::ordered_json::array();
    for (const Value& item : list)
      json.push_back(json_of(item));
    return json;
  }
  nlohmann::ordered_json operator()(const Table& table) const {
    auto json = nlohmann::ordered_json::object();
    for (const Entry& entry : table)
      json[entry.key] = json_of(entry.value);
    return json;
  }
};

nlohmann::ordered_json json_of(const Value& value) {
  return std::visit(Json{}, value.data);
}

struct TypeName {
  std::string_view operator()(bool) const { return "true or false"; }
  std::string_view operator()(std::int64_t) const { return "an integer"; }
  std::string_view operator()(double) const { return "a number"; }
  std::string_view operator()(const std::string&) const { return "a text"; }
  std::string_view operator()(const List&) const { return "an array"; }
  std::string_view operator()(const Table&) const { return "a table"; }
};

} // namespace

std::string to_toml(const Table& table) {
  std::string text;
  write_table(table, "", text);
  return text;
}

std::string to_inline_toml(const Value& value) {
  return std::visit(InlineToml{}, value.data);
}

std::string to_json(const Value& value) {
  return json_of(value).dump(2);
}

std::string_view type_name(const Value& value) {
  return std::visit(TypeName{}, value.data);
}

} // namespace settle::exchange::document
