#pragma once

#include <filesystem>

namespace tdbd {

/// Holds a folder for one writer. The kernel lets go of it when the object goes or the process ends, however it ends.
class FolderLock {
 public:
  /// Throws FolderError "output folder PATH: in use ..." when another writer holds it, RunError when it cannot be opened.
  /// Where the file system knows no locks, nothing is held.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;  ///< open while it is held
};

}  // namespace tdbd
