/// \file
/// One campaign at a time in a folder.
#pragma once

#include <filesystem>

namespace settle::compare {

/// Who may hold a folder's lock beside its holder: nobody, or others who hold it in the same way.
enum class LockKind { alone, shared };

/// Holds the folder's lock until it is destroyed. The kernel gives it back when this process dies, whatever from, but
/// not before the last solver it has started: they hold it too. What a killed campaign has left running is ended by the
/// next one.
class FolderLock {
public:
  /// Throws InputError naming process, host and since when, where another campaign holds it, and FileError where the
  /// folder cannot be written. A shared lock waits a minute for who holds it alone.
  explicit FolderLock(const std::filesystem::path& folder, LockKind kind = LockKind::alone);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

private:
  int descriptor_ = -1;
};

} // namespace settle::compare
