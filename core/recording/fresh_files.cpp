#include "core/recording/fresh_files.h"

#include <system_error>
#include <utility>

namespace kerf {

FreshFiles::FreshFiles(std::filesystem::path database) : database_(std::move(database)) {
  for (const char* const ending : {"", "-wal", "-shm"}) {
    const std::filesystem::path file = database_.string() + ending;
    std::error_code none;
    if (std::filesystem::symlink_status(file, none).type() == std::filesystem::file_type::not_found)
      ours_.push_back(file);
  }
}

FreshFiles::~FreshFiles() {
  if (is_kept_) return;
  std::error_code ignored;
  for (const std::filesystem::path& file : ours_) std::filesystem::remove(file, ignored);
  std::filesystem::resize_file(database_, 0, ignored);
}

}  // namespace kerf
