/// \file
/// The reading of one document: the complaints it gives rise to and the places of the keys that were given.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "settle/exchange/document.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::exchange {

/// A value and the dotted key it was given for.
struct Given {
  const document::Value& value;
  std::string path;
};

/// Collects every complaint about a document, so that one run shows all of them.
class Reading {
public:
  void complain(Complaint complaint) { complaints_.push_back(std::move(complaint)); }
  void note_origin(const std::string& path, const std::string& where) { origins_[path] = where; }

  /// The value has another type than its key takes.
  void complain_type(const Given& given, const std::string& allowed);
  /// The value has the right type but not an allowed value.
  void complain_value(const Given& given, const std::string& allowed, const std::string& remedy = {});
  /// The word is none of the allowed ones; the nearest is the remedy.
  void complain_word(const Given& given, const std::vector<std::string>& words);

  /// Dotted key -> where it was given; only keys given. Items of arrays count from 0: `check.0.limit`.
  [[nodiscard]] const std::map<std::string, std::string>& origins() const { return origins_; }
  /// Throws InputError with every complaint, in the order in which they came up.
  void throw_if_any() const;

private:
  std::vector<Complaint> complaints_;
  std::map<std::string, std::string> origins_;
};

/// `table.key`, or `key` at the root.
std::string join(const std::string& path, const std::string& key);

} // namespace settle::exchange
