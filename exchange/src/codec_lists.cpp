#include <map>

#include <fmt/format.h>

#include "settle/exchange/codec.hpp"

namespace settle::exchange {
namespace {

using document::entry;
using document::List;
using document::Table;
using document::Value;

Value whole_number(std::size_t number) {
  return {static_cast<std::int64_t>(number), {}};
}

/// Every leaf of a table of tables with its dotted key.
void flatten(const Table& table, const std::string& path, std::vector<Given>& leaves) {
  for (const document::Entry& item : table) {
    const std::string key = join(path, item.key);
    if (const auto* inside = std::get_if<Table>(&item.value.data)) {
      flatten(*inside, key, leaves);
    } else {
      leaves.push_back({item.value, key});
    }
  }
}

/// One key can be written in two ways, "a.b" in quotes and a.b without; TOML does not notice that they are one.
void complain_of_the_second(const std::vector<Given>& leaves, const std::string& path, Reading& reading) {
  std::map<std::string, std::string> places;
  for (const Given& leaf : leaves) {
    const auto [first, is_new] = places.try_emplace(leaf.path, leaf.value.where);
    if (is_new) continue;
    reading.complain({.where = leaf.value.where,
                      .what = join(path, leaf.path) + " is given twice",
                      .given = "also at " + first->second,
                      .allowed = "each key once, with or without quotes",
                      .remedy = {}});
  }
}

std::vector<Given> leaves_of(const Given& given, const std::string& allowed, Reading& reading) {
  std::vector<Given> leaves;
  if (const auto* table = std::get_if<Table>(&given.value.data)) {
    flatten(*table, "", leaves);
    complain_of_the_second(leaves, given.path, reading);
  } else {
    reading.complain_type(given, allowed);
  }
  return leaves;
}

} // namespace

template <class M>
void ListCodec<M>::read(const Given& given, std::vector<M>& member, Reading& reading) const {
  const auto* list = std::get_if<List>(&given.value.data);
  if (list == nullptr) {
    reading.complain_type(given, allowed());
    return;
  }
  if (list->size() < count_.least || list->size() > count_.most.value_or(list->size())) {
    reading.complain_value(given, allowed());
    return;
  }
  member.clear();
  for (const Value& item : *list) {
    const std::string path = fmt::format("{}.{}", given.path, member.size());
    item_->read({item, path}, member.emplace_back(), reading);
  }
}

template <class M>
std::optional<Value> ListCodec<M>::write(const std::vector<M>& member) const {
  if (member.size() < count_.least) return std::nullopt;
  List list;
  for (const M& item : member)
    if (auto value = item_->write(item)) list.push_back(std::move(*value));
  return Value{std::move(list), {}};
}

template <class M>
Table ListCodec<M>::schema() const {
  Table schema{entry("type", {std::string("array"), {}}), entry("items", {item_->schema(), {}})};
  if (count_.least > 0) schema.push_back(entry("minItems", whole_number(count_.least)));
  if (count_.most) schema.push_back(entry("maxItems", whole_number(*count_.most)));
  return schema;
}

template <class M>
std::string ListCodec<M>::allowed() const {
  std::string size;
  if (count_.most == count_.least) {
    size = fmt::format(" of {}", count_.least);
  } else if (count_.most) {
    size = fmt::format(" of {} to {}", count_.least, *count_.most);
  } else if (count_.least > 0) {
    size = fmt::format(" of at least {}", count_.least);
  }
  return fmt::format("an array{}, each {}", size, item_->allowed());
}

template class ListCodec<int>;
template class ListCodec<double>;
template class ListCodec<std::string>;
template class ListCodec<std::vector<double>>;

void TomlValuesCodec::read(const Given& given, Member& member, Reading& reading) const {
  for (const Given& leaf : leaves_of(given, allowed(), reading))
    member[leaf.path] = document::to_inline_toml(leaf.value);
}

std::optional<Value> TomlValuesCodec::write(const Member& member) const {
  Table table;
  for (const auto& [key, text] : member)
    table.push_back(entry(key, document::parse_value(text, key)));
  return Value{std::move(table), {}};
}

Table TomlValuesCodec::schema() const {
  return {entry("type", {std::string("object"), {}})};
}

std::string TomlValuesCodec::allowed() const {
  return "a table of dotted keys with their values";
}

void TomlListsCodec::read(const Given& given, Member& member, Reading& reading) const {
  for (const Given& leaf : leaves_of(given, allowed(), reading)) {
    const auto* list = std::get_if<List>(&leaf.value.data);
    if (list == nullptr || list->empty()) {
      reading.complain_type({leaf.value, join(given.path, leaf.path)}, "an array of at least one value");
      continue;
    }
    for (const Value& item : *list)
      member[leaf.path].push_back(document::to_inline_toml(item));
  }
}

std::optional<Value> TomlListsCodec::write(const Member& member) const {
  Table table;
  for (const auto& [key, texts] : member) {
    List list;
    for (const std::string& text : texts)
      list.push_back(document::parse_value(text, key));
    table.push_back(entry(key, {std::move(list), {}}));
  }
  return Value{std::move(table), {}};
}

Table TomlListsCodec::schema() const {
  // A dotted key without quotes is a table of tables.
  const List kinds{{std::string("array"), {}}, {std::string("object"), {}}};
  Table values{entry("type", {kinds, {}}), entry("minItems", whole_number(1))};
  return {entry("type", {std::string("object"), {}}), entry("additionalProperties", {std::move(values), {}})};
}

std::string TomlListsCodec::allowed() const {
  return "a table of dotted keys, each with an array of values";
}

} // namespace settle::exchange
