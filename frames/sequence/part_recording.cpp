#include "frames/sequence/part_recording.h"

#include <system_error>
#include <utility>

#include "core/recording/schema.h"
#include "frames/support/atomic_file.h"

namespace kerf {

/// A process that died may have left a part.
PartRecording::PartRecording(std::filesystem::path final_path)
    : final_path_(std::move(final_path)), lock_(final_path_), part_(part_path(final_path_)) {
  remove_recording(part_);
}

PartRecording::~PartRecording() { remove_recording(part_); }

/// The earlier recording goes first, with its log: SQLite would apply the log to the new file of that name.
void PartRecording::keep() {
  remove_recording(final_path_);
  std::error_code error;
  std::filesystem::rename(part_, final_path_, error);
  if (error) fail_to_write(final_path_, error.value());
}

}  // namespace kerf
