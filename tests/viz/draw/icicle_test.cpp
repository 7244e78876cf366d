#include "viz/draw/icicle.h"

#include <gtest/gtest.h>

#include "tests/viz/small_scene.h"

namespace kerf {
namespace {

/// A root with a leaf of three at the left, and an inner node of one at the right, of which one leaf is
/// empty.
TreeSnapshotOf<2> small_tree() {
  const auto node = [](NodeId parent, NodeId left, NodeId right, std::uint32_t depth,
                       std::uint32_t population) {
    return TreeSnapshot::Node{parent, left, right, 0, depth, population, true};
  };
  const NodeId none;
  TreeSnapshotOf<2> tree;
  tree.assign(NodeId{0},
              {node(none, NodeId{1}, NodeId{2}, 0, 4), node(NodeId{0}, none, none, 1, 3),
               node(NodeId{0}, NodeId{3}, NodeId{4}, 1, 1), node(NodeId{2}, none, none, 2, 0),
               node(NodeId{2}, none, none, 2, 1)},
              std::vector<Plane<2>>(5));
  return tree;
}

TEST(Icicle, ChildrenShareTheirParentsWidthAsTheyShareItsPopulation) {
  const std::vector<IcicleBar> bars = icicle_bars(small_tree());
  ASSERT_EQ(bars.size(), 5U);
  const std::vector<std::uint32_t> order{0, 1, 2, 3, 4};
  const std::vector<double> right{1, 0.75, 1, 0.875, 1};
  for (std::size_t k = 0; k < bars.size(); ++k) {
    EXPECT_EQ(bars[k].node.value, order[k]);
    EXPECT_DOUBLE_EQ(bars[k].right, right[k]) << "the empty leaf has the width of one object";
  }
  EXPECT_DOUBLE_EQ(bars[1].left, 0);
  EXPECT_DOUBLE_EQ(bars[2].left, 0.75);
  EXPECT_DOUBLE_EQ(bars[4].left, 0.875);
  EXPECT_EQ(bars[4].depth, 2U);
}

TEST(Icicle, OfNoTreeIsEmpty) { EXPECT_TRUE(icicle_bars(TreeSnapshotOf<3>()).empty()); }

/// Leaves side by side fill the whole width, each node once.
TEST(Icicle, LeavesOfARealTreeFillTheWidth) {
  const test::SmallScene<3> scene;
  TreeSnapshotOf<3> tree;
  tree.assign(&scene.tree());
  double reached = 0;
  std::size_t nodes = 0;
  for (const IcicleBar& bar : icicle_bars(tree)) {
    ++nodes;
    EXPECT_EQ(bar.depth, tree[bar.node].depth);
    if (!tree[bar.node].is_leaf()) continue;
    EXPECT_NEAR(bar.left, reached, 1e-12);
    EXPECT_GT(bar.right, bar.left);
    reached = bar.right;
  }
  EXPECT_NEAR(reached, 1, 1e-12);
  EXPECT_EQ(nodes, 2 * tree.leaves() - 1);
}

}  // namespace
}  // namespace kerf
