#pragma once

#include <filesystem>

namespace kerf {

/// Where temporary files go: TMPDIR, or /tmp. Throws std::runtime_error if it is no folder.
std::filesystem::path temporary_folder();

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
