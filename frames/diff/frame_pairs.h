#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frames/diff/manifest_diff.h"

namespace kerf {

/// Two pictures to compare. An empty path: that side has none.
struct FramePair {
  std::string name;  ///< of the file; in folders the way to it from there
  std::filesystem::path reference;
  std::filesystem::path test;
  std::vector<std::string> beside{};  ///< what lies beside only one of the two, in words
  [[nodiscard]] bool is_missing() const { return test.empty(); }
  [[nodiscard]] bool is_extra() const { return reference.empty(); }
};

/// The pictures to compare.
struct PairedFrames {
  std::vector<FramePair> frames;  ///< by name
  std::vector<ManifestDiff> manifests;
  std::vector<std::string> notes;   ///< notes for the reader, such as a sequence that was interrupted
  std::vector<std::string> faults;  ///< what makes a folder unusable: what was not compared, or promised
};

/// Whether there must be references.
enum class WithoutReferences { refuse, accept };

/// Pairs two files, or the PNG files of two folders and the folders in them by their names. What else lies
/// there must be the same on both sides, or is a fault (`compare_others`). Throws std::runtime_error if one
/// of them is not there, cannot be read, holds no PNG, or one is a file and the other a folder. `accept`: a
/// reference folder that is empty or not there makes all frames of the test side extra ones.
PairedFrames pair_frames(const std::filesystem::path& reference, const std::filesystem::path& test,
                         WithoutReferences without = WithoutReferences::refuse);

}  // namespace kerf
