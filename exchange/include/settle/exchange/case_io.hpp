/// \file
/// Reading a case file, writing it back with its defaults filled in, and the schema for editors.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// Reads and checks a case: keys, types, ranges, names that refer to each other.
/// `overrides` are `key=value` texts as given to `--set`; the value is TOML, a bare word stands for a string.
/// Throws InputError with file:line:column, the value, what is allowed and the nearest spelling.
Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The same from text; `name` stands for the file in messages.
Case parse_case(const std::string& text, const std::string& name, const std::vector<std::string>& overrides = {});

/// The case as TOML with every default filled in. `parse_case(to_toml(c))` gives the same case.
std::string to_toml(const Case& study);

/// JSON Schema (draft-07) of case files, made from the same table of keys that reads them.
std::string case_schema();

/// The tables of all keys in docs/formats.md, from the same table of keys.
std::string case_keys_markdown();

} // namespace settle::exchange
