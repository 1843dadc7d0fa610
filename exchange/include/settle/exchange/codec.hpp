/// \file
/// How one kind of value is read, checked, written and described: the kinds a key of a key table may have.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// The numbers a key takes. An open end is not part of the range.
struct Range {
  std::optional<double> lowest{}, highest{};
  bool lowest_open = false, highest_open = false;

  [[nodiscard]] bool contains(double number) const;
  /// " above 0", " from 0 to below 1", ...; empty without limits.
  [[nodiscard]] std::string text() const;
};

Range above(double lowest);
Range at_least(double lowest);
Range exactly(double number);
/// Both ends included.
Range from_to(double lowest, double highest);
/// The upper end left out.
Range from_to_below(double lowest, double highest);
/// The lower end left out.
Range above_to(double lowest, double highest);
/// Both ends left out.
Range between(double lowest, double highest);

/// How many items a list takes.
struct Count {
  std::size_t least = 0;
  std::optional<std::size_t> most{};
};

/// A text that is known when the program is compiled, and lives as long as it runs.
class Literal : public std::string_view {
public:
  consteval Literal(const char* text = "") : std::string_view(text) {}
};

/// What is known of a key besides its kind. Only `doc` is needed.
struct KeyInfo {
  Literal unit{};
  Range range{};         ///< of a number, or of the integers of a list
  Count count{};         ///< of a list
  bool required = false; ///< a text that is required may not be empty either
  Literal left_out{};    ///< what a key that is left out means, where the member's default does not say it
  Literal hint{};        ///< the remedy for a value out of range
  Literal doc{};
};

/// The documentation of a table of keys: what a reader of docs/formats.md sees.
struct TableDoc {
  struct Row {
    std::string key, allowed, default_text, doc;
  };
  std::string header; ///< "[mpm.explicit]", "[[check]]"; empty at the root
  std::string doc;
  std::vector<Row> rows;
};

/// Reads, checks, writes and describes values of type M.
template <class M>
class Codec {
public:
  Codec() = default;
  Codec(const Codec&) = delete;
  Codec& operator=(const Codec&) = delete;
  virtual ~Codec() = default;

  /// Sets `member`, or complains to `reading`.
  virtual void read(const Given& given, M& member, Reading& reading) const = 0;
  /// The value to be written; nothing where the key is to be left out.
  [[nodiscard]] virtual std::optional<document::Value> write(const M& member) const = 0;
  /// JSON Schema of a value.
  [[nodiscard]] virtual document::Table schema() const = 0;
  /// "an integer from 1", for messages and documentation.
  [[nodiscard]] virtual std::string allowed() const = 0;
  /// Tables add themselves and the tables inside them.
  virtual void describe(const std::string& /*path*/, std::vector<TableDoc>& /*docs*/) const {}
  [[nodiscard]] virtual bool is_table() const { return false; }
};

/// A finite number; an integer is accepted.
class RealCodec : public Codec<double> {
public:
  explicit RealCodec(const KeyInfo& info) : info_(info) {}
  void read(const Given& given, double& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const double& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;

private:
  KeyInfo info_;
};

class IntegerCodec : public Codec<int> {
public:
  explicit IntegerCodec(const KeyInfo& info) : info_(info) {}
  void read(const Given& given, int& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const int& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;

private:
  KeyInfo info_;
};

class BooleanCodec : public Codec<bool> {
public:
  void read(const Given& given, bool& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const bool& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;
};

/// Any text; not an empty one where it is required.
class TextCodec : public Codec<std::string> {
public:
  explicit TextCodec(const KeyInfo& info) : info_(info) {}
  void read(const Given& given, std::string& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const std::string& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;

private:
  KeyInfo info_;
};

/// A word that stands for no number ("equilibrium"), or a number.
class RealOrWordCodec : public Codec<std::optional<double>> {
public:
  RealOrWordCodec(std::string word, const KeyInfo& info) : word_(std::move(word)), real_(info) {}
  void read(const Given& given, std::optional<double>& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const std::optional<double>& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;

private:
  std::string word_;
  RealCodec real_;
};

/// A list whose items have a kind of their own, of a number of items within `count`.
template <class M>
class ListCodec : public Codec<std::vector<M>> {
public:
  ListCodec(std::unique_ptr<Codec<M>> item, Count count) : item_(std::move(item)), count_(count) {}
  void read(const Given& given, std::vector<M>& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const std::vector<M>& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;

private:
  std::unique_ptr<Codec<M>> item_;
  Count count_;
};
extern template class ListCodec<int>;
extern template class ListCodec<double>;
extern template class ListCodec<std::string>;
extern template class ListCodec<std::vector<double>>;

/// Any dotted key with any TOML value, kept as TOML text. `a.b = 1` and `"a.b" = 1` are the same.
class TomlValuesCodec : public Codec<std::map<std::string, std::string>> {
public:
  using Member = std::map<std::string, std::string>;
  void read(const Given& given, Member& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const Member& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;
};

/// Any dotted key with a list of TOML values, each kept as TOML text.
class TomlListsCodec : public Codec<std::map<std::string, std::vector<std::string>>> {
public:
  using Member = std::map<std::string, std::vector<std::string>>;
  void read(const Given& given, Member& member, Reading& reading) const override;
  [[nodiscard]] std::optional<document::Value> write(const Member& member) const override;
  [[nodiscard]] document::Table schema() const override;
  [[nodiscard]] std::string allowed() const override;
};

/// The words of a closed set. `unwritable` is a value nobody writes: it is what leaving the key out means.
class Words {
public:
  Words(std::span<const std::string_view> names, std::optional<std::size_t> unwritable);
  /// The index of the word that was given; nothing after a complaint.
  [[nodiscard]] std::optional<std::size_t> read(const Given& given, Reading& reading) const;
  [[nodiscard]] std::optional<document::Value> write(std::size_t index) const;
  [[nodiscard]] document::Table schema() const;
  [[nodiscard]] std::string allowed() const;

private:
  std::vector<std::string> names_;
  std::optional<std::size_t> unwritable_;
};

/// A value of an enumeration, by the names of EnumNames.
template <class Enum>
class ChoiceCodec : public Codec<Enum> {
public:
  explicit ChoiceCodec(std::optional<Enum> unwritable = {})
      : words_(EnumNames<Enum>::names,
               unwritable ? std::optional(static_cast<std::size_t>(*unwritable)) : std::nullopt) {}
  void read(const Given& given, Enum& member, Reading& reading) const override {
    if (const auto index = words_.read(given, reading)) member = static_cast<Enum>(*index);
  }
  [[nodiscard]] std::optional<document::Value> write(const Enum& member) const override {
    return words_.write(static_cast<std::size_t>(member));
  }
  [[nodiscard]] document::Table schema() const override { return words_.schema(); }
  [[nodiscard]] std::string allowed() const override { return words_.allowed(); }

private:
  Words words_;
};

/// A value that may be left out.
template <class M>
class OptionalCodec : public Codec<std::optional<M>> {
public:
  explicit OptionalCodec(std::unique_ptr<Codec<M>> value) : value_(std::move(value)) {}
  void read(const Given& given, std::optional<M>& member, Reading& reading) const override {
    value_->read(given, member.emplace(), reading);
  }
  [[nodiscard]] std::optional<document::Value> write(const std::optional<M>& member) const override {
    return member ? value_->write(*member) : std::nullopt;
  }
  [[nodiscard]] document::Table schema() const override { return value_->schema(); }
  [[nodiscard]] std::string allowed() const override { return value_->allowed(); }
  void describe(const std::string& path, std::vector<TableDoc>& docs) const override { value_->describe(path, docs); }
  [[nodiscard]] bool is_table() const override { return value_->is_table(); }

private:
  std::unique_ptr<Codec<M>> value_;
};

} // namespace settle::exchange
