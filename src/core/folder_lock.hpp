#pragma once

#include <filesystem>

namespace tdbd {

/// Locks a folder for one writer. The kernel releases the lock when the object is destroyed or the
/// process ends, even by a crash.
class FolderLock {
 public:
  /// Throws FolderError "output folder PATH: in use ..." if another writer has the lock, RunError
  /// if the folder cannot be opened. On file systems without locks, nothing is locked.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;  ///< open while the lock exists
};

}  // namespace tdbd
