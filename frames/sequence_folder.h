#pragma once

#include <filesystem>

namespace kerf {

/// The folder of one frame sequence. It never mixes two sequences: a folder that holds an earlier one is
/// refused or, if the user said so, cleared of it before the first frame is written.
class SequenceFolder {
 public:
  /// Throws UsageError if `path` holds a sequence and `overwrite` is false, or is not a folder.
  SequenceFolder(std::filesystem::path path, bool overwrite);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Makes the folder and proves that it can be written. Throws std::runtime_error.
  void make() const;
  /// Removes the manifest and the frames of an earlier sequence, the manifest first, and nothing else.
  void clear() const;

 private:
  std::filesystem::path path_;
};

}  // namespace kerf
