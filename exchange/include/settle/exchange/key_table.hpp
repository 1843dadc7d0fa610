/// \file
/// A declarative table of the keys of a struct. One table serves for reading, validation, defaults (the struct's own
/// member values), writing, the JSON schema and the documentation, so that there is no second list of keys.
///
///     KeyTable<Geometry> geometry_keys() {
///       KeyTable<Geometry> keys("The domain that is built up.");
///       keys.real("height", &Geometry::height, {.unit = "m", .range = above(0), .required = true, .doc = "..."});
///       return keys;
///     }
///
///     const document::Table table = document::read(file, overrides);
///     Reading reading;
///     Geometry geometry;
///     geometry_keys().read(table, {.path = "", .where = file}, geometry, reading);
///     reading.throw_if_any();
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "settle/exchange/codec.hpp"
#include "settle/exchange/document.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// A table being read: its dotted key and where it was given.
struct Place {
  std::string path;
  std::string where;
};

/// What is known of a key without its type.
struct KeyFacts {
  std::string name;
  KeyInfo info;
  std::string allowed;
  std::optional<document::Value> default_value; ///< nothing for tables, required keys, and keys that may be absent
  document::Table schema;
  bool is_table = false;
};

/// Complains about keys that are not in the list, with the nearest spelling, and about required keys that are missing.
void check_keys(const document::Table& table, const Place& place, const std::vector<KeyFacts>& keys, Reading& reading);
/// JSON Schema of a table of keys.
document::Table schema_of_keys(const std::string& doc, const std::vector<KeyFacts>& keys);
/// The documentation of a table of keys, without the tables inside it.
TableDoc doc_of_keys(const std::string& header, const std::string& doc, const std::vector<KeyFacts>& keys);
/// Complains unless the value is a table, or every item of the list is one.
const document::Table* as_table(const Given& given, Reading& reading);
const document::List* as_list_of_tables(const Given& given, Reading& reading);
/// JSON Schema of tables under names that people choose.
document::Table schema_of_named_tables(document::Table each);
/// Complains about a name that is not made of letters, digits, "_" and "-".
bool check_name(const document::Entry& entry, const std::string& path, Reading& reading);
/// The tables of a documentation as Markdown.
std::string to_markdown(const std::vector<TableDoc>& docs);

/// The keys of the struct T.
template <class T>
class KeyTable {
public:
  /// `doc`: what the table as a whole is, one sentence.
  explicit KeyTable(std::string doc) : doc_(std::move(doc)) {}

  void real(std::string_view name, double T::*member, const KeyInfo& info) {
    add(name, member, std::make_unique<RealCodec>(info), info);
  }
  void real(std::string_view name, std::optional<double> T::*member, const KeyInfo& info) {
    add(name, member, optional<double>(std::make_unique<RealCodec>(info)), info);
  }
  /// A number, or a word for none; the word is also the default.
  void real_or_word(std::string_view name, std::optional<double> T::*member, std::string word, const KeyInfo& info) {
    add(name, member, std::make_unique<RealOrWordCodec>(std::move(word), info), info);
  }
  void integer(std::string_view name, int T::*member, const KeyInfo& info) {
    add(name, member, std::make_unique<IntegerCodec>(info), info);
  }
  void integer(std::string_view name, std::optional<int> T::*member, const KeyInfo& info) {
    add(name, member, optional<int>(std::make_unique<IntegerCodec>(info)), info);
  }
  void boolean(std::string_view name, bool T::*member, const KeyInfo& info) {
    add(name, member, std::make_unique<BooleanCodec>(), info);
  }
  void text(std::string_view name, std::string T::*member, const KeyInfo& info) {
    add(name, member, std::make_unique<TextCodec>(info), info);
  }
  /// One of the names of EnumNames<Enum>.
  template <class Enum>
  void choice(std::string_view name, Enum T::*member, const KeyInfo& info) {
    add(name, member, std::make_unique<ChoiceCodec<Enum>>(), info);
  }
  /// The same where the key may be absent.
  template <class Enum>
  void choice(std::string_view name, std::optional<Enum> T::*member, const KeyInfo& info) {
    add(name, member, optional<Enum>(std::make_unique<ChoiceCodec<Enum>>()), info);
  }
  /// The same where `unwritable` is what leaving the key out means, and no word for it may be written.
  template <class Enum>
  void choice_or_left_out(std::string_view name, Enum T::*member, Enum unwritable, const KeyInfo& info) {
    add(name, member, std::make_unique<ChoiceCodec<Enum>>(unwritable), info);
  }
  /// A list of texts, none of them empty.
  void texts(std::string_view name, std::vector<std::string> T::*member, const KeyInfo& info) {
    auto item = std::make_unique<TextCodec>(KeyInfo{.required = true});
    add(name, member, std::make_unique<ListCodec<std::string>>(std::move(item), info.count), info);
  }
  /// A list of integers, each within the range.
  void integers(std::string_view name, std::vector<int> T::*member, const KeyInfo& info) {
    auto item = std::make_unique<IntegerCodec>(info);
    add(name, member, std::make_unique<ListCodec<int>>(std::move(item), info.count), info);
  }
  /// A list of numbers, each within the range.
  void reals(std::string_view name, std::vector<double> T::*member, const KeyInfo& info) {
    auto item = std::make_unique<RealCodec>(info);
    add(name, member, std::make_unique<ListCodec<double>>(std::move(item), info.count), info);
  }
  /// A list of lists of numbers, each of `inner` numbers.
  void real_lists(std::string_view name, std::vector<std::vector<double>> T::*member, const KeyInfo& info,
                  Count inner) {
    using Inner = ListCodec<double>;
    auto item = std::make_unique<Inner>(std::make_unique<RealCodec>(info), inner);
    add(name, member, std::make_unique<ListCodec<std::vector<double>>>(std::move(item), info.count), info);
  }
  /// A table of free keys, each with any TOML value, kept as TOML text.
  void toml_values(std::string_view name, std::map<std::string, std::string> T::*member, const KeyInfo& info) {
    add(name, member, std::make_unique<TomlValuesCodec>(), info);
  }
  /// A table of free keys, each with a list of TOML values.
  void toml_lists(std::string_view name, std::map<std::string, std::vector<std::string>> T::*member,
                  const KeyInfo& info) {
    add(name, member, std::make_unique<TomlListsCodec>(), info);
  }
  /// `[name]`
  template <class U>
  void table(std::string_view name, U T::*member, KeyTable<U> keys, const KeyInfo& info = {});
  /// `[name]`, which may be absent
  template <class U>
  void table(std::string_view name, std::optional<U> T::*member, KeyTable<U> keys, const KeyInfo& info = {});
  /// `[name.NAME]`, any number of them
  template <class U>
  void named_tables(std::string_view name, std::map<std::string, U> T::*member, KeyTable<U> keys,
                    const KeyInfo& info = {});
  /// `[[name]]`, any number of them
  template <class U>
  void table_array(std::string_view name, std::vector<U> T::*member, KeyTable<U> keys, const KeyInfo& info = {});

  /// Sets the members whose keys are given; complains about everything that does not fit.
  void read(const document::Table& given, const Place& place, T& into, Reading& reading) const;
  /// Every key with its value.
  [[nodiscard]] document::Table write(const T& from) const;
  [[nodiscard]] document::Table schema() const { return schema_of_keys(doc_, facts()); }
  /// Appends the documentation of this table and of those inside it.
  void describe(const std::string& header, const std::string& path, std::vector<TableDoc>& docs) const;

private:
  struct Key {
    Key(std::string_view key, const KeyInfo& key_info) : name(key), info(key_info) {}
    Key(const Key&) = delete;
    Key& operator=(const Key&) = delete;
    virtual ~Key() = default;
    virtual void read(const Given& given, T& into, Reading& reading) const = 0;
    [[nodiscard]] virtual std::optional<document::Value> write(const T& from) const = 0;
    [[nodiscard]] virtual KeyFacts facts() const = 0;
    virtual void describe(const std::string& path, std::vector<TableDoc>& docs) const = 0;
    std::string name;
    KeyInfo info;
  };
  template <class M>
  struct MemberKey;

  template <class M>
  static std::unique_ptr<Codec<std::optional<M>>> optional(std::unique_ptr<Codec<M>> value) {
    return std::make_unique<OptionalCodec<M>>(std::move(value));
  }
  template <class M>
  void add(std::string_view name, M T::*member, std::unique_ptr<Codec<M>> codec, const KeyInfo& info) {
    keys_.push_back(std::make_unique<MemberKey<M>>(name, info, member, std::move(codec)));
  }
  template <class M, class C>
  void add(std::string_view name, M T::*member, std::unique_ptr<C> codec, const KeyInfo& info) {
    add<M>(name, member, std::unique_ptr<Codec<M>>(std::move(codec)), info);
  }
  [[nodiscard]] std::vector<KeyFacts> facts() const {
    std::vector<KeyFacts> all;
    for (const auto& key : keys_)
      all.push_back(key->facts());
    return all;
  }

  std::string doc_;
  std::vector<std::unique_ptr<Key>> keys_;
};

} // namespace settle::exchange

#include "settle/exchange/key_table_detail.hpp"
