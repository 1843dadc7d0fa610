/// \file
/// The template bodies of key_table.hpp: keys bound to members, and the three kinds of tables inside tables.
#pragma once

#include "settle/exchange/key_table.hpp"

namespace settle::exchange {

template <class T>
template <class M>
struct KeyTable<T>::MemberKey : Key {
  MemberKey(std::string_view key, const KeyInfo& key_info, M T::*pointer, std::unique_ptr<Codec<M>> coder)
      : Key(key, key_info), member(pointer), codec(std::move(coder)) {}

  void read(const Given& given, T& into, Reading& reading) const override { codec->read(given, into.*member, reading); }
  [[nodiscard]] std::optional<document::Value> write(const T& from) const override {
    return codec->write(from.*member);
  }
  [[nodiscard]] KeyFacts facts() const override {
    const bool has_default = !this->info.required && !codec->is_table();
    return {.name = this->name,
            .info = this->info,
            .allowed = codec->allowed(),
            .default_value = has_default ? write(T{}) : std::nullopt,
            .schema = codec->schema(),
            .is_table = codec->is_table()};
  }
  void describe(const std::string& path, std::vector<TableDoc>& docs) const override {
    codec->describe(join(path, this->name), docs);
  }

  M T::*member;
  std::unique_ptr<Codec<M>> codec;
};

template <class T>
void KeyTable<T>::read(const document::Table& given, const Place& place, T& into, Reading& reading) const {
  check_keys(given, place, facts(), reading);
  for (const auto& key : keys_) {
    const document::Value* value = document::find(given, key->name);
    if (value == nullptr) continue;
    const std::string path = join(place.path, key->name);
    reading.note_origin(path, value->where);
    key->read({*value, path}, into, reading);
  }
}

template <class T>
document::Table KeyTable<T>::write(const T& from) const {
  document::Table table;
  for (const auto& key : keys_)
    if (auto value = key->write(from)) table.push_back({key->name, {}, std::move(*value)});
  return table;
}

template <class T>
void KeyTable<T>::describe(const std::string& header, const std::string& path, std::vector<TableDoc>& docs) const {
  docs.push_back(doc_of_keys(header, doc_, facts()));
  for (const auto& key : keys_)
    key->describe(path, docs);
}

/// `[name]`
template <class U>
class TableCodec : public Codec<U> {
public:
  explicit TableCodec(KeyTable<U> keys) : keys_(std::move(keys)) {}
  void read(const Given& given, U& member, Reading& reading) const override {
    if (const auto* table = as_table(given, reading))
      keys_.read(*table, {given.path, given.value.where}, member, reading);
  }
  [[nodiscard]] std::optional<document::Value> write(const U& member) const override {
    return document::Value{keys_.write(member), {}};
  }
  [[nodiscard]] document::Table schema() const override { return keys_.schema(); }
  [[nodiscard]] std::string allowed() const override { return "a table"; }
  [[nodiscard]] bool is_table() const override { return true; }
  void describe(const std::string& path, std::vector<TableDoc>& docs) const override {
    keys_.describe("[" + path + "]", path, docs);
  }

private:
  KeyTable<U> keys_;
};

/// `[name.NAME]`
template <class U>
class NamedTablesCodec : public Codec<std::map<std::string, U>> {
public:
  explicit NamedTablesCodec(KeyTable<U> keys) : keys_(std::move(keys)) {}
  void read(const Given& given, std::map<std::string, U>& member, Reading& reading) const override {
    const auto* tables = as_table(given, reading);
    if (tables == nullptr) return;
    for (const document::Entry& entry : *tables) {
      const Given inside{entry.value, join(given.path, entry.key)};
      const auto* table = as_table(inside, reading);
      if (table == nullptr || !check_name(entry, inside.path, reading)) continue;
      reading.note_origin(inside.path, entry.value.where);
      keys_.read(*table, {inside.path, entry.value.where}, member[entry.key], reading);
    }
  }
  [[nodiscard]] std::optional<document::Value> write(const std::map<std::string, U>& member) const override {
    document::Table tables;
    for (const auto& [name, value] : member)
      tables.push_back({name, {}, {keys_.write(value), {}}});
    return tables.empty() ? std::nullopt : std::optional(document::Value{std::move(tables), {}});
  }
  [[nodiscard]] document::Table schema() const override { return schema_of_named_tables(keys_.schema()); }
  [[nodiscard]] std::string allowed() const override { return "tables with names of your own"; }
  [[nodiscard]] bool is_table() const override { return true; }
  void describe(const std::string& path, std::vector<TableDoc>& docs) const override {
    keys_.describe("[" + path + ".NAME]", path + ".NAME", docs);
  }

private:
  KeyTable<U> keys_;
};

/// `[[name]]`
template <class U>
class TableArrayCodec : public Codec<std::vector<U>> {
public:
  explicit TableArrayCodec(KeyTable<U> keys) : keys_(std::move(keys)) {}
  void read(const Given& given, std::vector<U>& member, Reading& reading) const override {
    const auto* items = as_list_of_tables(given, reading);
    if (items == nullptr) return;
    member.clear();
    for (const document::Value& item : *items) {
      const std::string path = join(given.path, std::to_string(member.size()));
      reading.note_origin(path, item.where);
      keys_.read(std::get<document::Table>(item.data), {path, item.where}, member.emplace_back(), reading);
    }
  }
  [[nodiscard]] std::optional<document::Value> write(const std::vector<U>& member) const override {
    document::List items;
    for (const U& value : member)
      items.push_back({keys_.write(value), {}});
    return items.empty() ? std::nullopt : std::optional(document::Value{std::move(items), {}});
  }
  [[nodiscard]] document::Table schema() const override {
    return {{"type", {}, {std::string("array"), {}}}, {"items", {}, {keys_.schema(), {}}}};
  }
  [[nodiscard]] std::string allowed() const override { return "an array of tables"; }
  [[nodiscard]] bool is_table() const override { return true; }
  void describe(const std::string& path, std::vector<TableDoc>& docs) const override {
    keys_.describe("[[" + path + "]]", path, docs);
  }

private:
  KeyTable<U> keys_;
};

template <class T>
template <class U>
void KeyTable<T>::table(std::string_view name, U T::*member, KeyTable<U> keys, const KeyInfo& info) {
  add(name, member, std::make_unique<TableCodec<U>>(std::move(keys)), info);
}

template <class T>
template <class U>
void KeyTable<T>::table(std::string_view name, std::optional<U> T::*member, KeyTable<U> keys, const KeyInfo& info) {
  std::unique_ptr<Codec<U>> codec = std::make_unique<TableCodec<U>>(std::move(keys));
  add(name, member, optional<U>(std::move(codec)), info);
}

template <class T>
template <class U>
void KeyTable<T>::named_tables(std::string_view name, std::map<std::string, U> T::*member, KeyTable<U> keys,
                               const KeyInfo& info) {
  add(name, member, std::make_unique<NamedTablesCodec<U>>(std::move(keys)), info);
}

template <class T>
template <class U>
void KeyTable<T>::table_array(std::string_view name, std::vector<U> T::*member, KeyTable<U> keys, const KeyInfo& info) {
  add(name, member, std::make_unique<TableArrayCodec<U>>(std::move(keys)), info);
}

} // namespace settle::exchange
