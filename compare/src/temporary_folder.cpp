#include "temporary_folder.hpp"

#include <cstdlib>
#include <string>

#include "settle/exchange/errors.hpp"

namespace settle::compare {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "settle-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw exchange::FileError({.where = fs::temp_directory_path().string(),
                               .what = "a temporary folder cannot be created",
                               .given = {},
                               .allowed = {},
                               .remedy = "set TMPDIR to a folder that can be written"});
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored; // nothing is lost with a temporary folder that stays
  fs::remove_all(path_, ignored);
}

} // namespace settle::compare
