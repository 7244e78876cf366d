#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "core/bsp/bsp.h"
#include "tests/sims2d/box2d_reference.h"
#include "tests/sims2d/broad_phase_doubles.h"
#include "tests/sims2d/scenes/scene_fixture.h"

namespace kerf::test {
namespace {

class SceneContacts : public Scenes2d {};

/// Pairs that only one of the two has. Box2D does not look at two sleeping bodies again, so what is said of
/// them dates from the pose before their last motion and is left out.
std::vector<Pair> differences(const Reference& reference, std::span<const Pair> contacts) {
  std::vector<Pair> differ;
  std::set_symmetric_difference(reference.touching.begin(), reference.touching.end(), contacts.begin(),
                                contacts.end(), std::back_inserter(differ));
  std::erase_if(
      differ, [&](const Pair& p) { return !reference.awake[p.a.index()] && !reference.awake[p.b.index()]; });
  return differ;
}

TEST_P(SceneContacts, EqualThoseOfBox2DsOwnBroadPhaseFromTheSameState) {
  Bsp<2> tree;
  WatchedBroadPhase broad_phase(tree);
  const auto scene = make(broad_phase, {.objects = 150, .steps = 60, .seed = 3});
  Reference reference;
  broad_phase.before_step = [&] { reference = box2d_contacts(world_of(*scene).engine()); };
  std::size_t compared = 0;
  std::size_t asleep = 0;
  for (int step = 1; step <= 700; ++step) {
    scene->advance();
    const std::vector<Pair> differ = differences(reference, scene->contacts());
    ASSERT_TRUE(differ.empty()) << "step " << step << ": " << differ.size() << " differ, first "
                                << differ.front().a.value << "-" << differ.front().b.value;
    for (const Pair& p : scene->contacts())
      ++(reference.awake[p.a.index()] || reference.awake[p.b.index()] ? compared : asleep);
  }
  EXPECT_GT(compared, 20'000U) << "too few contacts for the test to mean anything";
  EXPECT_GT(asleep, 0U) << "nothing fell asleep";
}

TEST_P(SceneContacts, AreAllAmongThePairsAndSorted) {
  Bsp<2> tree;
  const auto scene = make(tree, {.objects = 150, .steps = 60, .seed = 4});
  for (int step = 1; step <= 700; ++step) {
    scene->advance();
    std::vector<Pair> pairs(scene->pairs().begin(), scene->pairs().end());
    std::sort(pairs.begin(), pairs.end());
    const auto contacts = scene->contacts();
    ASSERT_TRUE(std::is_sorted(contacts.begin(), contacts.end()));
    ASSERT_TRUE(std::includes(pairs.begin(), pairs.end(), contacts.begin(), contacts.end()))
        << "step " << step;
    ASSERT_EQ(static_cast<std::size_t>(world_of(*scene).engine().GetContactCount()), pairs.size());
  }
}

TEST_P(SceneContacts, AreNoneWhenTheBroadPhaseIsSilent) {
  SilentBroadPhase silent;
  const auto scene = make(silent, {.objects = 100, .steps = 50, .seed = 1});
  for (int step = 1; step <= 400; ++step) {
    scene->advance();
    ASSERT_EQ(world_of(*scene).engine().GetContactCount(), 0);
    ASSERT_TRUE(scene->contacts().empty());
  }
  for (const Body<2>& body : scene->bodies())
    EXPECT_EQ(body.pose.position[1] < -1, body.mobility == Mobility::moving) << "all fell through the ground";
}

INSTANTIATE_TEST_SUITE_P(All, SceneContacts, ::testing::ValuesIn(rain_scenes()), scene_name);

}  // namespace
}  // namespace kerf::test
