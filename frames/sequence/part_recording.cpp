#include "frames/sequence/part_recording.h"

#include <stdexcept>

#include "core/recording/schema.h"
#include "frames/sequence/recording_file.h"
#include "frames/support/atomic_file.h"

namespace kerf {

PartRecording::PartRecording(const std::filesystem::path& final_path, Replace replace)
    : lock_(final_path), part_(final_path, replace) {}

/// The log of an earlier recording whose writer was killed would be applied to whatever has the name.
void PartRecording::keep() {
  fold_log(part_.final_path());
  part_.keep();
  is_done_ = true;
  lock_.reset();
}

/// Also of a recording that was not ended, which without a log would get one when it is read. A full disk may
/// not take what is in the log.
bool PartRecording::fold_own_log() const {
  try {
    Database::open_to_end(part_.path()).close();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::filesystem::path PartRecording::keep_as_far_as_it_came() {
  if (std::filesystem::exists(part_.final_path()) || !fold_own_log()) {
    leave();
    return part_.path();
  }
  keep();
  return part_.final_path();
}

void PartRecording::leave() {
  part_.leave();
  is_done_ = true;
  lock_.reset();
}

std::string PartRecording::steps() const {
  try {
    return with_recording(part_.path(), [](const auto& reader) -> std::string {
      if (reader->steps() == 0) return "";
      return reader->info().names.steps(1, reader->steps());
    });
  } catch (const std::exception&) {
    return "";
  }
}

/// Returns if there is nothing to be left, or if the part was left already and `why` says so.
void PartRecording::leave_if_any(const std::string& why) {
  if (part_.is_left()) return;
  const std::string kept = steps();
  if (kept.empty()) return;
  leave();
  throw std::runtime_error(
      with_disk_advice(why + "; what was recorded (" + kept + ") is in " + part_.path().string()));
}

}  // namespace kerf
