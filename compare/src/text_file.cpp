#include "settle/compare/text_file.hpp"

#include <fstream>
#include <sstream>

#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::FileError;
namespace fs = std::filesystem;

std::string read_text(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  std::ostringstream text;
  if (input) text << input.rdbuf();
  if (!input)
    throw FileError(
        {.where = file.string(), .what = "the file cannot be read", .given = {}, .allowed = {}, .remedy = {}});
  return text.str();
}

void write_text(const fs::path& file, const std::string& text) {
  fs::path partial = file;
  partial += ".partial";
  std::ofstream output(partial, std::ios::binary);
  output << text;
  output.close();
  std::error_code failure;
  if (output) fs::rename(partial, file, failure);
  if (!output || failure) {
    throw FileError({.where = file.string(),
                     .what = "the file cannot be written",
                     .given = failure ? failure.message() : std::string(),
                     .allowed = {},
                     .remedy = "check that the folder exists, may be written, and has space"});
  }
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure) return;
  throw FileError({.where = folder.string(),
                   .what = "the folder cannot be created",
                   .given = failure.message(),
                   .allowed = {},
                   .remedy = "choose another place with --out"});
}

} // namespace settle::compare
