#include "settle/exchange/key_table.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/exchange/spelling.hpp"

namespace settle::exchange {
namespace {

using document::Entry;
using document::List;
using document::Table;
using document::Value;

Entry text_entry(std::string key, const std::string& text) {
  return {std::move(key), {}, {text, {}}};
}

std::vector<std::string> names_of(const std::vector<KeyFacts>& keys) {
  std::vector<std::string> names;
  for (const KeyFacts& key : keys)
    names.push_back(key.name);
  return names;
}

/// Complains about unknown keys; returns the known ones they were probably meant to be.
std::set<std::string> check_unknown(const Table& table, const Place& place, const std::vector<std::string>& names,
                                    Reading& reading) {
  std::set<std::string> meant;
  for (const Entry& entry : table) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    const auto nearest = nearest_spelling(entry.key, names);
    reading.complain({.where = entry.where,
                      .what = join(place.path, entry.key) + " is not a known key",
                      .given = entry.key,
                      .allowed = fmt::format("{}", fmt::join(names, ", ")),
                      .remedy = nearest ? fmt::format("did you mean {}?", *nearest) : std::string()});
    if (nearest) meant.insert(*nearest);
  }
  return meant;
}

std::string left_out_text(const KeyFacts& key) {
  if (key.info.required) return "required";
  if (!key.info.left_out.empty()) return std::string(key.info.left_out);
  return key.default_value ? fmt::format("`{}`", document::to_inline_toml(*key.default_value)) : "";
}

Table property_schema(const KeyFacts& key) {
  Table schema = key.schema;
  const std::string unit = key.info.unit.empty() ? "" : fmt::format(" [{}]", key.info.unit);
  const std::string left_out = key.info.left_out.empty() ? "" : fmt::format(" Left out: {}.", key.info.left_out);
  const bool has_text = document::find(schema, "description") != nullptr;
  if (!has_text && !key.info.doc.empty())
    schema.push_back(
        text_entry("description", fmt::format("{}{}{}{}", key.info.doc, unit, left_out.empty() ? "" : ".", left_out)));
  if (key.default_value && key.info.left_out.empty()) schema.push_back({"default", {}, *key.default_value});
  return schema;
}

} // namespace

void check_keys(const Table& table, const Place& place, const std::vector<KeyFacts>& keys, Reading& reading) {
  const std::set<std::string> meant = check_unknown(table, place, names_of(keys), reading);
  for (const KeyFacts& key : keys) {
    if (!key.info.required || document::find(table, key.name) != nullptr || meant.contains(key.name)) continue;
    reading.complain(
        {.where = place.where,
         .what = join(place.path, key.name) + " is missing",
         .given = {},
         .allowed = key.allowed,
         .remedy = key.info.doc.empty() ? std::string() : fmt::format("give {}: {}", key.name, key.info.doc)});
  }
}

Table schema_of_keys(const std::string& doc, const std::vector<KeyFacts>& keys) {
  Table properties;
  List required;
  for (const KeyFacts& key : keys) {
    properties.push_back({key.name, {}, {property_schema(key), {}}});
    if (key.info.required) required.push_back({key.name, {}});
  }
  Table schema{
      text_entry("type", "object"), text_entry("description", doc), {"properties", {}, {std::move(properties), {}}}};
  if (!required.empty()) schema.push_back({"required", {}, {std::move(required), {}}});
  schema.push_back({"additionalProperties", {}, {false, {}}});
  return schema;
}

TableDoc doc_of_keys(const std::string& header, const std::string& doc, const std::vector<KeyFacts>& keys) {
  TableDoc result{.header = header, .doc = doc, .rows = {}};
  for (const KeyFacts& key : keys)
    if (!key.is_table) result.rows.push_back({key.name, key.allowed, left_out_text(key), std::string(key.info.doc)});
  return result;
}

const Table* as_table(const Given& given, Reading& reading) {
  const auto* table = std::get_if<Table>(&given.value.data);
  if (table == nullptr) reading.complain_type(given, fmt::format("a table, such as [{}]", given.path));
  return table;
}

const List* as_list_of_tables(const Given& given, Reading& reading) {
  const auto* list = std::get_if<List>(&given.value.data);
  const auto is_table = [](const Value& item) { return std::holds_alternative<Table>(item.data); };
  if (list != nullptr && std::all_of(list->begin(), list->end(), is_table)) return list;
  reading.complain_type(given, fmt::format("an array of tables, such as [[{}]]", given.path));
  return nullptr;
}

Table schema_of_named_tables(Table each) {
  return {text_entry("type", "object"),
          {"propertyNames", {}, {Table{text_entry("pattern", "^[A-Za-z0-9_-]+$")}, {}}},
          {"additionalProperties", {}, {std::move(each), {}}}};
}

bool check_name(const Entry& entry, const std::string& path, Reading& reading) {
  const auto fits = [](unsigned char c) { return c < 128 && (std::isalnum(c) != 0 || c == '_' || c == '-'); };
  if (!entry.key.empty() && std::all_of(entry.key.begin(), entry.key.end(), fits)) return true;
  reading.complain({.where = entry.where,
                    .what = path + " has a name that cannot be used",
                    .given = entry.key,
                    .allowed = "letters, digits, _ and -",
                    .remedy = {}});
  return false;
}

std::string to_markdown(const std::vector<TableDoc>& docs) {
  std::string text;
  for (const TableDoc& table : docs) {
    if (!table.header.empty()) text += fmt::format("{}#### `{}`\n\n", text.empty() ? "" : "\n", table.header);
    text += fmt::format("{}\n\n| key | value | left out | meaning |\n|---|---|---|---|\n", table.doc);
    for (const auto& row : table.rows)
      text += fmt::format("| `{}` | {} | {} | {} |\n", row.key, row.allowed, row.default_text, row.doc);
  }
  return text;
}

} // namespace settle::exchange
