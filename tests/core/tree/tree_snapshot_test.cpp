#include "core/tree/tree_snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/bsp/bsp.h"
#include "core/tree/criteria.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"

namespace kerf {
namespace {

template <class T>
class TreeSnapshotTest : public testing::Test {};
TYPED_TEST_SUITE(TreeSnapshotTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(TreeSnapshotTest, HasWhatTheTreeHad) {
  constexpr int kD = TypeParam::value;
  Bsp<kD, NoTrace> broad_phase(test::config_of("min_threshold=8,max_threshold=8,schedule_interval=1"));
  test::MovingBoxes<kD> crowd(broad_phase, 12, 0.6, 1);
  crowd.add(200);
  for (int step = 0; step < 30; ++step) broad_phase.step();
  const Tree<kD>& tree = broad_phase.tree();
  TreeSnapshotOf<kD> snapshot;
  snapshot.assign(&tree);
  ASSERT_EQ(snapshot.root(), tree.root());
  std::uint32_t leaves = 0;
  std::uint32_t largest = 0;
  std::size_t living = 0;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    const Node<kD>& node = tree[id];
    ++living;
    EXPECT_TRUE(snapshot.is_alive(tree.ref(id)));
    EXPECT_FALSE(snapshot.is_alive(NodeRef{id, node.generation + 1}));
    EXPECT_EQ(snapshot[id].parent, node.parent);
    EXPECT_EQ(snapshot[id].right, node.right);
    EXPECT_EQ(snapshot[id].depth, node.depth);
    EXPECT_EQ(snapshot[id].population, node.population);
    leaves += node.is_leaf() ? 1 : 0;
    if (node.is_leaf()) largest = std::max(largest, node.population);
    EXPECT_EQ(snapshot.quality(id), node.is_leaf() ? Quality{} : quality(tree, id));
    if (node.is_leaf()) return;
    EXPECT_EQ(snapshot.plane(id).offset, node.plane.offset);
  });
  EXPECT_GT(leaves, 8U);
  EXPECT_EQ(snapshot.leaves(), leaves);
  EXPECT_EQ(snapshot.largest_leaf(), largest);
  EXPECT_EQ(std::ranges::count(snapshot.nodes(), true, &TreeSnapshot::Node::alive), living);
  snapshot.assign(nullptr);
  EXPECT_TRUE(snapshot.empty());
  EXPECT_FALSE(snapshot.is_alive(tree.root()));
}

}  // namespace
}  // namespace kerf
