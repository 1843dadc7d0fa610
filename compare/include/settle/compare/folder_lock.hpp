/// \file
/// One campaign at a time in a folder.
#pragma once

#include <filesystem>

namespace settle::compare {

/// Holds the folder's lock until it is destroyed. The kernel gives it back when this process dies, whatever from, but
/// not before the last solver it has started: they hold it too. What a killed campaign has left running is ended by the
/// next one.
class FolderLock {
public:
  /// Throws InputError naming process, host and since when, where another campaign holds it, and FileError where the
  /// folder cannot be written.
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

private:
  int descriptor_ = -1;
};

} // namespace settle::compare
