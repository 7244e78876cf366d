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
/// continued or, if the user asks for it, keeps it until the new one is complete: that is then built apart,
/// in a fresh folder within.
class SequenceFolder {
 public:
  /// `name` is the beginning of the files' names. Throws UsageError if `path` is not a folder.
  SequenceFolder(std::filesystem::path path, std::string name);

  /// Where frames and manifest are written.
  [[nodiscard]] const std::filesystem::path& path() const { return apart_.empty() ? path_ : apart_; }
  [[nodiscard]] bool is_apart() const { return !apart_.empty(); }
  /// Throws UsageError if it holds a sequence and `overwrite` is false.
  void check_free(bool overwrite) const;
  /// Throws UsageError if another output would have the name of one of its files. An empty path is no output.
  void check_apart(const std::filesystem::path& out) const;
  /// The frames that an earlier run of the very same sequence has left; none if there is no folder yet.
  /// Throws UsageError if the folder holds another sequence.
  [[nodiscard]] KeptFrames frames_of(const Manifest& manifest) const;
  /// The same of a sequence that was begun apart, to replace the one that is here: if such a part is there,
  /// `path` is that from now on.
  [[nodiscard]] KeptFrames frames_begun_apart_of(const Manifest& manifest);
  /// From now on `path` is a fresh folder within; there is none until `make`. No other process may write.
  void build_apart();
  /// The same if the folder holds a sequence.
  void build_apart_from_earlier();
  /// Makes the folder and proves that it can be written. Throws std::runtime_error.
  void make() const;
  /// Brings all frames to the disk, then saves the manifest, and puts what was built apart in the place of
  /// the earlier sequence, of which nothing is left; other files stay. Whenever it is stopped in between, the
  /// folder holds the new manifest, marked incomplete, and `--resume` makes what lacks.
  void finish(Manifest manifest);
  /// Removes what was built apart.
  void give_up() const noexcept;
  /// Removes the unfinished files of a process that died. No other process may write at that time.
  void remove_parts() const noexcept;

 private:
  [[nodiscard]] std::vector<std::filesystem::path> files_of_sequence() const;

  void remove_useless_parts() const;
  void move_here(const std::filesystem::path& file) const;
  void put_in_place(const Manifest& manifest);

  std::filesystem::path path_;
  std::filesystem::path apart_;  ///< empty: frames are written into `path_`
  std::string name_;
};

}  // namespace kerf
