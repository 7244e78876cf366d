#include "core/tree/shift_split.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/hash.h"
#include "core/tree/merge.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class ShiftSplit : public testing::Test {
 protected:
  static constexpr int kSize = T::value;

  /// A tree with one partitioner along `direction`, most of the objects left of it.
  static kerf::Tree<kSize> divided(std::uint32_t direction, double half = 1) {
    Random random(5);
    std::vector<Box<kSize>> boxes;
    for (int k = 0; k < 100; ++k) boxes.push_back(random_box<kSize>(random, 50, half));
    auto tree = tree_of<kSize>(boxes);
    plant(tree, tree.root(), direction, 40);
    return tree;
  }
};
TYPED_TEST_SUITE(ShiftSplit, Dimensions, DimensionNames);

TYPED_TEST(ShiftSplit, KeepsEveryObjectInEveryDirection) {
  for (std::uint32_t direction = 0; direction < 10; ++direction) {
    auto tree = this->divided(direction);
    for (const NodeId leaf : {tree[tree.root()].left, tree[tree.root()].right}) {
      const auto objects = objects_below(tree, leaf);
      Refusal refusal{};
      const auto event = shift_split(tree, leaf, config_of("max_redundancy=0.5,min_balance=0.2"), refusal);
      if (!event) continue;
      EXPECT_TRUE(is_sound(tree)) << "both lists are born ordered";
      EXPECT_EQ(objects_below(tree, leaf), objects);
      EXPECT_TRUE(same_pairs(swept(tree), overlapping(tree)));
    }
  }
}

TYPED_TEST(ShiftSplit, DividesParallelToTheParent) {
  auto tree = this->divided(1);
  const NodeId leaf = tree[tree.root()].left;
  const NodeRef ref = tree.ref(leaf);
  const auto point = shifted_partitioner(tree, leaf, Config{});
  ASSERT_TRUE(point);
  const std::uint32_t population = tree[leaf].population;
  Refusal refusal{};
  const auto event = shift_split(tree, leaf, Config{}, refusal);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->op, Operator::shift_split);
  EXPECT_EQ(event->node, ref);
  EXPECT_EQ(event->before, (Quality{population, 0, 0}));
  EXPECT_EQ(event->after, point->quality);
  EXPECT_EQ(event->direction, 1U);
  EXPECT_EQ(event->old_offset, 40);
  EXPECT_EQ(event->new_offset, point->offset);
  EXPECT_EQ(tree[leaf].plane.normal, tree[tree.root()].plane.normal);
  EXPECT_EQ(tree[leaf].plane.offset, point->offset);
  EXPECT_TRUE(is_good(event->after, Config{}));
}

TYPED_TEST(ShiftSplit, TakesTheBestPointOfTheList) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> row;
  for (int k = 0; k < 12; ++k) row.push_back(slab<kD>(static_cast<Scalar>(k), static_cast<Scalar>(k) + 0.5F));
  auto tree = tree_of<kD>(row);
  plant(tree, tree.root(), 0, 7.75F);
  Refusal refusal{};
  const auto event = shift_split(tree, tree[tree.root()].left, Config{}, refusal);
  ASSERT_TRUE(event);
  EXPECT_EQ(event->new_offset, 3.75F);
  EXPECT_EQ(event->after, (Quality{8, 4, 4}));
}

TYPED_TEST(ShiftSplit, IsUndoneByMerge) {
  auto tree = this->divided(0);
  const NodeId leaf = tree[tree.root()].left;
  const std::uint64_t before = hash(tree);
  Refusal refusal{};
  ASSERT_TRUE(shift_split(tree, leaf, Config{}, refusal));
  EXPECT_NE(hash(tree), before);
  merge(tree, leaf);
  sort_phase(tree);
  EXPECT_EQ(hash(tree), before);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(ShiftSplit, RefusesTheRootWhichHasNoParent) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> row;
  for (int k = 0; k < 12; ++k)
    row.push_back(slab<kD>(static_cast<Scalar>(2 * k), static_cast<Scalar>(2 * k + 1)));
  auto tree = tree_of<kD>(row);
  const std::uint64_t before = hash(tree);
  EXPECT_FALSE(shifted_partitioner(tree, tree.root(), Config{}));
  Refusal refusal{};
  EXPECT_FALSE(shift_split(tree, tree.root(), Config{}, refusal));
  EXPECT_EQ(refusal, Refusal::no_partitioner);
  EXPECT_EQ(hash(tree), before);
}

TYPED_TEST(ShiftSplit, RefusesWhenNoShiftIsGood) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> crossed{slab<kD>(20, 21)};  // along axis 0 all but one coincide
  for (int k = 0; k < 20; ++k)
    crossed.push_back(slab<kD>(static_cast<Scalar>(2 * k), static_cast<Scalar>(2 * k + 1), 1));
  auto tree = tree_of<kD>(crossed);
  plant(tree, tree.root(), 0, 10);
  const NodeId leaf = tree[tree.root()].left;
  const std::uint64_t before = hash(tree);
  Refusal refusal{};
  EXPECT_FALSE(shift_split(tree, leaf, Config{}, refusal));
  EXPECT_EQ(refusal, Refusal::no_partitioner);
  EXPECT_EQ(hash(tree), before);
}

TYPED_TEST(ShiftSplit, ObeysTheCaps) {
  auto tree = this->divided(0, 3);
  const NodeId leaf = tree[tree.root()].left;
  const std::uint64_t before = hash(tree);
  Refusal refusal{};
  EXPECT_FALSE(shift_split(tree, leaf, config_of("max_height=1,max_redundancy=0.5"), refusal));
  EXPECT_EQ(refusal, Refusal::height);
  EXPECT_FALSE(shift_split(tree, leaf, config_of("max_entries=1,max_redundancy=0.5"), refusal));
  EXPECT_EQ(refusal, Refusal::entries);
  EXPECT_EQ(hash(tree), before);
  EXPECT_TRUE(shift_split(tree, leaf, config_of("max_redundancy=0.5"), refusal));
}

}  // namespace
}  // namespace kerf::test
