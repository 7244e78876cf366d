#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "frames/sequence/manifest.h"

namespace kerf {

/// Hashes of pixels by a frame's index.
using KeptFrames = std::map<std::uint32_t, std::uint64_t>;

/// The folder of one frame sequence. It never mixes two sequences: a folder with an earlier one is refused,
/// continued or, if the user asks for it, cleared of it before the first frame is written.
class SequenceFolder {
 public:
  /// `name` is the beginning of the files' names. Throws UsageError if `path` is not a folder.
  SequenceFolder(std::filesystem::path path, std::string name);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Throws UsageError if it holds a sequence and `overwrite` is false.
  void check_free(bool overwrite) const;
  /// The frames that an earlier run of the very same sequence has left; none if there is no folder yet.
  /// Throws UsageError if the folder holds another sequence.
  [[nodiscard]] KeptFrames frames_of(const Manifest& manifest) const;
  /// Makes the folder and proves that it can be written. Throws std::runtime_error.
  void make() const;
  /// Removes the manifest and the frames of an earlier sequence, the manifest first, and nothing else.
  void clear() const;
  /// Removes the unfinished files of a process that died. No other process may write at that time.
  void remove_parts() const noexcept;

 private:
  [[nodiscard]] std::vector<std::filesystem::path> files_of_sequence() const;

  std::filesystem::path path_;
  std::string name_;
};

}  // namespace kerf
