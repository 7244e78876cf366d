#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "tests/sims2d/broad_phase_doubles.h"
#include "tests/sims2d/scenes/scene_fixture.h"

namespace kerf::test {
namespace {

class SceneTrajectories : public Scenes2d {};

constexpr SceneOptions kOptions{.objects = 200, .steps = 100, .seed = 7};
constexpr int kSteps = 400;

bool same_state(const Scene<2>& a, const Scene<2>& b) {
  return std::ranges::equal(a.bodies(), b.bodies(), [](const Body<2>& x, const Body<2>& y) {
    return x.pose.position == y.pose.position && x.pose.axes == y.pose.axes && x.box == y.box;
  });
}

/// The step at which two scenes part, or 0.
int first_difference(Scene<2>& a, Scene<2>& b) {
  for (int step = 1; step <= kSteps; ++step) {
    a.advance();
    b.advance();
    if (!same_state(a, b) || !std::ranges::equal(a.contacts(), b.contacts())) return step;
  }
  return 0;
}

TEST_P(SceneTrajectories, AreBitIdenticalWithEveryExactBroadPhase) {
  BruteForce<2> brute_force;
  Bsp<2> tree;
  const auto a = make(brute_force, kOptions);
  const auto b = make(tree, kOptions);
  EXPECT_EQ(first_difference(*a, *b), 0);
}

TEST_P(SceneTrajectories, DoNotDependOnTheOrderOfPairs) {
  BruteForce<2> plain;
  BruteForce<2> inner;
  WatchedBroadPhase shuffled(inner);
  Random random(1);
  shuffled.edit_pairs = [&](std::vector<Pair>& pairs) {
    for (std::size_t left = pairs.size(); left > 1; --left)
      std::swap(pairs[left - 1], pairs[random.below(static_cast<std::uint32_t>(left))]);
  };
  const auto a = make(plain, kOptions);
  const auto b = make(shuffled, kOptions);
  EXPECT_EQ(first_difference(*a, *b), 0);
}

TEST_P(SceneTrajectories, DependOnEveryPair) {
  BruteForce<2> plain;
  BruteForce<2> inner;
  WatchedBroadPhase forgetful(inner);
  forgetful.edit_pairs = [](std::vector<Pair>& pairs) {
    if (pairs.size() > 100) pairs.pop_back();
  };
  const auto a = make(plain, kOptions);
  const auto b = make(forgetful, kOptions);
  EXPECT_NE(first_difference(*a, *b), 0);
}

TEST_P(SceneTrajectories, RepeatWithTheSameSeedAndDifferWithAnother) {
  BruteForce<2> broad_phases[3];
  SceneOptions other = kOptions;
  ++other.seed;
  const auto a = make(broad_phases[0], kOptions);
  const auto b = make(broad_phases[1], kOptions);
  const auto c = make(broad_phases[2], other);
  EXPECT_EQ(first_difference(*a, *b), 0);
  c->advance();
  c->advance();
  BruteForce<2> broad_phase;
  const auto fresh = make(broad_phase, kOptions);
  fresh->advance();
  fresh->advance();
  EXPECT_FALSE(same_state(*fresh, *c));
}

INSTANTIATE_TEST_SUITE_P(All, SceneTrajectories, ::testing::ValuesIn(rain_scenes()), scene_name);

}  // namespace
}  // namespace kerf::test
