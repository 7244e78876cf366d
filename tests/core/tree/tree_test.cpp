#include "core/tree/tree.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/merge.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

template <class T>
class Tree : public testing::Test {};
TYPED_TEST_SUITE(Tree, Dimensions, DimensionNames);

TYPED_TEST(Tree, BeginsAsOneEmptyLeaf) {
  constexpr int kD = TypeParam::value;
  const auto tree = tree_of<kD>(std::vector<Box<kD>>{});
  EXPECT_TRUE(tree[tree.root()].is_leaf());
  EXPECT_EQ(tree.objects(), 0U);
  EXPECT_EQ(tree.entries(), 0U);
  EXPECT_EQ(tree.slots(), 1U);
}

TYPED_TEST(Tree, ChildrenKnowWhereTheyAre) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1)});
  plant(tree, tree.root(), 1, 5);
  const NodeId right = tree[tree.root()].right;
  plant(tree, right, 0, 5);
  const NodeId lowest = tree[right].right;
  EXPECT_EQ(tree[lowest].depth, 2U);
  EXPECT_EQ(tree[lowest].right_of, 0b11U);
  EXPECT_EQ(tree[tree[right].left].right_of, 0b01U);
  EXPECT_EQ(tree[lowest].parent, right);
  EXPECT_EQ(tree[lowest].direction, 0U) << "lists go along the parent's normal";
  EXPECT_EQ(tree[tree[tree.root()].left].direction, 1U);
}

TYPED_TEST(Tree, NumberUsedAgainIsAnotherLife) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(8, 9)});
  plant(tree, tree.root(), 0, 5);
  const NodeRef first = tree.ref(tree[tree.root()].left);
  EXPECT_TRUE(tree.is_alive(first));
  merge(tree, tree.root());
  EXPECT_FALSE(tree.is_alive(first));
  plant(tree, tree.root(), 0, 5);
  EXPECT_EQ(tree.slots(), 3U) << "dead numbers are used again";
  EXPECT_FALSE(tree.is_alive(first));
  EXPECT_FALSE(tree.is_alive({NodeId{77}, 0}));
}

TYPED_TEST(Tree, CountsEntriesThroughEveryChange) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1), slab<kD>(4, 6), slab<kD>(8, 9)});
  EXPECT_EQ(tree.entries(), 3U);
  plant(tree, tree.root(), 0, 5);
  EXPECT_EQ(tree.entries(), 4U);
  const NodeId left = tree[tree.root()].left;
  tree.set_mark({1}, true);
  TaskPool alone;
  const EntryCount one{left, 1};
  tree.drop_marked_entries({&one, 1}, alone);
  tree.set_mark({1}, false);
  EXPECT_EQ(tree.entries(), 3U);
  EXPECT_EQ(objects_below(tree, left), (std::vector<ObjectId>{{0}}));
  tree.set_entries(left, {});
  EXPECT_EQ(tree.entries(), 2U);
  tree.clear_entries(tree[tree.root()].right);
  EXPECT_EQ(tree.entries(), 0U);
}

TYPED_TEST(Tree, DropsMarkedEntriesWhereverTheyLie) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector(6, slab<kD>(0, 1)));
  for (const std::uint32_t object : {0U, 3U, 5U}) tree.set_mark({object}, true);
  const EntryCount three{tree.root(), 3};
  TaskPool alone;
  tree.drop_marked_entries({&three, 1}, alone);
  EXPECT_EQ(objects_below(tree, tree.root()), (std::vector<ObjectId>{{1}, {2}, {4}})) << "in their order";
  EXPECT_EQ(tree.entries(), 3U);
  for (const std::uint32_t object : {0U, 3U, 5U}) tree.set_mark({object}, false);

  tree.set_mark({2}, true);
  const EntryCount too_many{tree.root(), 7};
  tree.drop_marked_entries({&too_many, 1}, alone);
  tree.set_mark({2}, false);
  EXPECT_EQ(objects_below(tree, tree.root()), (std::vector<ObjectId>{{1}, {4}}));
  EXPECT_EQ(tree.entries(), 2U) << "counted by what went, whatever was said";
}

TYPED_TEST(Tree, WalkVisitsEachNodeOnceParentsAndLeftFirst) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 1)});
  plant(tree, tree.root(), 0, 5);
  const NodeId left = tree[tree.root()].left;
  plant(tree, left, 0, 3);
  std::vector<NodeId> visited;
  for_each_node(tree, tree.root(), [&](NodeId id) { visited.push_back(id); });
  EXPECT_EQ(visited, (std::vector<NodeId>{tree.root(), left, tree[left].left, tree[left].right,
                                          tree[tree.root()].right}));
  visited.clear();
  for_each_node(tree, left, [&](NodeId id) { visited.push_back(id); });
  EXPECT_EQ(visited.size(), 3U);
}

}  // namespace
}  // namespace kerf::test
