// Algorithm 1 of the paper, line by line.

#include "core/tree/scheduler.h"

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

#include "core/tree/hash.h"
#include "core/tree/swap.h"
#include "tests/core/tree/scheduler_scenes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

template <class T>
class Algorithm1 : public testing::Test {
 protected:
  using Scene = SchedulerScene<T::value>;

  void traverse(Scene& scene, const char* config = "", std::uint32_t step = 10) {
    scheduler.traverse(scene.tree, with(config), step, reporter);
    EXPECT_TRUE(sound(scene));
  }
  void process(Scene& scene, const char* config = "", std::uint32_t step = 10) {
    scheduler.process(scene.tree, with(config), step, reporter);
    EXPECT_TRUE(sound(scene));
  }
  static testing::AssertionResult sound(Scene& scene) {
    sort_phase(scene.tree);
    return is_sound(scene.tree);
  }
  static Config with(const char* config) {
    Config result = config_of(kSceneConfig);
    kerf::apply(result, config);
    return result;
  }

  kerf::Scheduler<T::value> scheduler;
  Reporter<EventLog> reporter;
};
TYPED_TEST_SUITE(Algorithm1, Dimensions, DimensionNames);

TYPED_TEST(Algorithm1, Line1DoesNotTraverseWhileOtherEventsThanMergesArePending) {
  auto scene = scene_of<TypeParam::value>({Cell::shifting, Cell::crowded, Cell::stuck});
  this->traverse(scene);
  this->process(scene);  // one of three
  ASSERT_EQ(this->scheduler.pending(), 2U);
  reported(this->reporter);
  this->traverse(scene, "", 20);
  EXPECT_THAT(reported(this->reporter), IsEmpty());
  this->process(scene, "budget_divisor=1", 20);
  reported(this->reporter);
  this->traverse(scene, "min_threshold=3,max_threshold=3", 30);
  EXPECT_THAT(reported(this->reporter), testing::Not(IsEmpty())) << "nothing is pending any more";
}

TYPED_TEST(Algorithm1, Line1TraversesAndListsMergesAfreshWhileOnlyMergesArePending) {
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::thin, Cell::thin, Cell::calm});
  this->traverse(scene);
  ASSERT_EQ(this->scheduler.pending(), 3U);
  this->process(scene);
  ASSERT_EQ(this->scheduler.pending(), 2U);
  reported(this->reporter);
  this->traverse(scene, "", 20);
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::merge, scene.node[1]),
                                                    scheduled(Operator::merge, scene.node[2])));
  EXPECT_EQ(this->scheduler.pending(), 2U) << "none is listed twice";
}

TYPED_TEST(Algorithm1, Line1TraversesOncePerInterval) {
  auto scene = scene_of<TypeParam::value>({Cell::crowded});
  for (std::uint32_t step = 1; step < 10; ++step) this->traverse(scene, "", step);
  EXPECT_THAT(reported(this->reporter), IsEmpty());
  this->traverse(scene, "", 10);
  EXPECT_EQ(this->scheduler.pending(), 1U);
  kerf::Scheduler<TypeParam::value> other;
  other.traverse(scene.tree, this->with("schedule_interval=7"), 14, this->reporter);
  EXPECT_EQ(other.pending(), 1U);
}

TYPED_TEST(Algorithm1, Lines3To5BalanceAtOnceAndListNothing) {
  auto scene = scene_of<TypeParam::value>({Cell::calm, Cell::shiftable});
  const NodeId node = scene.node[1];
  this->traverse(scene);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(acted(Operator::balance, node, "7 (7 | 0)", "7 (3 | 4)")));
  EXPECT_EQ(this->scheduler.pending(), 0U);
  EXPECT_EQ(this->scheduler.acted()[static_cast<std::size_t>(Operator::balance)], 1U);
}

TYPED_TEST(Algorithm1, Line6ListsASwapWhenNoShiftIsValid) {
  auto scene = scene_of<TypeParam::value>({Cell::calm, Cell::stuck});
  const std::uint64_t before = hash(scene.tree);
  this->traverse(scene);
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::swap, scene.node[1])));
  EXPECT_EQ(hash(scene.tree), before) << "a swap waits for line 16";
  EXPECT_EQ(this->scheduler.listed(Operator::swap), std::vector{scene.tree.ref(scene.node[1])});
}

TYPED_TEST(Algorithm1, Line6TreatsAStraddledNodeLikeAnUnbalancedOne) {
  constexpr int kD = TypeParam::value;
  SchedulerScene<kD> scene{tree_of<kD>(std::vector(7, slab<kD>(0, 10))), {}};
  plant(scene.tree, scene.tree.root(), 0, 5);
  this->traverse(scene, "repair_redundancy=0.5");
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::swap, scene.tree.root())));
}

TYPED_TEST(Algorithm1, AnOperatorThatIsOffLeavesItsWorkToTheNextOrUndone) {
  const auto listed = [this](Cell cell, const char* off) {
    auto scene = scene_of<TypeParam::value>({Cell::calm, cell});
    this->scheduler = {};
    this->traverse(scene, off);
    const std::vector<std::string> lines = reported(this->reporter);
    return lines.empty() ? std::string() : lines.front().substr(0, lines.front().find(' '));
  };
  EXPECT_EQ(listed(Cell::shiftable, ""), "balance");
  EXPECT_EQ(listed(Cell::shiftable, "balance=0"), "swap");
  EXPECT_EQ(listed(Cell::stuck, "swap=0"), "split") << "the walk goes on below";
  EXPECT_EQ(listed(Cell::shifting, ""), "shift-split");
  EXPECT_EQ(listed(Cell::shifting, "shift_split=0"), "split");
  EXPECT_EQ(listed(Cell::crowded, "split=0"), "");
  EXPECT_EQ(listed(Cell::thin, ""), "merge");
  EXPECT_EQ(listed(Cell::thin, "merge=0"), "");
}

TYPED_TEST(Algorithm1, Line7StopsBelowAnUnbalancedNode) {
  for (const Cell cell : {Cell::stuck, Cell::shiftable}) {
    auto scene = scene_of<TypeParam::value>({cell, Cell::calm});
    ASSERT_GT(scene.tree[scene.tree[scene.node[0]].left].population, 6U) << "the leaf below is crowded";
    this->scheduler = {};
    this->traverse(scene);
    EXPECT_EQ(reported(this->reporter).size(), 1U);
  }
}

TYPED_TEST(Algorithm1, Line9ListsAShiftSplitWhereOneIsValidAndElseASplit) {
  auto scene = scene_of<TypeParam::value>({Cell::shifting, Cell::crowded, Cell::calm});
  const std::uint64_t before = hash(scene.tree);
  this->traverse(scene);
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::shift_split, scene.node[0]),
                                                    scheduled(Operator::split, scene.node[1])));
  EXPECT_EQ(hash(scene.tree), before);
}

TYPED_TEST(Algorithm1, Line9SplitsARootThatHasNoPlaneToShift) {
  auto scene = scene_of<TypeParam::value>({Cell::shifting});
  this->traverse(scene);
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::split, scene.tree.root())));
}

TYPED_TEST(Algorithm1, Line9ListsAMergeForAThinNode) {
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::calm});
  this->traverse(scene);
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::merge, scene.node[0])));
}

TYPED_TEST(Algorithm1, Line9SplitsOnlyAboveTheThresholdAndMergesOnlyBelowIts) {
  auto scene = scene_of<TypeParam::value>({Cell::shifting, Cell::thin, Cell::calm});
  this->traverse(scene, "min_threshold=7,max_threshold=7,merge_fraction=0.2");
  EXPECT_THAT(reported(this->reporter), IsEmpty()) << "7 objects at t = 7, 2 objects and merges below 1";
  this->traverse(scene, "min_threshold=7,max_threshold=7,merge_fraction=0.3");
  EXPECT_THAT(reported(this->reporter), IsEmpty()) << "2 objects and merges below 2";
  this->traverse(scene, "min_threshold=7,max_threshold=7,merge_fraction=0.5");
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::merge, scene.node[1])));
}

TYPED_TEST(Algorithm1, Line10StopsBelowAThinNode) {
  // The root is thin for this threshold, and so are the nodes below it.
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::thin});
  this->traverse(scene, "min_threshold=20,max_threshold=20");
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::merge, scene.tree.root())));
}

TYPED_TEST(Algorithm1, Line11GoesOnInEverySubtreeWhereNothingHappened) {
  auto scene = scene_of<TypeParam::value>(
      {Cell::calm, Cell::shiftable, Cell::shifting, Cell::calm, Cell::crowded, Cell::thin, Cell::stuck});
  this->traverse(scene);
  EXPECT_THAT(
      reported(this->reporter),
      ElementsAre(acted(Operator::balance, scene.node[1], "7 (7 | 0)", "7 (3 | 4)"),
                  scheduled(Operator::shift_split, scene.node[2]), scheduled(Operator::split, scene.node[4]),
                  scheduled(Operator::merge, scene.node[5]), scheduled(Operator::swap, scene.node[6])));
}

TYPED_TEST(Algorithm1, Lines14To17ProcessByKindAndOldestFirst) {
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::stuck, Cell::crowded, Cell::shifting, Cell::thin,
                                           Cell::stuck, Cell::crowded, Cell::shifting});
  this->traverse(scene);
  reported(this->reporter);
  const auto node = scene.node;
  this->process(scene, "budget_divisor=1");
  EXPECT_THAT(reported(this->reporter), ElementsAre(acted(Operator::shift_split, node[3], "7", "7 (3 | 4)"),
                                                    acted(Operator::shift_split, node[7], "7", "7 (3 | 4)"),
                                                    acted(Operator::split, node[2], "7", "7 (3 | 4)"),
                                                    acted(Operator::split, node[6], "7", "7 (3 | 4)"),
                                                    acted(Operator::swap, node[1], "7 (7 | 0)", "7"),
                                                    acted(Operator::swap, node[5], "7 (7 | 0)", "7"),
                                                    acted(Operator::merge, node[0], "2 (1 | 1)", "2"),
                                                    acted(Operator::merge, node[4], "2 (1 | 1)", "2")));
  EXPECT_EQ(this->scheduler.pending(), 0U);
}

TYPED_TEST(Algorithm1, ALeafThatASwapMovedUpRests) {
  for (const auto& [config, retry] : {std::pair{"", 0U}, std::pair{"swap_rest=3,schedule_interval=5", 25U}}) {
    auto scene = scene_of<TypeParam::value>({Cell::calm, Cell::stuck});
    const NodeId heavy = heavier_child(scene.tree, scene.node[1]);
    ASSERT_TRUE(scene.tree[heavy].is_leaf());
    this->scheduler = {};
    this->traverse(scene);
    this->process(scene, config);
    EXPECT_EQ(this->scheduler.acted()[static_cast<std::size_t>(Operator::swap)], 1U);
    EXPECT_EQ(scene.tree[heavy].retry_step, retry) << config;
  }
}

TYPED_TEST(Algorithm1, Line13GivesOneSixteenthOfTheListAndLine18DefersTheRest) {
  for (const std::uint32_t crowded : {1U, 15U, 16U, 17U, 32U, 33U, 48U, 49U, 63U, 64U}) {
    auto scene = scene_of<TypeParam::value>(std::vector(crowded, Cell::shifting));
    kerf::Scheduler<TypeParam::value> fresh;
    fresh.traverse(scene.tree, this->with(""), 10, this->reporter);
    ASSERT_EQ(fresh.pending(), crowded);
    reported(this->reporter);
    fresh.process(scene.tree, this->with(""), 10, this->reporter);
    const std::uint32_t budget = (crowded + 15) / 16;
    const std::uint32_t left = crowded - budget;
    EXPECT_EQ(fresh.pending(), left);
    const auto lines = reported(this->reporter);
    ASSERT_EQ(lines.size(), budget + (left > 0 ? 1U : 0U));
    if (left > 0) {
      EXPECT_EQ(lines.back(), std::to_string(left) + " events deferred");
    }
  }
}

TYPED_TEST(Algorithm1, Line18DefersInOrderUntilNothingIsLeft) {
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::stuck, Cell::crowded, Cell::shifting});
  this->traverse(scene);
  reported(this->reporter);
  const auto node = scene.node;
  this->process(scene, "budget_divisor=2", 10);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(acted(Operator::shift_split, node[3], "7", "7 (3 | 4)"),
                          acted(Operator::split, node[2], "7", "7 (3 | 4)"), "2 events deferred"));
  this->process(scene, "budget_divisor=2", 11);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(acted(Operator::swap, node[1], "7 (7 | 0)", "7"), "1 event deferred"));
  this->process(scene, "budget_divisor=2", 12);
  EXPECT_THAT(reported(this->reporter), ElementsAre(acted(Operator::merge, node[0], "2 (1 | 1)", "2")));
  this->process(scene, "budget_divisor=2", 13);
  EXPECT_THAT(reported(this->reporter), IsEmpty());
}

}  // namespace
}  // namespace kerf::test
