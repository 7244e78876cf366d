#include "frames/support/part_stream.h"

#include <cerrno>

namespace kerf {

PartStream::PartStream(const std::filesystem::path& final_path, Replace replace)
    : part_(final_path, replace), stream_(part_.path(), std::ios::binary | std::ios::in | std::ios::out) {
  check();
}

void PartStream::check() const {
  if (!stream_) fail_to_write(part_.final_path(), errno);
}

void PartStream::keep() {
  stream_.close();
  check();
  part_.keep();
}

}  // namespace kerf
