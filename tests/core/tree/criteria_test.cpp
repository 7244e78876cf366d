#include "core/tree/criteria.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

TEST(Thresholds, FollowTheNumberOfObjectsFrom16To128) {
  const Config config;
  EXPECT_EQ(split_threshold(0, config), 16U);
  EXPECT_EQ(split_threshold(256, config), 16U);
  EXPECT_EQ(split_threshold(2500, config), 50U);
  EXPECT_EQ(split_threshold(16'384, config), 128U);
  EXPECT_EQ(split_threshold(1'000'000, config), 128U);
  EXPECT_EQ(merge_threshold(2500, config), 25U);
  EXPECT_EQ(merge_threshold(2500, config_of("merge_fraction=0")), 0U);
}

template <class T>
class Criteria : public testing::Test {};
TYPED_TEST_SUITE(Criteria, Dimensions, DimensionNames);

TYPED_TEST(Criteria, SplitIsWantedAboveTheThresholdOnly) {
  constexpr int kD = TypeParam::value;
  const auto tree = tree_of<kD>(std::vector(20, slab<kD>(0, 1)));
  EXPECT_TRUE(wants_split(tree, tree.root(), config_of("min_threshold=19,max_threshold=19")));
  EXPECT_FALSE(wants_split(tree, tree.root(), config_of("min_threshold=20,max_threshold=20")));
}

TYPED_TEST(Criteria, InnerNodesAreMeasuredByThePopulationsOfTheirChildren) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> boxes(6, slab<kD>(0, 1));
  for (int k = 0; k < 3; ++k) boxes.push_back(slab<kD>(8, 9));
  boxes.push_back(slab<kD>(0, 9));
  auto tree = tree_of<kD>(boxes);
  plant(tree, tree.root(), 0, 5);
  EXPECT_EQ(quality(tree, tree.root()), (Quality{10, 7, 4}));
  EXPECT_FALSE(wants_repair(tree, tree.root(), Config{})) << "4 : 7";
  EXPECT_TRUE(wants_repair(tree, tree.root(), config_of("min_balance=0.6")));
  EXPECT_FALSE(wants_repair(tree, tree.root(), config_of("repair_redundancy=0.1"))) << "exactly a tenth";
  EXPECT_TRUE(wants_repair(tree, tree.root(), config_of("repair_redundancy=0.09")));
  EXPECT_FALSE(wants_split(tree, tree.root(), config_of("min_threshold=1,max_threshold=1")));
  EXPECT_TRUE(wants_merge(tree, tree.root(), config_of("min_threshold=22,max_threshold=22")));
  EXPECT_FALSE(wants_merge(tree, tree.root(), config_of("min_threshold=20,max_threshold=20")));
}

/// A node of ten, one on both sides, above a leaf of three.
template <int D>
Tree<D> tree_with_a_small_leaf() {
  std::vector<Box<D>> boxes(7, slab<D>(0, 1));
  for (int k = 0; k < 2; ++k) boxes.push_back(slab<D>(8, 9));
  boxes.push_back(slab<D>(0, 9));
  auto tree = tree_of<D>(boxes);
  plant(tree, tree.root(), 0, 5);
  return tree;
}

TYPED_TEST(Criteria, StraddlersAreAShareOfTheNodeOrOfTheScene) {
  constexpr int kD = TypeParam::value;
  const auto tree = tree_with_a_small_leaf<kD>();
  const NodeId small = tree[tree.root()].right;
  ASSERT_EQ(tree[small].population, 3U);
  const Config of_the_node = config_of("max_redundancy=0.2");
  const Config of_the_scene = config_of("max_redundancy=0.2,scene_redundancy=1");
  EXPECT_EQ(allowed_redundancy(tree, small, of_the_node), 0.2F);
  EXPECT_EQ(allowed_redundancy(tree, tree.root(), of_the_scene), 0.2F);
  EXPECT_FLOAT_EQ(allowed_redundancy(tree, small, of_the_scene), 2.0F / 3)
      << "two of ten, in a leaf of three";
  EXPECT_EQ(allowed_redundancy(tree, small, config_of("max_redundancy=0.5,scene_redundancy=1")), 1.0F);
  EXPECT_EQ(config_at(tree, small, config_at(tree, small, of_the_scene)),
            config_at(tree, small, of_the_scene));
}

TYPED_TEST(Criteria, ASwapIsWantedIfItInsertsFewObjects) {
  constexpr int kD = TypeParam::value;
  const auto tree = tree_with_a_small_leaf<kD>();
  ASSERT_EQ(quality(tree, tree.root()), (Quality{10, 8, 3})) << "two are not in the heavier subtree";
  EXPECT_FALSE(wants_swap(tree, tree.root(), Config{}));
  EXPECT_TRUE(wants_swap(tree, tree.root(), config_of("swap_share=0.25")));
  EXPECT_FALSE(wants_swap(tree, tree.root(), config_of("swap_share=0.24")));
  EXPECT_FALSE(wants_swap(tree, tree.root(), config_of("swap_share=1,swap=0")));
  EXPECT_FALSE(wants_swap(tree, tree.root(), config_of("swap_share=1,min_balance=0.3"))) << "it is balanced";
}

TYPED_TEST(Criteria, ANodeWithAllObjectsOnBothSidesIsSwapped) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector(7, slab<kD>(0, 10)));
  plant(tree, tree.root(), 0, 5);
  EXPECT_TRUE(wants_swap(tree, tree.root(), Config{}));
}

TYPED_TEST(Criteria, LeavesAreNeitherRepairedNorMerged) {
  constexpr int kD = TypeParam::value;
  const auto tree = tree_of<kD>(std::vector<Box<kD>>{});
  EXPECT_FALSE(wants_repair(tree, tree.root(), Config{}));
  EXPECT_FALSE(wants_merge(tree, tree.root(), Config{}));
}

}  // namespace
}  // namespace kerf::test
