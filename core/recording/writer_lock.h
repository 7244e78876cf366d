#pragma once

#include <filesystem>

namespace kerf {

/// Keeps a recording for one writer: a lock on a file of its own beside it ("a.kerf-lock"), which the
/// destructor removes. The lock of a process that dies is released; its file then means nothing.
class WriterLock {
 public:
  /// Throws std::runtime_error if another process has it, or if the file cannot be made.
  explicit WriterLock(const std::filesystem::path& recording);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  std::filesystem::path path_;
  int owner_;  ///< a process that was forked meanwhile leaves the file alone
  int file_ = -1;
};

/// Whether a process holds the lock. Does not take it, so the question refuses no writer.
bool is_being_written(const std::filesystem::path& recording);

}  // namespace kerf
