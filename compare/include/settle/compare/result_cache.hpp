/// \file
/// Results that need not be computed again: a key beside each result says what it was made from.
#pragma once

#include <filesystem>
#include <string>

namespace settle::compare {

/// SHA-256 of the case with its defaults, the solver's program and the version of the result format.
/// Throws FileError where the program cannot be read.
std::string result_key(const std::string& case_text, const std::filesystem::path& program);

/// The same of a solver that is known by a text, such as its command and the hashes of its files.
std::string result_key(const std::string& case_text, const std::string& solver_key);

/// Was the result made from the same case by the same program?
bool is_up_to_date(const std::filesystem::path& result_file, const std::string& key);

/// Removes a result and its key, so that nothing old can be taken for the outcome of the next run.
void discard_result(const std::filesystem::path& result_file);

/// Notes what the result was made from. Throws FileError.
void note_key(const std::filesystem::path& result_file, const std::string& key);

} // namespace settle::compare
