#include "core/tree/shed.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/hash.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class Shed : public testing::Test {
 protected:
  static constexpr int kSize = T::value;

  /// `wide` boxes on both sides of all three planes and `narrow` ones in one leaf each.
  static kerf::Tree<kSize> straddled(int wide, int narrow) {
    std::vector<Box<kSize>> boxes(static_cast<std::size_t>(wide), slab<kSize>(0, 8));
    for (int k = 0; k < narrow; ++k) {
      const auto x = static_cast<Scalar>(2 * (k % 4));
      boxes.push_back(slab<kSize>(x + 0.25F, x + 0.75F));
    }
    auto tree = tree_of<kSize>(boxes);
    plant(tree, tree.root(), 0, 4);
    plant(tree, tree[tree.root()].left, 0, 2);
    plant(tree, tree[tree.root()].right, 0, 6);
    return tree;
  }
};
TYPED_TEST_SUITE(Shed, Dimensions, DimensionNames);

TYPED_TEST(Shed, DoesNothingUpToTwiceTheCap) {
  auto tree = this->straddled(10, 0);
  ASSERT_EQ(tree.entries(), 40U);
  const std::uint64_t before = hash(tree);
  EXPECT_TRUE(shed_entries(tree, config_of("max_entries=2")).empty()) << "exactly twice";
  EXPECT_EQ(hash(tree), before);
}

TYPED_TEST(Shed, MergesStraddledNodesBeyondTwiceTheCap) {
  auto tree = this->straddled(10, 0);
  const auto objects = objects_below(tree, tree.root());
  const NodeRef root = tree.ref(tree.root());
  const auto events = shed_entries(tree, config_of("max_entries=1.9"));
  ASSERT_EQ(events.size(), 1U) << "the topmost node takes those below along";
  EXPECT_EQ(events[0].op, Operator::merge);
  EXPECT_EQ(events[0].node, root);
  sort_phase(tree);
  EXPECT_EQ(tree.entries(), 10U);
  EXPECT_EQ(objects_below(tree, tree.root()), objects);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Shed, HalvesTheShareUntilTheCapHolds) {
  auto tree = this->straddled(8, 12);  // 8 of 20 straddle the root, 8 of 14 the planes below
  ASSERT_EQ(tree.entries(), 44U);
  const Config config = config_of("max_entries=1,repair_redundancy=1");
  EXPECT_FALSE(shed_entries(tree, config).empty());
  EXPECT_LE(tree.entries(), 20U);
  sort_phase(tree);
  EXPECT_TRUE(is_sound(tree));
  EXPECT_TRUE(same_pairs(swept(tree), overlapping(tree)));
}

}  // namespace
}  // namespace kerf::test
