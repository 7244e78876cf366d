#pragma once

#include <filesystem>

namespace kerf {

/// Keeps a recording for one writer: a lock on a file of its own beside it ("a.kerf-lock"), which goes away
/// with this object. The system takes it from a process that dies, whose file then means nothing.
class WriterLock {
 public:
  /// Throws std::runtime_error if somebody has it, or if the file cannot be made.
  explicit WriterLock(const std::filesystem::path& recording);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  std::filesystem::path path_;
  int owner_;  ///< a process that was forked meanwhile leaves the file alone
  int file_ = -1;
};

/// Whether somebody holds the lock. Does not take it, so that nobody is refused because of a question.
bool is_being_written(const std::filesystem::path& recording);

}  // namespace kerf
