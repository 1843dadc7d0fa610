/// \file
/// Results that need not be computed again: a key beside each result says what it was made from.
#pragma once

#include <filesystem>
#include <string>

namespace settle::compare {

/// SHA-256 of the case with its defaults, the solver's program and the version of the result format.
/// Throws FileError where the program cannot be read.
std::string result_key(const std::string& case_text, const std::filesystem::path& program);

/// Was the result made from the same case by the same program?
bool is_up_to_date(const std::filesystem::path& result_file, const std::string& key);

/// Removes a result and its key, so that nothing old can be taken for the outcome of the next run.
void discard_result(const std::filesystem::path& result_file);

/// Notes what the result was made from. Throws FileError.
void note_key(const std::filesystem::path& result_file, const std::string& key);

} // namespace settle::compare
