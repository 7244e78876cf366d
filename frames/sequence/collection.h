#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "frames/sequence/manifest.h"
#include "viz/image/image.h"

namespace kerf {

/// A frame and its file.
struct CollectedFrame {
  FrameRecord record;
  std::filesystem::path path;
  std::vector<std::filesystem::path> others;  ///< the same picture, as the manifests of further folders say
};

/// The frames of one sequence from the folders of its shards.
struct Collection {
  Manifest manifest;                   ///< of the whole sequence, with the frames that were found
  std::vector<CollectedFrame> frames;  ///< by index, without those that are missing
  std::uint32_t folders = 0;
  bool has_ids = false;  ///< a frame has files beside it: then all of them must

  [[nodiscard]] bool is_complete() const { return frames.size() == manifest.steps.frames(); }
};

/// Reads the folders' manifests. Throws UsageError, with both folders and the difference, if they are not of
/// one sequence, std::runtime_error if there is no manifest or two folders have different pictures of a
/// frame.
Collection collect(const std::vector<std::filesystem::path>& folders);

/// Which frames are missing and how to make them, in a few words; empty if none are.
std::string describe_gaps(const Collection& collection);

/// What is wrong with a frame, whose picture is read into `image`: with the file, and with what must lie
/// beside it. Where several folders have the frame, `path` is the first good one from now on. Empty: nothing.
/// Throws if a file cannot be opened: then nothing is known of it.
std::string trouble_with(CollectedFrame& frame, bool has_ids, Image& image);

/// Frames whose pictures are missing, damaged or others than were drawn.
class BadFrames {
 public:
  explicit BadFrames(const Collection& collection)
      : shards_(collection.manifest.shard.count), has_ids_(collection.has_ids) {}
  void add(std::uint32_t index, const std::string& trouble);
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// A line for each of the first few, and how to make them.
  [[nodiscard]] std::string describe() const;

 private:
  std::uint32_t shards_;  ///< of the sequence
  bool has_ids_;
  std::size_t count_ = 0;
  std::string text_;
  std::set<std::uint32_t> bad_shards_;
};

/// Puts all frames, the files beside them (as hard links, or copies where that is impossible) and one
/// manifest into a folder. Throws UsageError if the folder holds a sequence and `overwrite` is false,
/// std::runtime_error with path and reason if a file cannot be written.
void gather(const Collection& collection, const std::filesystem::path& folder, bool overwrite);

}  // namespace kerf
