#include "core/tree/merge.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/criteria.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class Merge : public testing::Test {};
TYPED_TEST_SUITE(Merge, Dimensions, DimensionNames);

TYPED_TEST(Merge, KeepsEveryObjectOnceAtEveryNodeOfRandomTrees) {
  constexpr int kD = TypeParam::value;
  Random random(1);
  for (int round = 0; round < 20; ++round) {
    auto original = random_tree<kD>(random, 40, 4, 12, 8);
    for (const NodeId inner : inner_nodes(original)) {
      auto tree = original;
      const auto objects = objects_below(tree, inner);
      const NodeRef ref = tree.ref(inner);
      const OperatorActed event = merge(tree, inner);
      sort_phase(tree);
      ASSERT_TRUE(is_sound(tree));
      ASSERT_TRUE(tree[inner].is_leaf());
      ASSERT_TRUE(tree.is_alive(ref)) << "the node keeps its number and life";
      ASSERT_EQ(objects_below(tree, inner), objects);
      ASSERT_EQ(tree[inner].entries.size(), objects.size()) << "one entry an object (HARD_CASES O3)";
      ASSERT_EQ(event.after, (Quality{static_cast<std::uint32_t>(objects.size()), 0, 0}));
      ASSERT_TRUE(same_pairs(swept(tree), overlapping(tree)));
    }
  }
}

TYPED_TEST(Merge, TakesAnObjectFromBothSidesOnce) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(0, 9), slab<kD>(8, 9)});
  plant(tree, tree.root(), 0, 5);
  plant(tree, tree[tree.root()].left, 0, 3);
  plant(tree, tree[tree.root()].right, 0, 7);
  ASSERT_EQ(tree.entries(), 6U) << "the long one lies in all four leaves";
  merge(tree, tree.root());
  sort_phase(tree);
  EXPECT_EQ(tree.entries(), 3U);
  EXPECT_EQ(tree[tree.root()].population, 3U);
  for (const Entry& entry : tree[tree.root()].entries) EXPECT_EQ(DepthMask{entry.straddle}, 0U);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Merge, ReportsWhatItDid) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(4, 6), slab<kD>(8, 9)});
  plant(tree, tree.root(), 0, 5);
  const Quality before = quality(tree, tree.root());
  const OperatorActed event = merge(tree, tree.root());
  EXPECT_EQ(event.op, Operator::merge);
  EXPECT_EQ(event.node, tree.ref(tree.root()));
  EXPECT_EQ(before, (Quality{3, 2, 2}));
  EXPECT_EQ(event.before, before);
  EXPECT_EQ(event.after, (Quality{3, 0, 0}));
  EXPECT_EQ(event.direction, 0U);
  EXPECT_EQ(event.old_offset, 5);
}

TYPED_TEST(Merge, KillsEveryNodeBelow) {
  constexpr int kD = TypeParam::value;
  Random random(2);
  auto tree = random_tree<kD>(random, 40, 1, 10, 8);
  std::vector<NodeRef> below;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    if (id != tree.root()) below.push_back(tree.ref(id));
  });
  ASSERT_GT(below.size(), 6U);
  merge(tree, tree.root());
  for (const NodeRef ref : below) EXPECT_FALSE(tree.is_alive(ref));
  plant(tree, tree.root(), 0, 10);
  for (const NodeRef ref : below) EXPECT_FALSE(tree.is_alive(ref)) << "a number used again is another life";
}

TYPED_TEST(Merge, ListGoesAlongTheParentsNormal) {
  constexpr int kD = TypeParam::value;
  Random random(3);
  std::vector<Box<kD>> boxes;
  for (int k = 0; k < 40; ++k) boxes.push_back(random_box<kD>(random, 20, 1));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 7, 10);
  const NodeId child = tree[tree.root()].left;
  plant(tree, child, 3, 5);
  merge(tree, child);
  EXPECT_EQ(tree[child].direction, 7U);
  merge(tree, tree.root());
  EXPECT_EQ(tree[tree.root()].direction, 0U) << "a root leaf has no parent";
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Merge, OfTwoEmptyLeavesIsAnEmptyLeaf) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector<Box<kD>>{});
  plant(tree, tree.root(), 0, 5);
  merge(tree, tree.root());
  EXPECT_TRUE(tree[tree.root()].is_leaf());
  EXPECT_TRUE(is_sound(tree));
}

}  // namespace
}  // namespace kerf::test
