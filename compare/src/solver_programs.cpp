#include "settle/compare/solver_programs.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "settle/compare/process.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

std::string program_name(const std::string& solver) {
  return "settle-" + solver;
}

std::string program_variable(const std::string& solver) {
  std::string name = "SETTLE_" + solver;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return letter == '-' ? '_' : static_cast<char>(std::toupper(letter)); });
  return name;
}

fs::path find_program(const std::string& name) {
  std::error_code failure;
  const fs::path self = fs::read_symlink("/proc/self/exe", failure);
  const fs::path beside = self.parent_path() / name;
  if (!self.empty() && fs::is_regular_file(beside, failure)) return beside;
  return find_in_path(name);
}

fs::path find_solver(const std::string& solver) {
  std::error_code failure;
  if (const char* named = std::getenv(program_variable(solver).c_str()); named != nullptr && *named != '\0') {
    return fs::is_regular_file(named, failure) ? fs::absolute(named) : fs::path();
  }
  return find_program(program_name(solver));
}

} // namespace settle::compare
