#include "settle/compare/result_cache.hpp"

#include <fmt/format.h>

#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

namespace {

fs::path key_file(fs::path result_file) {
  return result_file.replace_extension(".key");
}

} // namespace

std::string result_key(const std::string& case_text, const fs::path& program) {
  return result_key(case_text, exchange::sha256(read_text(program)));
}

std::string result_key(const std::string& case_text, const std::string& solver_key) {
  return exchange::sha256(fmt::format("{}\n{}\n{}", case_text, solver_key, exchange::result_version));
}

bool is_up_to_date(const fs::path& result_file, const std::string& key) {
  std::error_code failure;
  if (!fs::exists(result_file, failure) || !fs::exists(key_file(result_file), failure)) return false;
  return read_text(key_file(result_file)) == key;
}

void discard_result(const fs::path& result_file) {
  std::error_code nothing_there;
  fs::remove(key_file(result_file), nothing_there);
  fs::remove(result_file, nothing_there);
}

void note_key(const fs::path& result_file, const std::string& key) {
  write_text(key_file(result_file), key);
}

} // namespace settle::compare
