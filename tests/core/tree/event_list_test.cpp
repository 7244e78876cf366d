// What Algorithm 1 leaves open: a full list, events that come too late, refusals, and no budget at all.

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "core/tree/hash.h"
#include "core/tree/merge.h"
#include "core/tree/scheduler.h"
#include "tests/core/tree/scheduler_scenes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

Config with(const std::string& config) {
  Config result = config_of(kSceneConfig);
  kerf::apply(result, config);
  return result;
}

template <class T>
class EventList : public testing::Test {
 protected:
  kerf::Scheduler<T::value> scheduler;
  Reporter<EventLog> reporter;
};
TYPED_TEST_SUITE(EventList, Dimensions, DimensionNames);

TYPED_TEST(EventList, HoldsSixtyFourAndRefusesMore) {
  auto scene = scene_of<TypeParam::value>(std::vector(70, Cell::shifting));
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  EXPECT_EQ(this->scheduler.pending(), 64U);
  EXPECT_EQ(this->scheduler.refused(), 6U);
  const auto lines = reported(this->reporter);
  ASSERT_EQ(lines.size(), 70U);
  EXPECT_EQ(lines[63], scheduled(Operator::shift_split, scene.node[63]));
  EXPECT_EQ(lines[64], refused(Operator::split, scene.node[64], Refusal::list_full))
      << "no point is looked for in vain, so that the kind of split is not known";
}

TYPED_TEST(EventList, RefusesSwapsAndMergesWhenItIsFull) {
  auto scene = scene_of<TypeParam::value>({Cell::stuck, Cell::thin, Cell::stuck, Cell::thin});
  this->scheduler.traverse(scene.tree, with("event_capacity=2"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(scheduled(Operator::swap, scene.node[0]), scheduled(Operator::merge, scene.node[1]),
                          refused(Operator::swap, scene.node[2], Refusal::list_full),
                          refused(Operator::merge, scene.node[3], Refusal::list_full)));
}

TYPED_TEST(EventList, CountsAllKindsTogether) {
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::stuck, Cell::crowded, Cell::shifting});
  this->scheduler.traverse(scene.tree, with("event_capacity=2"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(scheduled(Operator::merge, scene.node[0]), scheduled(Operator::swap, scene.node[1]),
                          refused(Operator::split, scene.node[2], Refusal::list_full),
                          refused(Operator::split, scene.node[3], Refusal::list_full)));
}

TYPED_TEST(EventList, DropsEventsOfDeadNodes) {
  auto scene = scene_of<TypeParam::value>({Cell::crowded, Cell::calm, Cell::shifting, Cell::calm});
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  ASSERT_EQ(this->scheduler.pending(), 2U);
  merge(scene.tree, scene.tree.root());
  sort_phase(scene.tree);
  const std::uint64_t before = hash(scene.tree);
  reported(this->reporter);
  this->scheduler.process(scene.tree, with("budget_divisor=16"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(refused(Operator::shift_split, scene.node[2], Refusal::dead_node),
                          refused(Operator::split, scene.node[0], Refusal::dead_node)))
      << "a dropped event costs no budget";
  EXPECT_EQ(hash(scene.tree), before);
  EXPECT_EQ(this->scheduler.refused(), 2U);
}

TYPED_TEST(EventList, DropsEventsOfNodesThatLiveAgain) {
  auto scene = scene_of<TypeParam::value>({Cell::crowded, Cell::lump});
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  ASSERT_EQ(this->scheduler.listed(Operator::split).size(), 2U);
  merge(scene.tree, scene.tree.root());
  plant(scene.tree, scene.tree.root(), 0, 20);
  const auto& root = scene.tree[scene.tree.root()];
  ASSERT_TRUE(root.left == scene.node[0] || root.left == scene.node[1]) << "the number is used again";
  ASSERT_GT(scene.tree[root.left].population, 6U) << "and a split would be wanted";
  reported(this->reporter);
  this->scheduler.process(scene.tree, with("budget_divisor=1"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(refused(Operator::split, scene.node[0], Refusal::dead_node),
                          refused(Operator::split, scene.node[1], Refusal::dead_node)));
}

TYPED_TEST(EventList, DropsEventsThatAreNoLongerNeeded) {
  auto scene = scene_of<TypeParam::value>({Cell::thin, Cell::stuck, Cell::crowded, Cell::shifting});
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  const std::uint64_t before = hash(scene.tree);
  reported(this->reporter);
  this->scheduler.process(scene.tree, with("min_threshold=7,max_threshold=7,merge_fraction=0,min_balance=0"),
                          10, this->reporter);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(refused(Operator::shift_split, scene.node[3], Refusal::not_needed),
                          refused(Operator::split, scene.node[2], Refusal::not_needed),
                          refused(Operator::swap, scene.node[1], Refusal::not_needed),
                          refused(Operator::merge, scene.node[0], Refusal::not_needed)));
  EXPECT_EQ(hash(scene.tree), before);
}

TYPED_TEST(EventList, SplitsWhereAShiftIsGoodNoLonger) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> boxes{slab<kD>(0, 1)};  // one apart along axis 0, six side by side along axis 1
  for (int k = 0; k < 6; ++k) {
    boxes.push_back(slab<kD>(static_cast<Scalar>(2 * k), static_cast<Scalar>(2 * k + 1), 1));
    boxes.back().min[0] = 5;
    boxes.back().max[0] = 6;
  }
  for (int k = 0; k < 4; ++k) boxes.push_back(slab<kD>(10, 11));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 0, 8);
  const NodeId leaf = tree[tree.root()].left;
  this->scheduler.traverse(tree, with("min_balance=0.1"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter), ElementsAre(scheduled(Operator::shift_split, leaf)));
  this->scheduler.process(tree, with("min_balance=0.5"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter), ElementsAre(acted(Operator::split, leaf, "7", "7 (3 | 4)")));
  EXPECT_EQ(tree[leaf].direction, 1U);
}

TYPED_TEST(EventList, StandsStillWithoutABudget) {
  auto scene = scene_of<TypeParam::value>({Cell::shiftable, Cell::crowded});
  this->scheduler.traverse(scene.tree, with("budget_divisor=0"), 10, this->reporter);
  this->scheduler.process(scene.tree, with("budget_divisor=0"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter), IsEmpty()) << "HARD_CASES O5";
  this->scheduler.traverse(scene.tree, with(""), 20, this->reporter);
  reported(this->reporter);
  this->scheduler.process(scene.tree, with("budget_divisor=0"), 20, this->reporter);
  EXPECT_THAT(reported(this->reporter), ElementsAre("1 event deferred"));
}

TYPED_TEST(EventList, RefusedSplitIsTriedAgainAfterLongerAndLongerPauses) {
  auto scene = scene_of<TypeParam::value>({Cell::lump, Cell::calm, Cell::calm});
  std::vector<std::uint32_t> tried;
  for (std::uint32_t step = 1; step <= 700; ++step) {
    this->scheduler.traverse(scene.tree, with(""), step, this->reporter);
    this->scheduler.process(scene.tree, with(""), step, this->reporter);
    const auto lines = reported(this->reporter);
    if (lines.empty()) continue;
    tried.push_back(step);
    EXPECT_THAT(lines, ElementsAre(scheduled(Operator::split, scene.node[0]),
                                   refused(Operator::split, scene.node[0], Refusal::no_partitioner)));
  }
  EXPECT_THAT(tried, ElementsAre(10, 20, 40, 80, 160, 320, 480, 640)) << "1, 2, 4, 8, 16, 16, ... intervals";
}

TYPED_TEST(EventList, RefusedSplitsCostBudgetAndOthersGoOn) {
  auto scene = scene_of<TypeParam::value>({Cell::lump, Cell::crowded});
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  reported(this->reporter);
  this->scheduler.process(scene.tree, with(""), 10, this->reporter);
  EXPECT_THAT(
      reported(this->reporter),
      ElementsAre(refused(Operator::split, scene.node[0], Refusal::no_partitioner), "1 event deferred"));
  this->scheduler.process(scene.tree, with(""), 11, this->reporter);
  EXPECT_THAT(reported(this->reporter), Contains(acted(Operator::split, scene.node[1], "7", "7 (3 | 4)")));
}

TYPED_TEST(EventList, CapsAreReportedByTheirNames) {
  auto scene = scene_of<TypeParam::value>({Cell::shifting, Cell::crowded});
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  reported(this->reporter);
  this->scheduler.process(scene.tree, with("max_height=1,budget_divisor=1"), 10, this->reporter);
  EXPECT_THAT(reported(this->reporter),
              ElementsAre(refused(Operator::shift_split, scene.node[0], Refusal::height),
                          refused(Operator::split, scene.node[1], Refusal::height)));
}

TYPED_TEST(EventList, CountsWhatActed) {
  auto scene = scene_of<TypeParam::value>(
      {Cell::crowded, Cell::stuck, Cell::thin, Cell::shifting, Cell::shiftable, Cell::shifting});
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  this->scheduler.process(scene.tree, with("budget_divisor=1"), 10, this->reporter);
  const auto& count = this->scheduler.acted();
  EXPECT_EQ(count[static_cast<std::size_t>(Operator::balance)], 1U);
  EXPECT_EQ(count[static_cast<std::size_t>(Operator::shift_split)], 2U);
  EXPECT_EQ(count[static_cast<std::size_t>(Operator::split)], 1U);
  EXPECT_EQ(count[static_cast<std::size_t>(Operator::swap)], 1U);
  EXPECT_EQ(count[static_cast<std::size_t>(Operator::merge)], 1U);
  sort_phase(scene.tree);
  EXPECT_TRUE(is_sound(scene.tree));
}

TYPED_TEST(EventList, IsPartOfTheStateHash) {
  auto scene = scene_of<TypeParam::value>({Cell::crowded, Cell::crowded});
  const std::uint64_t tree = hash(scene.tree);
  const kerf::Scheduler<TypeParam::value> empty;
  this->scheduler.traverse(scene.tree, with(""), 10, this->reporter);
  kerf::Scheduler<TypeParam::value> one;
  one.traverse(scene.tree, with("event_capacity=1"), 10, this->reporter);
  EXPECT_NE(this->scheduler.mix_into(tree), empty.mix_into(tree));
  EXPECT_NE(this->scheduler.mix_into(tree), one.mix_into(tree));
  EXPECT_NE(one.mix_into(tree), empty.mix_into(tree));
  kerf::Scheduler<TypeParam::value> late = this->scheduler;
  late.process(scene.tree, with(""), 10, this->reporter);
  ASSERT_EQ(late.pending(), one.pending());
  EXPECT_NE(late.mix_into(tree), one.mix_into(tree)) << "as many events, but of another node";
  const kerf::Scheduler<TypeParam::value> copy = this->scheduler;
  EXPECT_EQ(this->scheduler.mix_into(tree), copy.mix_into(tree));
}

}  // namespace
}  // namespace kerf::test
