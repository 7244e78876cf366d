#include "frames/sequence/part_recording.h"

#include "core/recording/schema.h"

namespace kerf {

PartRecording::PartRecording(const std::filesystem::path& final_path, Replace replace)
    : lock_(final_path), part_(final_path, replace) {}

/// The log of an earlier recording whose writer was killed would be applied to whatever has the name.
void PartRecording::keep() {
  fold_log(part_.final_path());
  part_.keep();
}

std::filesystem::path PartRecording::keep_as_far_as_it_came() {
  if (std::filesystem::exists(part_.final_path())) {
    part_.leave();
    return part_.path();
  }
  keep();
  return part_.final_path();
}

}  // namespace kerf
