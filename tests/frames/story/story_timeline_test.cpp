#include "frames/story/story_timeline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf {
namespace {

std::size_t held(const std::vector<StoryFrame>& frames) {
  return static_cast<std::size_t>(
      std::ranges::count_if(frames, [](const StoryFrame& frame) { return frame.moment.has_value(); }));
}

TEST(StoryTimeline, HasAllItsFramesFromTheFirstToTheLastStep) {
  const std::vector<std::uint32_t> moments{40, 70};
  const auto frames = story_frames(11, 100, moments, 600, 90);
  ASSERT_EQ(frames.size(), 600U);
  EXPECT_EQ(held(frames), 180U);
  EXPECT_EQ(frames.front().step, 11);
  EXPECT_DOUBLE_EQ(frames.back().step, 100);
  for (std::size_t k = 1; k < frames.size(); ++k) EXPECT_GE(frames[k].step, frames[k - 1].step) << k;
}

/// Time stands still at a moment, and its progress goes from one end to the other.
TEST(StoryTimeline, StandsStillAtAMoment) {
  const std::vector<std::uint32_t> moments{40};
  const auto frames = story_frames(1, 100, moments, 400, 50);
  const auto first = std::ranges::find_if(frames, [](const StoryFrame& f) { return f.moment.has_value(); });
  ASSERT_NE(first, frames.end());
  for (auto k = first; k != first + 50; ++k) {
    EXPECT_EQ(k->step, 40);
    EXPECT_EQ(k->moment, 0U);
  }
  EXPECT_LT(first->progress, 0.02);
  EXPECT_GT((first + 49)->progress, 0.98);
  EXPECT_LE((first - 1)->step, 40) << "what comes before is before";
}

TEST(StoryTimeline, IsSlowerBesideAMoment) {
  const std::vector<std::uint32_t> moments{50};
  const auto frames = story_frames(1, 100, moments, 1000, 10);
  const auto between = [&](double from, double to) {
    return std::ranges::count_if(frames, [&](const StoryFrame& frame) {
      return !frame.moment && frame.step >= from && frame.step < to;
    });
  };
  EXPECT_GT(between(48, 50), 3 * between(20, 22));
  EXPECT_GT(between(50, 52), 2 * between(20, 22));
}

TEST(StoryTimeline, PassesMomentsForWhichThereIsNoTime) {
  const std::vector<std::uint32_t> moments{10, 20, 30};
  const auto frames = story_frames(1, 40, moments, 100, 40);
  EXPECT_EQ(frames.size(), 100U);
  EXPECT_EQ(held(frames), 40U);
}

}  // namespace
}  // namespace kerf
