#include "frames/support/result_file.h"

#include <cerrno>

#include "frames/support/atomic_file.h"

namespace kerf {

ResultFile::ResultFile(const std::filesystem::path& path, Replace replace)
    : part_(path.empty() ? nullptr : std::make_unique<PartFile>(path, replace)) {}

void ResultFile::save(std::string_view text, bool complete) {
  if (!part_) return;
  write_file_atomically(part_->path(), text);
  is_saved_ = true;
  if (complete) part_->keep();
}

std::string ResultFile::end_early() {
  if (!part_ || !is_saved_) return "nothing is kept";
  if (std::filesystem::exists(part_->final_path())) {
    part_->leave();
    return "what was measured is in " + part_->path().string();
  }
  part_->keep();
  return "what was measured is in " + part_->final_path().string();
}

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
