#include "frames/support/part_file.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include "frames/support/atomic_file.h"

namespace kerf {

PartFile::PartFile(std::filesystem::path final_path)
    : final_path_(std::move(final_path)), part_(part_path(final_path_)), stream_(part_, std::ios::binary) {
  check();
}

PartFile::~PartFile() {
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void PartFile::check() const {
  if (!stream_) fail_to_write(final_path_, errno);
}

void PartFile::keep() {
  stream_.close();
  check();
  std::error_code error;
  std::filesystem::rename(part_, final_path_, error);
  if (error) fail_to_write(final_path_, error.value());
}

}  // namespace kerf
