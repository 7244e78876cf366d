#include <gtest/gtest.h>

#include <utility>

#include "core/base/random.h"
#include "core/broad_phase/brute_force.h"
#include "tests/sims2d/broad_phase_doubles.h"
#include "tests/sims2d/scenes/scene_fixture.h"
#include "tests/support/scene_runs.h"

namespace kerf::test {
namespace {

class SceneTrajectories : public Scenes2d {};

constexpr SceneOptions kOptions{.objects = 200, .steps = 100, .seed = 7};
constexpr int kSteps = 400;

TEST_P(SceneTrajectories, DoNotDependOnTheOrderOfPairs) {
  BruteForce<2> plain;
  BruteForce<2> inner;
  WatchedBroadPhase shuffled(inner);
  Random random(1);
  shuffled.edit_pairs = [&](std::vector<Pair>& pairs) {
    for (std::size_t left = pairs.size(); left > 1; --left)
      std::swap(pairs[left - 1], pairs[random.below(static_cast<std::uint32_t>(left))]);
  };
  EXPECT_TRUE(same_runs<2>(GetParam(), kOptions, kSteps, plain, shuffled));
}

TEST_P(SceneTrajectories, DependOnEveryPair) {
  BruteForce<2> plain;
  BruteForce<2> inner;
  WatchedBroadPhase forgetful(inner);
  forgetful.edit_pairs = [](std::vector<Pair>& pairs) {
    if (pairs.size() > 100) pairs.pop_back();
  };
  EXPECT_FALSE(same_runs<2>(GetParam(), kOptions, kSteps, plain, forgetful));
}

INSTANTIATE_TEST_SUITE_P(All, SceneTrajectories, ::testing::ValuesIn(rain_scenes()), scene_name);

}  // namespace
}  // namespace kerf::test
