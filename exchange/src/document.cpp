#include "settle/exchange/document.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/spelling.hpp"

namespace settle::exchange::document {
namespace {

/// Where things stand: a file, in which positions matter, or an override, in which they do not.
struct Source {
  std::string name;
  bool positions = true;

  [[nodiscard]] std::string at(const toml::source_region& region, const std::string& parent) const {
    if (!positions) return name;
    if (region.begin.line == 0) return parent;
    return fmt::format("{}:{}:{}", name, region.begin.line, region.begin.column);
  }
};

Value converted(const toml::node& node, const Source& source, const std::string& parent);

Table converted(const toml::table& table, const Source& source, const std::string& parent) {
  Table entries;
  for (const auto& [key, node] : table) {
    const std::string where = source.at(key.source(), parent);
    entries.push_back({std::string(key.str()), where, converted(node, source, where)});
  }
  return entries;
}

List converted(const toml::array& array, const Source& source, const std::string& parent) {
  List items;
  for (const toml::node& node : array)
    items.push_back(converted(node, source, parent));
  return items;
}

Value converted(const toml::node& node, const Source& source, const std::string& parent) {
  const std::string where = source.at(node.source(), parent);
  if (const auto* table = node.as_table()) return {converted(*table, source, where), where};
  if (const auto* array = node.as_array()) return {converted(*array, source, where), where};
  if (const auto* text = node.as_string()) return {text->get(), where};
  if (const auto* integer = node.as_integer()) return {integer->get(), where};
  if (const auto* real = node.as_floating_point()) return {real->get(), where};
  if (const auto* boolean = node.as_boolean()) return {boolean->get(), where};
  throw InputError({.where = where,
                    .what = "dates and times are not used here",
                    .given = {},
                    .allowed = "texts, numbers, true, false, arrays and tables",
                    .remedy = "put the value in quotes if it is meant as a text"});
}

Table parsed(const std::string& text, const Source& source) {
  try {
    return converted(toml::parse(text, source.name), source, source.name);
  } catch (const toml::parse_error& error) {
    throw InputError({.where = source.at(error.source(), source.name),
                      .what = fmt::format("not valid TOML: {}", error.description()),
                      .given = {},
                      .allowed = {},
                      .remedy = {}});
  }
}

std::optional<Value> toml_value(const std::string& text, const Source& source) {
  Table table = parsed("value = " + text, source);
  if (table.size() != 1) return std::nullopt;
  return std::move(table.front().value);
}

/// The value of an override: TOML, or a bare word.
Value override_value(const std::string& text, const Source& source) {
  const bool bare_word = !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_');
  try {
    if (auto value = toml_value(text, source)) return *value;
  } catch (const InputError&) {
    if (bare_word) return {text, source.name};
  }
  throw InputError({.where = source.name,
                    .what = "the value of the override cannot be read",
                    .given = text.empty() ? "nothing" : text,
                    .allowed = "a TOML value such as 5, 0.25, true, \"text\" or [1, 2], or a bare word",
                    .remedy = {}});
}

std::vector<std::string> segments(const std::string& key, const std::string& where) {
  std::vector<std::string> parts;
  std::stringstream stream(key + ".");
  for (std::string part; std::getline(stream, part, '.');) {
    if (part.empty())
      throw InputError({.where = where,
                        .what = "an override needs a key of names joined by dots",
                        .given = key,
                        .allowed = "key=value, for instance construction.layers=10",
                        .remedy = {}});
    parts.push_back(part);
  }
  return parts;
}

[[noreturn]] void refuse_descent(const std::string& where, const std::string& inside, const Value& value) {
  throw InputError({.where = where,
                    .what = fmt::format("{} has no keys of its own", inside),
                    .given = fmt::format("{}: {}", type_name(value), to_inline_toml(value)),
                    .allowed = std::holds_alternative<List>(value.data) ? "the number of an entry, counted from 0" : "",
                    .remedy = {}});
}

Value& member(Table& table, const std::string& key, const std::string& where) {
  const auto entry = std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.key == key; });
  if (entry != table.end()) return entry->value;
  return table.emplace_back(Entry{key, where, {Table{}, where}}).value;
}

/// Several names may be one key of a table, in quotes there: how many of the first ones are, at most.
std::ptrdiff_t length_of_key(const Value& value, const std::vector<std::string>& names) {
  const auto* table = std::get_if<Table>(&value.data);
  if (table == nullptr) return 1;
  for (auto last = names.end(); last - names.begin() > 1; --last) {
    if (find(*table, fmt::format("{}", fmt::join(names.begin(), last, "."))) != nullptr) return last - names.begin();
  }
  return 1;
}

/// The value named by one more segment inside `inside`, created where a table does not have it yet.
Value& descend(Value& value, const std::string& inside, const std::string& segment, const std::string& where) {
  if (auto* table = std::get_if<Table>(&value.data)) return member(*table, segment, where);
  if (auto* list = std::get_if<List>(&value.data)) {
    const bool digits = segment.size() < 9 && segment.find_first_not_of("0123456789") == std::string::npos;
    if (digits && std::stoul(segment) < list->size()) return (*list)[std::stoul(segment)];
  }
  refuse_descent(where, inside, value);
}

void apply(const std::string& text, Value& root) {
  const std::string where = "--set " + text;
  const std::size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  if (equals == std::string::npos)
    throw InputError({.where = where,
                      .what = "an override needs a key and a value",
                      .given = text,
                      .allowed = "key=value, for instance construction.layers=10",
                      .remedy = {}});
  Value* target = &root;
  std::string inside;
  const std::vector<std::string> names = segments(key, where);
  for (auto first = names.begin(); first != names.end();) {
    const auto last = first + length_of_key(*target, {first, names.end()});
    const std::string name = fmt::format("{}", fmt::join(first, last, "."));
    target = &descend(*target, inside, name, where);
    inside += (inside.empty() ? "" : ".") + name;
    first = last;
  }
  *target = override_value(text.substr(equals + 1), {where, false});
}

} // namespace

const Value* find(const Table& table, std::string_view key) {
  const auto entry = std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.key == key; });
  return entry == table.end() ? nullptr : &entry->value;
}

Table parse(const std::string& text, const std::string& name, const std::vector<std::string>& overrides) {
  Value root{parsed(text, {name}), name};
  for (const std::string& text_of_override : overrides)
    apply(text_of_override, root);
  return std::get<Table>(std::move(root.data));
}

Table read(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  if (stream) text << stream.rdbuf();
  const bool folder = std::filesystem::is_directory(file);
  if (!stream || folder || stream.bad())
    throw InputError({.where = file.string(),
                      .what = "the file cannot be read",
                      .given = folder ? "a folder" : std::string(std::strerror(errno)),
                      .allowed = "a TOML file",
                      .remedy = "check the path"});
  return parse(text.str(), file.string(), overrides);
}

Value parse_value(const std::string& text, const std::string& where) {
  if (auto value = toml_value(text, {where, false})) return *value;
  throw InputError({.where = where, .what = "not one TOML value", .given = text, .allowed = {}, .remedy = {}});
}

} // namespace settle::exchange::document
