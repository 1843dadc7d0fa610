/// \file
/// Whole text files.
#pragma once

#include <filesystem>
#include <string>

namespace settle::compare {

/// The whole content. Throws FileError.
std::string read_text(const std::filesystem::path& file);

/// Replaces the file as a whole: written beside it and renamed. Throws FileError.
void write_text(const std::filesystem::path& file, const std::string& text);

/// The folder, created where needed. Throws FileError.
void make_folder(const std::filesystem::path& folder);

} // namespace settle::compare
