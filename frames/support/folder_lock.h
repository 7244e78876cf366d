#pragma once

#include <filesystem>

namespace kerf {

/// Keeps a folder for one render at a time, by a lock on the folder itself that ends with its process and the
/// processes forked meanwhile. A file system without locks gives none.
class FolderLock {
 public:
  /// Throws std::runtime_error if another process has it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace kerf
