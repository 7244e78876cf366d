#include "frames/story/story_still.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kHalfOnItsWay = 0.45;

std::uint32_t size_of(const StoryMoment& moment) { return moment.acted.after.population; }

}  // namespace

std::uint32_t frame_of_still(std::span<const StoryFrame> frames, std::span<const StoryMoment> moments,
                             std::span<const StoryMoment> operators, std::uint32_t hold) {
  std::uint32_t most = 0;
  auto still = static_cast<std::uint32_t>(frames.size() / 2);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    if (!frames[k].moment || std::abs(frames[k].progress - kHalfOnItsWay) > 0.5 / hold) continue;
    const std::uint32_t size = size_of(moments[*frames[k].moment]);
    if (size > most) still = static_cast<std::uint32_t>(k);
    most = std::max(most, size);
  }
  if (most > 0 || operators.empty()) return still;
  const auto largest = std::ranges::max_element(operators, {}, size_of);
  const auto behind = std::ranges::find_if(
      frames, [&](const StoryFrame& frame) { return frame.step >= static_cast<double>(largest->step); });
  return behind == frames.end() ? still : static_cast<std::uint32_t>(behind - frames.begin());
}

}  // namespace kerf
