// What holds for every 3D scene, and what is special about those in which nothing drops.

#include <gmock/gmock.h>

#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "core/broad_phase/brute_force.h"
#include "sims3d/scenes/scenes.h"
#include "tests/support/scene_runs.h"

namespace kerf {

void PrintTo(const SceneEntry<3>& entry, std::ostream* stream);

namespace test {
namespace {

constexpr SceneOptions kSmall{.objects = 200, .steps = 60, .seed = 5};

class EveryScene3d : public testing::TestWithParam<SceneEntry<3>> {};

const SceneEntry<3>& entry_of(std::string_view name) {
  return *std::ranges::find(scenes_3d(), name, &SceneEntry<3>::name);
}

TEST_P(EveryScene3d, StatesWhatItNeeds) { expect_needs_hold<3>(GetParam()); }

TEST_P(EveryScene3d, ATreesPairsAreTheOraclesWhileItMoves) {
  expect_the_oracles_pairs<3>(GetParam(), kSmall, 110);
}

TEST_P(EveryScene3d, RunsAlikeWithEveryExactBroadPhase) {
  BruteForce<3> oracle;
  Bsp<3> tree(tuned_config());
  EXPECT_TRUE(same_runs<3>(GetParam(), kSmall, 90, oracle, tree));
}

TEST_P(EveryScene3d, OneObjectIsEnoughAndAbsurdNumbersAreRefused) {
  Bsp<3> tree;
  const auto scene = GetParam().make(tree, {.objects = 1, .steps = 1});
  for (int step = 0; step < 50; ++step) scene->advance();
  BruteForce<3> broad_phase;
  EXPECT_THROW(GetParam().make(broad_phase, {.objects = 100'001}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(All, EveryScene3d, testing::ValuesIn(scenes_3d().begin(), scenes_3d().end()),
                         [](const auto& entry) {
                           std::string name(entry.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(AttractorScene, CloudsStayNearAndNothingEverRests) {
  Bsp<3> tree;
  const auto scene = entry_of("attractors").make(tree, kSmall);
  for (int step = 1; step <= 400; ++step) {
    scene->advance();
    for (const Body<3>& body : scene->bodies()) ASSERT_LT(length(body.pose.position), 60) << "step " << step;
  }
  const std::vector<Body<3>> before(scene->bodies().begin(), scene->bodies().end());
  scene->advance();
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NE(scene->bodies()[k].pose.position, before[k].pose.position) << "object " << k;
}

TEST(FractureScene, BlocksBreakIntoTwentySevenAfterTheFirstHit) {
  Bsp<3> tree;
  const auto scene = entry_of("fracture").make(tree, {.objects = 280, .seed = 2});
  ASSERT_EQ(scene->bodies().size(), 10U) << "280 fragments are 10 blocks and a rest";
  std::size_t before = 10;
  for (int step = 1; step <= 300; ++step) {
    const bool hit = !scene->contacts().empty();
    scene->advance();
    const std::size_t now = scene->bodies().size();
    EXPECT_EQ((now - before) % 26, 0U) << "a block is replaced by 27";
    EXPECT_TRUE(hit || now == before) << "step " << step;
    before = now;
  }
  EXPECT_GT(before, 100U);
  const auto large = [](const Body<3>& body) { return std::get<Brick<3>>(body.shape).half[0] > 1; };
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(scene->bodies(), large)), 10 - (before - 10) / 26);
}

TEST(ProjectileScene, TheBallJumpsFurtherThanABlockIsWideAndScattersThem) {
  Bsp<3> tree;
  const auto scene = entry_of("projectile").make(tree, {.objects = 150, .seed = 1});
  const auto ball = static_cast<std::size_t>(
      std::ranges::find_if(scene->bodies(), [](const Body<3>& b) { return b.shape.index() == 0; }) -
      scene->bodies().begin());
  const std::vector<Body<3>> begin(scene->bodies().begin(), scene->bodies().end());
  float fastest = 0;
  for (int step = 1; step <= 250; ++step) {
    const Vector<3> before = scene->bodies()[ball].pose.position;
    scene->advance();
    const float way = length(scene->bodies()[ball].pose.position - before);
    if (way < 3) fastest = std::max(fastest, way);  // more is a new shot
  }
  EXPECT_GT(fastest, 1.5F);
  std::size_t scattered = 0;
  for (std::size_t k = ball + 1; k < begin.size(); ++k)
    scattered += length(scene->bodies()[k].pose.position - begin[k].pose.position) > 1 ? 1U : 0U;
  EXPECT_GT(scattered, 20U);
}

TEST(JellyScene, EveryBlockChangesItsExtentsInEveryStepAndKeepsItsVolume) {
  Bsp<3> tree;
  const auto scene = entry_of("jelly").make(tree, {.objects = 60, .seed = 1});
  const auto half = [&](std::size_t k) { return std::get<Brick<3>>(scene->bodies()[k].shape).half; };
  std::size_t first = 0;
  while (scene->bodies()[first].mobility == Mobility::fixed) ++first;
  const Vector<3> rest = half(first);
  for (int step = 1; step <= 200; ++step) {
    std::vector<Vector<3>> before;
    for (std::size_t k = first; k < scene->bodies().size(); ++k) before.push_back(half(k));
    scene->advance();
    for (std::size_t k = 0; k < before.size(); ++k) ASSERT_NE(half(first + k), before[k]) << "step " << step;
    const Vector<3> now = half(first);
    ASSERT_NEAR(now[0] * now[1] * now[2], rest[0] * rest[1] * rest[2], 1e-4);
  }
}

TEST(RodScene, FreeDirectionsPay) {
  const SceneEntry<3>& rods = entry_of("rods");
  const SceneOptions options{.objects = 480};
  const double free = candidates_of(rods, options, 60, {.max_redundancy = 0.1F});
  const double axes = candidates_of(rods, options, 60, {.free_directions = false, .max_redundancy = 0.1F});
  EXPECT_LT(free, 0.8 * axes);
}

}  // namespace
}  // namespace test
}  // namespace kerf
