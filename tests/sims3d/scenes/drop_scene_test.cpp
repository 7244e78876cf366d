#include "sims3d/scenes/drop_scene.h"

#include <gmock/gmock.h>

#include "core/broad_phase/brute_force.h"

namespace kerf {
namespace {

using testing::HasSubstr;

constexpr Box<3> kLarge{{{-50, -50, -50}}, {{50, 1e6F, 50}}};

std::size_t moving(const Scene<3>& scene) {
  std::size_t count = 0;
  for (const Body<3>& body : scene.bodies()) count += body.mobility == Mobility::moving ? 1 : 0;
  return count;
}

const auto kNothing = [](OdeWorld&) {};
const auto kFloor = [](OdeWorld& world) { world.add_fixed(Brick<3>{{{20, 1, 20}}}, {{0, -1, 0}}); };

TEST(DropScene, TheNumberGrowsEvenly) {
  BruteForce<3> broad_phase;
  Drop drop{.objects = 10, .steps = 4, .sites = {{{0, 5, 0}}, {{3, 5, 0}}}, .inside = kLarge, .physics = {}};
  DropScene scene(broad_phase, {}, 1, drop, kFloor);
  for (const std::size_t expected : {3U, 5U, 8U, 10U, 10U, 10U}) {
    scene.advance();
    EXPECT_EQ(moving(scene), expected) << "step " << scene.step();
  }
}

TEST(DropScene, ObjectsOfOneSiteAppearClearOfEachOther) {
  BruteForce<3> broad_phase;
  Drop drop{.objects = 20, .steps = 10, .sites = {{{0, 5, 0}}}, .inside = kLarge, .physics = {}};
  DropScene scene(broad_phase, {}, 1, drop, kFloor);
  std::size_t before = 0;
  for (int i = 0; i < 10; ++i) {
    scene.advance();
    for (const Pair pair : scene.contacts())
      EXPECT_LT(pair.b.index(), before) << "a new object touches something in step " << scene.step();
    before = scene.bodies().size();
  }
  EXPECT_EQ(moving(scene), 20U);
}

TEST(DropScene, TheShowerWandersAndServesEachSiteAlike) {
  BruteForce<3> broad_phase;
  Drop drop;
  drop.objects = 100;
  drop.steps = 100;
  drop.inside = kLarge;
  for (int i = 0; i < 10; ++i) drop.sites.push_back({{static_cast<float>(3 * i), 5, 0}});
  DropScene scene(broad_phase, {}, 1, drop, kNothing);
  std::vector<std::size_t> drops(10, 0);
  std::vector<float> halves(2, 0);
  for (std::size_t k = 0; k < 100; ++k) {
    scene.advance();
    const float x = scene.bodies()[k].pose.position[0];
    ++drops[static_cast<std::size_t>(x / 3 + 0.5F)];
    halves[k / 50] += x / 50;
  }
  EXPECT_THAT(drops, testing::Each(10U));
  EXPECT_LT(halves[0] + 10, halves[1]);
}

TEST(DropScene, StraysArePutBackOnASite) {
  BruteForce<3> broad_phase;
  const Box<3> inside{{{-5, -2, -5}}, {{5, 1e6F, 5}}};
  Drop drop{.objects = 1, .steps = 1, .sites = {{{0, 5, 0}}}, .inside = inside, .physics = {}};
  DropScene scene(broad_phase, {}, 1, drop, kNothing);
  for (int i = 0; i < 100; ++i) {
    scene.advance();
    ASSERT_GT(scene.bodies()[0].pose.position[1], -3);
  }
  EXPECT_GE(scene.put_back(), 2U);
}

TEST(DropScene, AbsurdNumbersAreRefusedWithTheLimit) {
  EXPECT_EQ(resolve({.objects = 0, .steps = 0, .seed = 3}, 600, 400).objects, 600U);
  EXPECT_EQ(resolve({.objects = 0, .steps = 0, .seed = 3}, 600, 400).steps, 400U);
  EXPECT_EQ(resolve({.objects = 100'000, .steps = 7, .seed = 3}, 600, 400).objects, 100'000U);
  EXPECT_EQ(resolve({.objects = 5, .steps = 7, .seed = 3}, 600, 400).seed, 3U);
  try {
    resolve({.objects = 100'001, .steps = 0, .seed = 1}, 600, 400);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("at most 100000"));
  }
  EXPECT_THROW(resolve({.objects = 1, .steps = 2'000'000, .seed = 1}, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
