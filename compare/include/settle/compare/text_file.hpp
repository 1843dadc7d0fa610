/// \file
/// Whole text files.
#pragma once

#include <filesystem>
#include <string>

namespace settle::compare {

/// The whole content. Throws FileError.
std::string read_text(const std::filesystem::path& file);

/// Replaces the file as a whole: written beside it and renamed. Nothing is left beside it where that fails. Throws
/// FileError.
void write_text(const std::filesystem::path& file, const std::string& text);

/// Waits until a file's content is on the disk. Throws FileError.
void sync_to_disk(const std::filesystem::path& file);

/// The folder, created where needed. Throws FileError.
void make_folder(const std::filesystem::path& folder);

} // namespace settle::compare
