#pragma once

#include <filesystem>

namespace kerf {

/// A new folder below the system's temporary one, which goes away with the object.
class ScratchFolder {
 public:
  /// Throws std::runtime_error if it cannot be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace kerf
