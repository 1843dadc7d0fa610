#include "settle/compare/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::FileError;
namespace fs = std::filesystem;

namespace {

FileError unwritable(const fs::path& file, const std::string& given) {
  return FileError({.where = file.string(),
                    .what = "the file cannot be written",
                    .given = given,
                    .allowed = {},
                    .remedy = "check that the folder exists, may be written, and has space"});
}

} // namespace

std::string read_text(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  std::ostringstream text;
  if (input) text << input.rdbuf();
  if (!input)
    throw FileError(
        {.where = file.string(), .what = "the file cannot be read", .given = {}, .allowed = {}, .remedy = {}});
  return text.str();
}

void sync_to_disk(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && fsync(descriptor) == 0;
  const std::string failure = done ? std::string() : std::strerror(errno);
  if (descriptor >= 0) close(descriptor);
  if (!done) throw unwritable(file, failure);
}

void write_text(const fs::path& file, const std::string& text) {
  fs::path partial = file;
  partial += ".partial";
  std::error_code failure;
  try {
    std::ofstream output(partial, std::ios::binary);
    output << text;
    output.close();
    if (!output) throw unwritable(file, std::strerror(errno));
    fs::rename(partial, file, failure);
    if (failure) throw unwritable(file, failure.message());
  } catch (...) {
    fs::remove(partial, failure);
    throw;
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
