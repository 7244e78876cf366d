#include "frames/story/story_timeline.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kSlowness = 5;     ///< beside a moment a step takes so much longer
constexpr double kSlowBefore = 10;  ///< steps
constexpr double kSlowAfter = 4;

/// How long a step takes, far from all moments 1.
double cost_of(std::uint32_t step, std::span<const std::uint32_t> moments) {
  double nearness = 0;
  for (const std::uint32_t moment : moments) {
    const double away = double{1} * step - moment;
    nearness = std::max(nearness, 1 - std::abs(away) / (away < 0 ? kSlowBefore : kSlowAfter));
  }
  return 1 + (kSlowness - 1) * nearness * nearness * (3 - 2 * nearness);
}

}  // namespace

std::vector<StoryFrame> story_frames(std::uint32_t first, std::uint32_t last,
                                     std::span<const std::uint32_t> moments, std::uint32_t frames,
                                     std::uint32_t hold) {
  const std::uint64_t held = std::uint64_t{hold} * moments.size();
  if (2 * held > frames) return story_frames(first, last, moments.first(moments.size() - 1), frames, hold);
  // Before step k of the range, `passed[k]` has passed.
  std::vector<double> passed{0};
  for (std::uint32_t step = first; step < last; ++step)
    passed.push_back(passed.back() + cost_of(step, moments));
  const auto moving = static_cast<std::uint32_t>(frames - held);
  std::vector<StoryFrame> story;
  std::size_t next = 0;
  std::size_t k = 0;
  for (std::uint32_t frame = 0; frame < moving; ++frame) {
    const double now = moving == 1 ? 0 : passed.back() * frame / (moving - 1);
    while (k + 2 < passed.size() && passed[k + 1] <= now) ++k;
    const double part = passed.size() == 1 ? 0 : (now - passed[k]) / (passed[k + 1] - passed[k]);
    const double step = first + static_cast<double>(k) + std::min(1.0, part);
    for (; next < moments.size() && step >= moments[next]; ++next)
      for (std::uint32_t h = 0; h < hold; ++h)
        story.push_back({double{1} * moments[next], next, (h + 0.5) / hold});
    story.push_back({step, std::nullopt, 0});
  }
  return story;
}

}  // namespace kerf
