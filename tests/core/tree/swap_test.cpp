#include "core/tree/swap.h"

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
class Swap : public testing::Test {
 protected:
  static constexpr int kSize = T::value;

  /// Unit slabs at 0, 2, 4, ... along axis 0.
  static kerf::Tree<kSize> row(int count) {
    std::vector<Box<kSize>> boxes;
    for (int k = 0; k < count; ++k)
      boxes.push_back(slab<kSize>(static_cast<Scalar>(2 * k), static_cast<Scalar>(2 * k + 1)));
    return tree_of<kSize>(boxes);
  }
};
TYPED_TEST_SUITE(Swap, Dimensions, DimensionNames);

TYPED_TEST(Swap, KeepsEveryObjectAtEveryNodeOfRandomTrees) {
  constexpr int kD = TypeParam::value;
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    auto original = random_tree<kD>(random, 40, round % 2 == 0 ? 0.5 : 5, 14, 9);
    for (const NodeId inner : inner_nodes(original)) {
      auto tree = original;
      const NodeId parent = tree[inner].parent;
      const auto objects = objects_below(tree, parent.is_none() ? inner : parent);
      const OperatorActed event = swap(tree, inner);
      sort_phase(tree);
      ASSERT_FALSE(tree.is_alive(event.node));
      ASSERT_TRUE(is_sound(tree));
      ASSERT_EQ(objects_below(tree, parent.is_none() ? tree.root() : parent), objects);
      ASSERT_TRUE(same_pairs(swept(tree), overlapping(tree)));
    }
  }
}

TYPED_TEST(Swap, ReplacesTheNodeByItsHeavierChild) {
  auto tree = this->row(10);
  plant(tree, tree.root(), 0, 3.5F);  // 2 | 8
  const NodeId inner = tree.root();
  const NodeId heavy = tree[inner].right;
  const NodeId light = tree[inner].left;
  plant(tree, heavy, 0, 11.5F);  // 4 | 4
  const NodeRef old_root = tree.ref(inner);
  const NodeRef old_light = tree.ref(light);
  const NodeRef kept = tree.ref(heavy);
  const OperatorActed event = swap(tree, inner);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
  EXPECT_EQ(tree.root(), heavy);
  EXPECT_TRUE(tree[heavy].parent.is_none());
  EXPECT_EQ(tree[heavy].depth, 0U);
  EXPECT_TRUE(tree.is_alive(kept));
  EXPECT_FALSE(tree.is_alive(old_root));
  EXPECT_FALSE(tree.is_alive(old_light));
  EXPECT_EQ(event.op, Operator::swap);
  EXPECT_EQ(event.node, old_root);
  EXPECT_EQ(event.before, (Quality{10, 2, 8}));
  EXPECT_EQ(event.after, (Quality{10, 6, 4})) << "the two went left of the partitioner that was kept";
  EXPECT_EQ(event.direction, 0U);
  EXPECT_EQ(event.old_offset, 3.5F);
}

TYPED_TEST(Swap, AtTheRootKeepingALeafMakesASingleLeaf) {
  auto tree = this->row(5);
  plant(tree, tree.root(), 3, 100);  // everything left
  const NodeId kept = tree[tree.root()].left;
  const OperatorActed event = swap(tree, tree.root());
  sort_phase(tree);
  EXPECT_EQ(tree.root(), kept);
  EXPECT_TRUE(tree[kept].is_leaf());
  EXPECT_EQ(tree[kept].direction, 0U) << "a root leaf's list is along axis 0";
  EXPECT_EQ(event.after, (Quality{5, 0, 0}));
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Swap, KeepingALeafTurnsItsListAlongTheNewParent) {
  auto tree = this->row(10);
  plant(tree, tree.root(), 2 % TestFixture::kSize, -100);
  const NodeId below = tree[tree.root()].right;
  plant(tree, below, 5, 1000);  // everything left
  const NodeId leaf = tree[below].left;
  ASSERT_EQ(tree[leaf].direction, 5U);
  swap(tree, below);
  EXPECT_EQ(tree[leaf].direction, tree[tree.root()].direction);
  EXPECT_EQ(tree[tree.root()].right, leaf);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Swap, DropsThePlanesBitAndShiftsTheDeeperOnes) {
  constexpr int kD = TypeParam::value;
  // Object 0 is on both sides of all three planes; object 1 of those that stay.
  std::vector<Box<kD>> boxes{slab<kD>(0, 20), slab<kD>(9, 11)};
  for (int k = 0; k < 20; ++k) boxes.push_back(slab<kD>(static_cast<Scalar>(k), static_cast<Scalar>(k)));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 0, 10);
  const NodeId outer = tree[tree.root()].right;  // 10 < x
  plant(tree, outer, 0, 18);
  const NodeId inner = tree[outer].left;
  plant(tree, inner, 0, 10.5F);
  swap(tree, outer);
  EXPECT_EQ(tree[tree.root()].right, inner);
  const NodeId leaf = tree[inner].right;
  EXPECT_EQ(tree[leaf].right_of, 0b11U);
  for (const Entry& entry : tree[leaf].entries) {
    EXPECT_EQ(DepthMask{entry.straddle}, entry.object.value < 2 ? 0b11U : 0U)
        << "object " << entry.object.value;
  }
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Swap, PlacesOnlyObjectsThatTheHeavierSideLacks) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(0, 9), slab<kD>(8, 9), slab<kD>(7, 9)});
  plant(tree, tree.root(), 0, 5);  // 2 | 3, object 1 on both
  swap(tree, tree.root());
  sort_phase(tree);
  EXPECT_EQ(tree.entries(), 4U) << "one entry an object";
  EXPECT_EQ(tree.objects(), 4U);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Swap, RepeatedEmptiesTheTreeToOneLeaf) {
  constexpr int kD = TypeParam::value;
  Random random(4);
  auto tree = random_tree<kD>(random, 60, 2, 30, 20);
  while (!tree[tree.root()].is_leaf()) {
    const auto inner = inner_nodes(tree);
    swap(tree, inner[random.below(static_cast<std::uint32_t>(inner.size()))]);
    sort_phase(tree);
    ASSERT_TRUE(is_sound(tree));
  }
  EXPECT_EQ(tree.entries(), 60U);
}

}  // namespace
}  // namespace kerf::test
