#pragma once

#include <filesystem>

#include "core/recording/writer_lock.h"

namespace kerf {

/// A recording under a temporary name beside its final one. The destructor removes it unless it was kept, so
/// that an earlier recording of that name stays until the new one is complete.
class PartRecording {
 public:
  /// Throws std::runtime_error if somebody is making a recording of that name.
  explicit PartRecording(std::filesystem::path final_path);
  ~PartRecording();
  PartRecording(const PartRecording&) = delete;
  PartRecording& operator=(const PartRecording&) = delete;

  /// Where it is written.
  [[nodiscard]] const std::filesystem::path& path() const { return part_; }
  /// Gives it its final name, in place of an earlier recording. Throws std::system_error with path and
  /// reason.
  ///
  /// Pre: the file is closed.
  void keep();

 private:
  std::filesystem::path final_path_;
  WriterLock lock_;  ///< of the final name: nobody else makes a recording that will have it
  std::filesystem::path part_;
};

}  // namespace kerf
