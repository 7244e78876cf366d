#pragma once

#include <filesystem>

#include "core/files/temporary_folder.h"

namespace kerf {

/// A new folder, which goes away with the object.
class ScratchFolder {
 public:
  /// Throws std::runtime_error if it cannot be made.
  explicit ScratchFolder(const std::filesystem::path& parent = temporary_folder());
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace kerf
