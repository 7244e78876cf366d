// What holds for every 2D scene, and what is special about those that do not rain.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/broad_phase/brute_force.h"
#include "sims2d/scenes/growth.h"
#include "tests/sims2d/scenes/scene_fixture.h"
#include "tests/sims2d/shapes.h"
#include "tests/support/scene_runs.h"

namespace kerf::test {
namespace {

constexpr SceneOptions kSmall{.objects = 200, .steps = 60, .seed = 5};

class EveryScene2d : public Scenes2d {};

const SceneEntry<2>& entry_of(std::string_view name) {
  return *std::ranges::find(scenes_2d(), name, &SceneEntry<2>::name);
}

TEST_P(EveryScene2d, StatesWhatItNeeds) {
  expect_needs_hold<2>(GetParam());
  EXPECT_FALSE(GetParam().needs.separating[2]);
}

TEST_P(EveryScene2d, ATreesPairsAreTheOraclesWhileItMoves) {
  expect_the_oracles_pairs<2>(GetParam(), kSmall, 150);
}

TEST_P(EveryScene2d, RunsAlikeWithEveryExactBroadPhase) {
  BruteForce<2> oracle;
  Bsp<2> tree;
  EXPECT_TRUE(same_runs<2>(GetParam(), kSmall, 200, oracle, tree));
}

TEST_P(EveryScene2d, AnotherSeedIsAnotherRun) {
  SceneOptions other = kSmall;
  ++other.seed;
  BruteForce<2> broad_phases[2];
  const auto a = make(broad_phases[0], kSmall);
  const auto b = make(broad_phases[1], other);
  a->advance();
  b->advance();
  bool same = a->bodies().size() == b->bodies().size();
  for (std::size_t k = 0; same && k < a->bodies().size(); ++k)
    same = a->bodies()[k].box == b->bodies()[k].box;
  EXPECT_FALSE(same && a->bodies().size() > 3);
}

TEST_P(EveryScene2d, BoxesHoldTheShapesThatAreDrawn) {
  Bsp<2> tree;
  const auto scene = make(tree, kSmall);
  for (int step = 1; step <= 120; ++step) {
    scene->advance();
    for (const Body<2>& body : scene->bodies())
      for (const Vector<2>& p : rim(body)) ASSERT_TRUE(contains(body.box, Box<2>{p, p})) << "step " << step;
  }
}

TEST_P(EveryScene2d, OneObjectIsEnoughAndAbsurdNumbersAreRefused) {
  Bsp<2> tree;
  const auto scene = make(tree, {.objects = 1, .steps = 1});
  for (int step = 0; step < 50; ++step) scene->advance();
  BruteForce<2> broad_phase;
  EXPECT_THROW(make(broad_phase, {.objects = kMaxObjects2d + 1}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(All, EveryScene2d, ::testing::ValuesIn(scenes_2d().begin(), scenes_2d().end()),
                         scene_name);

TEST(AttractorScene2d, CloudsStayNearAndNothingEverRests) {
  BruteForce<2> broad_phase;
  const auto scene = entry_of("attractors").make(broad_phase, kSmall);
  for (int step = 1; step <= 500; ++step) {
    scene->advance();
    for (const Body<2>& body : scene->bodies()) ASSERT_LT(length(body.pose.position), 80) << "step " << step;
  }
  const std::vector<Body<2>> before(scene->bodies().begin(), scene->bodies().end());
  scene->advance();
  scene->advance();
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NE(scene->bodies()[k].pose.position, before[k].pose.position) << "object " << k;
}

TEST(FractureScene2d, BlocksBreakIntoSixteenAndNoMatterIsLost) {
  BruteForce<2> broad_phase;
  const auto scene = entry_of("fracture").make(broad_phase, {.objects = 170, .seed = 2});
  ASSERT_EQ(scene->bodies().size(), 10U) << "170 fragments are 10 blocks and a rest";
  std::size_t before = 10;
  for (int step = 1; step <= 500; ++step) {
    scene->advance();
    const std::size_t now = scene->bodies().size();
    EXPECT_EQ((now - before) % 15, 0U) << "a block is replaced by 16";
    before = now;
  }
  EXPECT_GT(before, 100U);
}

TEST(PyramidScene2d, StandsUntilTheDiscComesAndThenBreaks) {
  Bsp<2> tree;
  const auto scene = entry_of("pyramid").make(tree, {.objects = 56});
  const std::vector<Body<2>> begin(scene->bodies().begin(), scene->bodies().end());
  const auto moved = [&] {
    float most = 0;
    for (std::size_t k = 4; k < begin.size(); ++k)
      most = std::max(most, length(scene->bodies()[k].pose.position - begin[k].pose.position));
    return most;
  };
  for (int step = 0; step < 30; ++step) scene->advance();
  EXPECT_LT(moved(), 0.1F);
  for (int step = 0; step < 170; ++step) scene->advance();
  EXPECT_GT(moved(), 0.5F);
}

TEST(TumblerScene2d, TheDrumTurnsAndHoldsWhatIsInIt) {
  Bsp<2> tree;
  const auto scene = entry_of("tumbler").make(tree, {.objects = 100, .seed = 3});
  const Vector<2> wall = scene->bodies()[0].pose.position;
  const float reach = 1.1F * std::sqrt(2.0F) * length(wall);
  for (int step = 1; step <= 500; ++step) {
    scene->advance();
    for (const Body<2>& body : scene->bodies())
      ASSERT_LT(length(body.pose.position), reach) << "step " << step;
  }
  EXPECT_NEAR(length(scene->bodies()[0].pose.position), length(wall), 1e-3);
  EXPECT_GT(length(scene->bodies()[0].pose.position - wall), 1);
}

TEST(RodScene2d, FreeDirectionsPay) {
  const SceneEntry<2>& rods = entry_of("rods");
  const SceneOptions options{.objects = 480};
  const double free = candidates_of(rods, options, 60, {.max_redundancy = 0.1F});
  const double axes = candidates_of(rods, options, 60, {.free_directions = false, .max_redundancy = 0.1F});
  EXPECT_LT(free, 0.8 * axes);
}

}  // namespace
}  // namespace kerf::test
