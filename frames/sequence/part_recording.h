#pragma once

#include <cstdint>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "core/files/part_file.h"
#include "core/recording/database.h"
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
  /// Whether it has a name of its own, or was left.
  [[nodiscard]] bool is_done() const { return is_done_; }

  /// Calls `work`, which writes the recording and keeps it. Where the disk takes no more, or memory ends,
  /// steps that were committed are left where they are, as after a kill, and a std::runtime_error says where,
  /// and up to which step. Other exceptions leave through it, and then the part goes away with the object.
  ///
  /// Pre: the recorder is gone when `work` is left.
  template <class Work>
  auto write(Work work) {
    try {
      return work();
    } catch (const CannotWrite& error) {
      leave_if_any(error.what());
      throw;
    } catch (const std::system_error& error) {
      leave_if_any(error.what());
      throw;
    } catch (const std::bad_alloc&) {
      leave_if_any("not enough memory");
      throw;
    }
  }

  /// Gives it its final name, in place of an earlier recording, from when on others may replace it. Throws
  /// std::system_error with path and reason.
  ///
  /// Pre: the file is closed.
  void keep();
  /// Of a run that ended early: gives it its final name if that is free, for an earlier recording that is
  /// whole is not replaced by a part of one. Returns where it is.
  std::filesystem::path keep_as_far_as_it_came();
  /// Leaves it where it is written.
  void leave();
  /// The steps that were committed, in words: "steps 1 to 40"; empty: none.
  ///
  /// Pre: the file is closed.
  [[nodiscard]] std::string steps() const;

 private:
  void leave_if_any(const std::string& why);
  [[nodiscard]] bool fold_own_log() const;

  std::optional<WriterLock> lock_;  ///< of the final name, until it is done: no other is made of that name
  PartFile part_;
  bool is_done_ = false;
};

}  // namespace kerf
