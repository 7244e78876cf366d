#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace kerf::test {

/// Changes in a film that draw the eye though nothing happens there.
struct FilmFlicker {
  std::uint32_t frames = 0;
  /// Pairs of neighbouring frames without highlighted operators whose camera stood still; the pixels that
  /// visibly changed, and those of them at which nothing came, went, moved or took another colour.
  std::uint32_t compared = 0;
  std::uint64_t changed = 0;
  std::uint64_t unexplained = 0;
  std::uint64_t most_unexplained = 0;  ///< in one frame
  std::uint32_t scale_changes =
      0;  ///< frames whose ramp of colours ends elsewhere than that of the frame before
  std::uint32_t view_changes = 0;    ///< frames in which the camera moved: every fixed thing is elsewhere
  std::uint32_t labels = 0;          ///< of operators, in two frames one after the other
  std::uint32_t label_jumps = 0;     ///< those that moved by more than two pixels
  std::vector<std::uint32_t> lives;  ///< in how many frames running each operator was highlighted, sorted
  std::uint64_t pairs = 0;           ///< in frames that have a neighbour on both sides
  std::uint64_t blinking_pairs = 0;  ///< those that only this frame has, or lacks, or shows in another colour
};

/// Looks at a folder of frames that were drawn with ids, in the order of their names. Throws
/// std::runtime_error if there are no two of them, or they cannot be read.
FilmFlicker measure_flicker(const std::filesystem::path& folder);

}  // namespace kerf::test
