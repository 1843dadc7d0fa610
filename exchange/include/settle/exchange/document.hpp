/// \file
/// A TOML document as a plain tree in which every value knows where it was given. The same tree serves for what is
/// written: TOML and JSON. The only part of the project that knows toml++ is behind this header.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace settle::exchange::document {

struct Value;
struct Entry;
using List = std::vector<Value>;
using Table = std::vector<Entry>;

/// A value with its place.
struct Value {
  std::variant<bool, std::int64_t, double, std::string, List, Table> data;
  std::string where; ///< `file:line:column` or `--set key=value`; empty in a tree made for writing
};

/// A key of a table with its value.
struct Entry {
  std::string key;
  std::string where; ///< of the key itself
  Value value;
};

/// A key with its value in a tree made for writing.
inline Entry entry(std::string key, Value value) {
  return {std::move(key), {}, std::move(value)};
}

/// The value of a key, or nullptr.
[[nodiscard]] const Value* find(const Table& table, std::string_view key);

/// Parses TOML and applies overrides (`key=value`; the value is TOML, a bare word stands for a string; `name.0.key`
/// reaches into arrays of tables, counted from 0). `name` stands for the file in messages.
/// Throws InputError with the place of a syntax error, or with the override that cannot be applied.
Table parse(const std::string& text, const std::string& name, const std::vector<std::string>& overrides = {});

/// The same from a file. Throws InputError also where the file cannot be read.
Table read(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// One TOML value, such as `400e3`, `"fill"` or `[1, 2]`. Throws InputError located at `where`.
Value parse_value(const std::string& text, const std::string& where);

/// The table as a TOML document, in the order of its entries.
std::string to_toml(const Table& table);

/// A value as TOML on one line; numbers round-trip.
std::string to_inline_toml(const Value& value);

/// A value as indented JSON.
std::string to_json(const Value& value);

/// "a text", "an integer", ... for messages.
std::string_view type_name(const Value& value);

} // namespace settle::exchange::document
