/// \file
/// A folder for files between two programs.
#pragma once

#include <filesystem>

namespace settle::compare {

/// A folder of its own below the system's temporary one (TMPDIR), gone with all that is in it afterwards. Throws
/// FileError where it cannot be created.
class TemporaryFolder {
public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

} // namespace settle::compare
