#pragma once

#include <filesystem>

#include "core/files/part_file.h"
#include "core/recording/writer_lock.h"

namespace kerf {

/// A recording that is built beside its final name (PartFile), so that an earlier one stays until the new one
/// is complete. While it is built, and if the process is killed, `recording_at` finds it.
class PartRecording {
 public:
  /// Throws std::runtime_error if another process is making a recording of that name, and std::system_error
  /// with path and reason.
  PartRecording(const std::filesystem::path& final_path, Replace replace);

  /// Where it is written.
  [[nodiscard]] const std::filesystem::path& path() const { return part_.path(); }
  /// Gives it its final name, in place of an earlier recording. Throws std::system_error with path and
  /// reason.
  ///
  /// Pre: the file is closed.
  void keep();
  /// Of a run that ended early: gives it its final name if that is free, for an earlier recording that is
  /// whole is not replaced by a part of one. Returns where it is.
  std::filesystem::path keep_as_far_as_it_came();
  /// Leaves it where it is written.
  void leave() { part_.leave(); }

 private:
  WriterLock lock_;  ///< of the final name: no other process makes a recording of that name
  PartFile part_;
};

}  // namespace kerf
