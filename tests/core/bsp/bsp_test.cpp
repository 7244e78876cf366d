#include "core/bsp/bsp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/bsp/state_codec.h"
#include "core/trace/event_facts.h"
#include "core/tree/hash.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/pairs.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

constexpr const char* kEager =
    "max_redundancy=0.4,schedule_interval=1,budget_divisor=2,min_threshold=4,max_threshold=8";

static_assert(sizeof(kerf::Bsp<3, NoTrace>) + sizeof(EventLog) == sizeof(kerf::Bsp<3, EventLog>),
              "a tree without a trace pays nothing for it");

template <class T>
class Bsp : public testing::Test {};
TYPED_TEST_SUITE(Bsp, Dimensions, DimensionNames);

/// One restless step for a crowd.
template <int D>
void stir(MovingBoxes<D>& crowd, std::uint32_t step) {
  crowd.bounce(1);
  if (step % 20 == 0) crowd.teleport();
  if (step % 7 == 0) crowd.replace(5);
}

TYPED_TEST(Bsp, RequestsTakeEffectInTheNextStep) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree;
  ASSERT_EQ(tree.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  ASSERT_EQ(tree.insert({1}, slab<kD>(1, 2), Mobility::moving), Status::ok);
  EXPECT_TRUE(tree.pairs().empty());
  tree.step();
  EXPECT_EQ(difference(tree.pairs(), std::vector<Pair>{{{0}, {1}}}), "");
  ASSERT_EQ(tree.remove({1}), Status::ok);
  EXPECT_EQ(tree.pairs().size(), 1U) << "of the last step";
  tree.step();
  EXPECT_TRUE(tree.pairs().empty());
  EXPECT_EQ(tree.steps(), 2U);
}

/// Requests in any order, with objects twice, unknown ones and bad boxes among them.
TYPED_TEST(Bsp, ThreadsTakeRequestsAsOneAfterAnotherWould) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kCount = 3000;
  for (const bool ascending : {true, false}) {
    Random random(31);
    kerf::Bsp<kD> shared(tuned_config());
    kerf::Bsp<kD> alone(tuned_config());
    shared.set_threads(3, Sharing::always);
    for (std::uint32_t id = 0; id < kCount; id += 2) {
      ASSERT_EQ(shared.insert({id}, slab<kD>(0, 1), Mobility::moving), Status::ok);
      ASSERT_EQ(alone.insert({id}, slab<kD>(0, 1), Mobility::moving), Status::ok);
    }
    for (int step = 0; step < 12; ++step) {
      std::vector<ObjectId> objects;
      std::vector<Box<kD>> boxes;
      for (std::uint32_t k = 0; k < kCount; ++k) {
        const auto place = static_cast<Scalar>(random.uniform(0, 2000));
        objects.push_back({ascending ? k : random.below(kCount)});
        boxes.push_back(k % 100 == 7 ? slab<kD>(1, 0) : slab<kD>(place, place + 1));
      }
      Status first = Status::ok;
      for (std::uint32_t k = 0; k < kCount; ++k) {
        const Status status = alone.move(objects[k], boxes[k]);
        if (first == Status::ok) first = status;
      }
      EXPECT_EQ(shared.move_many(objects, boxes), first);
      alone.step();
      shared.step();
      ASSERT_EQ(difference(shared.pairs(), alone.pairs()), "") << "step " << step;
      ASSERT_EQ(hash(shared.tree()), hash(alone.tree())) << "step " << step;
    }
  }
}

/// Engines pass volumes. The volume of a box is the box, also for an object that stays in its fat one.
TYPED_TEST(Bsp, AVolumeThatIsABoxMovesAsTheBoxDoes) {
  constexpr int kD = TypeParam::value;
  Random random(5);
  kerf::Bsp<kD> by_boxes(tuned_config());
  kerf::Bsp<kD> by_volumes(tuned_config());
  for (std::uint32_t id = 0; id < 100; ++id) {
    ASSERT_EQ(by_boxes.insert({id}, slab<kD>(0, 1), Mobility::moving), Status::ok);
    ASSERT_EQ(by_volumes.insert({id}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  }
  for (int step = 0; step < 60; ++step) {
    for (std::uint32_t id = 0; id < 100; ++id) {
      const auto place = static_cast<Scalar>(id + 0.02 * random.uniform(-1, 1));
      ASSERT_EQ(by_boxes.move({id}, slab<kD>(place, place + 1)), Status::ok);
      ASSERT_EQ(by_volumes.move({id}, make_box_volume(slab<kD>(place, place + 1))), Status::ok);
    }
    by_boxes.step();
    by_volumes.step();
    ASSERT_EQ(by_volumes.statistics().placed, by_boxes.statistics().placed) << "step " << step;
    ASSERT_EQ(by_volumes.state_hash(), by_boxes.state_hash()) << "step " << step;
  }
}

TYPED_TEST(Bsp, AnswersBadRequestsAndForgetsThem) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree;
  EXPECT_EQ(tree.move({5}, slab<kD>(0, 1)), Status::unknown_id);
  EXPECT_EQ(tree.remove({5}), Status::unknown_id);
  EXPECT_EQ(tree.insert(ObjectId::none(), slab<kD>(0, 1), Mobility::moving), Status::unknown_id);
  ASSERT_EQ(tree.insert({5}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(tree.insert({5}, slab<kD>(0, 1), Mobility::moving), Status::duplicate_id);
  tree.step();
  EXPECT_EQ(tree.statistics().objects, 1U);
  EXPECT_EQ(tree.statistics().placed, 1U);
}

TYPED_TEST(Bsp, WantsABoxForEachObjectThatMoves) {
  kerf::Bsp<TypeParam::value> bsp;
  ASSERT_EQ(bsp.insert({0}, slab<TypeParam::value>(0, 1), Mobility::moving), Status::ok);
  const ObjectId objects[] = {{0}, {0}};
  const Box<TypeParam::value> boxes[] = {slab<TypeParam::value>(4, 5)};
  EXPECT_THROW((void)bsp.move_many(objects, boxes), std::invalid_argument);
  EXPECT_EQ(bsp.objects().box({0}), (slab<TypeParam::value>(0, 1)));
}

TYPED_TEST(Bsp, OnlyTheLastRequestOfAStepCounts) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree;
  ASSERT_EQ(tree.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  ASSERT_EQ(tree.insert({1}, slab<kD>(5, 6), Mobility::moving), Status::ok);
  ASSERT_EQ(tree.move({1}, slab<kD>(0, 1)), Status::ok);
  ASSERT_EQ(tree.remove({1}), Status::ok);
  ASSERT_EQ(tree.insert({1}, slab<kD>(8, 9), Mobility::moving), Status::ok);
  tree.step();
  EXPECT_TRUE(tree.pairs().empty());
  ASSERT_EQ(tree.move({1}, slab<kD>(1, 0)), Status::quarantined);
  ASSERT_EQ(tree.move({1}, slab<kD>(1, 2)), Status::ok);
  tree.step();
  EXPECT_EQ(tree.pairs().size(), 1U);
  EXPECT_TRUE(is_sound(tree.tree()));
}

TYPED_TEST(Bsp, MobilityMayChangeWithTheIdInOneStep) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree;
  ASSERT_EQ(tree.insert({0}, slab<kD>(0, 1), Mobility::fixed), Status::ok);
  ASSERT_EQ(tree.insert({1}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  tree.step();
  EXPECT_EQ(tree.pairs().size(), 1U);
  ASSERT_EQ(tree.remove({1}), Status::ok);
  ASSERT_EQ(tree.insert({1}, slab<kD>(0, 1), Mobility::fixed), Status::ok);
  tree.step();
  EXPECT_TRUE(tree.pairs().empty());
}

TYPED_TEST(Bsp, DirectionsCannotChangeInMidRun) {
  kerf::Bsp<TypeParam::value> tree;
  EXPECT_THROW(tree.set_config(config_of("seed=2")), std::invalid_argument);
  EXPECT_THROW(tree.set_config(config_of("directions=128")), std::invalid_argument);
  Config bad;
  bad.max_height = 64;
  EXPECT_THROW(tree.set_config(bad), std::invalid_argument);
  EXPECT_THROW(kerf::Bsp<TypeParam::value>{bad}, std::invalid_argument);
  EXPECT_EQ(to_string(tree.config()), to_string(Config{}));
  tree.set_config(config_of(kEager));
  EXPECT_EQ(tree.config().max_threshold, 8U);
}

TYPED_TEST(Bsp, EqualRunsHaveEqualHashesPairsAndEvents) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD, EventLog> one(config_of(kEager));
  kerf::Bsp<kD, EventLog> two(config_of(kEager));
  kerf::Bsp<kD> unwatched(config_of(kEager));
  MovingBoxes<kD> crowd_one(one, 40, 1.5, 3);
  MovingBoxes<kD> crowd_two(two, 40, 1.5, 3);
  MovingBoxes<kD> crowd_unwatched(unwatched, 40, 1.5, 3);
  crowd_one.add(200, 6);
  crowd_two.add(200, 6);
  crowd_unwatched.add(200, 6);
  for (std::uint32_t step = 1; step <= 60; ++step) {
    stir(crowd_one, step);
    stir(crowd_two, step);
    stir(crowd_unwatched, step);
    one.step();
    two.step();
    unwatched.step();
    ASSERT_EQ(one.state_hash(), two.state_hash()) << "in step " << step;
    ASSERT_EQ(one.state_hash(), unwatched.state_hash()) << "watching changed the run in step " << step;
    ASSERT_TRUE(std::equal(one.pairs().begin(), one.pairs().end(), two.pairs().begin(), two.pairs().end()));
  }
  const auto events = one.trace().take();
  const auto same = two.trace().take();
  ASSERT_EQ(events.size(), same.size());
  for (std::size_t i = 0; i < events.size(); ++i) ASSERT_EQ(describe(events[i], {}), describe(same[i], {}));
}

TYPED_TEST(Bsp, EventsAreNumberedWithoutAGapAndPhasesComeInOrder) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD, EventLog> tree(config_of(kEager));
  MovingBoxes<kD> crowd(tree, 40, 1.5, 3);
  crowd.add(200);
  std::map<std::uint32_t, std::string> phases;
  std::uint64_t next = 0;
  for (std::uint32_t step = 1; step <= 30; ++step) {
    stir(crowd, step);
    tree.step();
    for (const Event& event : tree.trace().take()) {
      ASSERT_EQ(event.id, next++);
      ASSERT_EQ(event.step, step);
      if (const auto phase = phase_of(event)) phases[step] += std::string(to_string(*phase)) + " ";
    }
    EXPECT_EQ(phases[step], "place sort schedule operate sweep ");
  }
}

TYPED_TEST(Bsp, ReportsWhichObjectsWerePlaced) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD, EventLog> tree(config_of("budget_divisor=0"));
  const auto placements = [&] {
    tree.step();
    std::string text;
    for (const Event& event : tree.trace().take())
      if (const auto* const placed = placed_of(event))
        text += std::to_string(placed->object.value) + ":" + std::to_string(placed->leaves) + " ";
    return text;
  };
  ASSERT_EQ(tree.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  ASSERT_EQ(tree.insert({1}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(placements(), "0:1 1:1 ");
  EXPECT_EQ(placements(), "");
  ASSERT_EQ(tree.move({0}, slab<kD>(3, 4)), Status::ok);
  EXPECT_EQ(placements(), "") << "in the same leaf";
  ASSERT_EQ(tree.remove({0}), Status::ok);
  ASSERT_EQ(tree.move({1}, slab<kD>(4, 3)), Status::quarantined);
  EXPECT_EQ(placements(), "0:0 1:0 ");
  ASSERT_EQ(tree.move({1}, slab<kD>(3, 4)), Status::ok);
  EXPECT_EQ(placements(), "1:1 ");
}

TYPED_TEST(Bsp, StatisticsSayWhatTheTreeIs) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD, EventLog> tree(config_of(kEager));
  MovingBoxes<kD> crowd(tree, 40, 1.5, 5);
  crowd.add(200);
  std::array<std::uint64_t, kOperatorCount> acted{};
  std::uint64_t refused = 0;
  for (std::uint32_t step = 1; step <= 60; ++step) {
    stir(crowd, step);
    tree.step();
    for (const Event& event : tree.trace().take()) {
      if (const auto* e = acted_of(event)) ++acted.at(static_cast<std::size_t>(e->op));
      refused += refused_of(event) == nullptr ? 0U : 1U;
    }
  }
  const Statistics s = tree.statistics();
  EXPECT_EQ(s.operators, acted);
  EXPECT_EQ(s.refused, refused);
  EXPECT_EQ(s.objects, 200U);
  std::uint32_t leaves = 0;
  std::uint64_t entries = 0;
  std::uint32_t height = 0;
  for_each_node(tree.tree(), tree.tree().root(), [&](NodeId id) {
    leaves += tree.tree()[id].is_leaf() ? 1U : 0U;
    entries += tree.tree()[id].entries.size();
    height = std::max(height, tree.tree()[id].depth);
  });
  EXPECT_EQ(s.leaves, leaves);
  EXPECT_EQ(s.entries, entries);
  EXPECT_EQ(s.height, height);
  EXPECT_DOUBLE_EQ(s.redundancy, static_cast<double>(entries) / 200 - 1);
  double seconds = 0;
  for (const double phase : s.phase_seconds) {
    EXPECT_GE(phase, 0);
    seconds += phase;
  }
  EXPECT_GT(seconds, 0);
  EXPECT_LT(seconds, 10) << "of one step";
}

/// Objects that fly, rest and fly again, so that the tree goes through all its modes but the paper's.
TYPED_TEST(Bsp, OtherThreadsInEachStepChangeNothing) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kCount = 1500;
  Random random(8);
  kerf::Bsp<kD> alone(tuned_config());
  kerf::Bsp<kD> shared(tuned_config());
  std::vector<ObjectId> objects;
  std::vector<Box<kD>> boxes;
  for (std::uint32_t k = 0; k < kCount; ++k) {
    const auto place = static_cast<Scalar>(random.uniform(0, 700));
    objects.push_back({k});
    boxes.push_back(slab<kD>(place, place + 1));
    ASSERT_EQ(alone.insert({k}, boxes[k], Mobility::moving), Status::ok);
    ASSERT_EQ(shared.insert({k}, boxes[k], Mobility::moving), Status::ok);
  }
  std::set<Mode> modes;
  for (std::uint32_t step = 0; step < 90; ++step) {
    const double speed = step < 20 || step >= 70 ? 2 : 0.001;
    for (Box<kD>& box : boxes) {
      const auto by = static_cast<Scalar>(random.uniform(-speed, speed));
      box.min[0] += by;
      box.max[0] += by;
    }
    shared.set_threads(1 + step % 3, Sharing::always);
    for (kerf::Bsp<kD>* tree : {&alone, &shared}) {
      ASSERT_EQ(tree->move_many(objects, boxes), Status::ok);
      tree->step();
    }
    ASSERT_TRUE(std::ranges::equal(shared.pairs(), alone.pairs())) << step;
    ASSERT_EQ(shared.state_hash(), alone.state_hash()) << step;
    modes.insert(shared.mode());
  }
  EXPECT_EQ(modes, (std::set{Mode::swept, Mode::kept}));
}

TYPED_TEST(Bsp, TimesItsPhasesOnlyIfItIsAsked) {
  kerf::Bsp<TypeParam::value> tree;
  const auto seconds_of_a_step = [&tree] {
    tree.step();
    double sum = 0;
    for (const double phase : tree.statistics().phase_seconds) sum += phase;
    return sum;
  };
  EXPECT_EQ(seconds_of_a_step(), 0);
  tree.time_phases(true);
  EXPECT_GT(seconds_of_a_step(), 0);
  tree.time_phases(false);
  EXPECT_EQ(seconds_of_a_step(), 0);
}

TYPED_TEST(Bsp, StatisticsOfNothingAreZero) {
  kerf::Bsp<TypeParam::value> tree;
  tree.step();
  const Statistics s = tree.statistics();
  EXPECT_EQ(s.objects, 0U);
  EXPECT_EQ(s.entries, 0U);
  EXPECT_EQ(s.redundancy, 0);
  EXPECT_EQ(s.leaves, 1U);
  EXPECT_EQ(s.height, 0U);
}

TYPED_TEST(Bsp, TreeOfAStepIsAKeyframeThatLaterStepsDoNotTouch) {
  constexpr int kD = TypeParam::value;
  kerf::Bsp<kD> tree(config_of(kEager));
  MovingBoxes<kD> crowd(tree, 40, 1.5, 5);
  crowd.add(100);
  for (std::uint32_t step = 1; step <= 10; ++step) tree.step();
  const kerf::Tree<kD> keyframe = tree.tree();
  const std::uint64_t before = hash(keyframe);
  for (std::uint32_t step = 1; step <= 30; ++step) {
    stir(crowd, step);
    tree.step();
  }
  EXPECT_EQ(hash(keyframe), before);
  EXPECT_NE(hash(tree.tree()), before);
  EXPECT_TRUE(is_sound(keyframe));
}

/// Of a tree whose only object has an id that a new tree refuses: another one was there when it came.
Bytes state_of_a_far_object(ObjectId far) {
  kerf::Bsp<2> tree;
  EXPECT_EQ(tree.insert({0}, slab<2>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(tree.insert(far, slab<2>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(tree.remove({0}), Status::ok);
  tree.step();
  return encode_state(tree.state());
}

TEST(StateCodec, IdsFarBeyondTheNumberOfObjectsStayTaken) {
  const ObjectId far{kFreeIds + 3};
  const Bytes bytes = state_of_a_far_object(far);
  const BspState<2> state =
      decode_state<2>(bytes, bytes.size(), make_projector<2>(Config{}, VolumeKind::box));
  EXPECT_TRUE(state.latest.is_placed(far));
  kerf::Bsp<2> again;
  again.restore(state);
  EXPECT_EQ(again.remove(far), Status::ok);
  again.step();
  EXPECT_EQ(again.insert(far, slab<2>(0, 1), Mobility::moving), Status::ok) << "there is room for it";
}

}  // namespace
}  // namespace kerf::test
