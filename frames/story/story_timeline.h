#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace kerf {

/// What one picture of a story shows.
struct StoryFrame {
  double step = 1;                    ///< between two steps, objects are on their way
  std::optional<std::size_t> moment;  ///< at which time stands still
  double progress = 0;                ///< of that moment, from 0 to 1
};

/// Divides `frames` pictures among the steps from `first` to `last`. At each moment (steps, rising, within
/// the range) time stands still for `hold` pictures; before it, it slows down, and behind it, it gathers
/// speed. Moments for which there are too few pictures are passed without a hold.
std::vector<StoryFrame> story_frames(std::uint32_t first, std::uint32_t last,
                                     std::span<const std::uint32_t> moments, std::uint32_t frames,
                                     std::uint32_t hold);

}  // namespace kerf
