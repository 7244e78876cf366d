#include "core/bsp/stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/tree/hash.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/sound.h"

namespace kerf::test {
namespace {

template <class T>
class Stream : public testing::Test {
 protected:
  /// A tree of a few levels over a crowd.
  static Tree<T::value> grown(std::uint32_t count, const std::string& free_directions) {
    Bsp<T::value> tree(
        config_of("max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=8,max_threshold=8,"
                  "free_directions=" +
                  free_directions));
    MovingBoxes<T::value> crowd(tree, 30, 1.5, 5);
    crowd.add(count, 4);
    for (int step = 0; step < 40; ++step) {
      crowd.walk(0.3);
      tree.step();
    }
    return tree.tree();
  }
  /// Moves every second box by up to `distance` along each axis.
  static void walk(Tree<T::value>& tree, double distance) {
    Random random(3);
    for (std::uint32_t id = 0; id < tree.table.bound(); id += 2) {
      const Vector<T::value> by = random_point<T::value>(random, -distance, distance);
      const Box<T::value> box = tree.table.box({id});
      tree.table.widen({id}, {box.min + by, box.max + by});
    }
  }
  /// Returns how many left.
  static std::size_t stream_leavers_by(unsigned threads, Tree<T::value>& tree) {
    StreamMemory memory;
    LeaverPass<T::value> pass;
    LeafBoxes<T::value> boxes;
    TaskPool pool(threads);
    pass.run(tree, pool, boxes);
    stream(tree, pass, boxes, memory, pool);
    return pass.leavers().size();
  }
  static void stream_by(unsigned threads, Tree<T::value>& tree) {
    StreamMemory memory;
    LeafBoxes<T::value> boxes;
    TaskPool pool(threads);
    stream(tree, boxes, memory, pool);
  }
};
TYPED_TEST_SUITE(Stream, Dimensions, DimensionNames);

TYPED_TEST(Stream, FindsThePlacesThatAreThereAlready) {
  for (const char* const free_directions : {"0", "1"}) {
    const auto grown = TestFixture::grown(200, free_directions);
    auto tree = grown;
    TestFixture::stream_by(1, tree);
    EXPECT_TRUE(is_sound(tree));
    EXPECT_EQ(tree.entries(), grown.entries());
    EXPECT_EQ(tree.objects(), 200U);
    EXPECT_GT(tree.slots(), 10U);
  }
}

TYPED_TEST(Stream, PlacesByTheNewBoxesOfTheTable) {
  auto tree = TestFixture::grown(200, "1");
  for (std::uint32_t id = 0; id < 200; id += 2) tree.table.widen({id}, tree.table.box({199 - id}));
  TestFixture::stream_by(1, tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Stream, ListsAreTheSameForAnyNumberOfThreads) {
  auto expected = TestFixture::grown(300, "1");
  for (std::uint32_t id = 0; id < 300; id += 3) expected.table.widen({id}, expected.table.box({299 - id}));
  auto moved = expected;
  TestFixture::stream_by(1, expected);
  for (const unsigned threads : {2U, 3U, 8U}) {
    auto tree = moved;
    TestFixture::stream_by(threads, tree);
    EXPECT_TRUE(is_sound(tree));
    EXPECT_EQ(tree.entries(), expected.entries());
    EXPECT_EQ(hash(tree), hash(expected)) << threads << " threads";
  }
}

/// The objects of each leaf, in order.
template <int D>
std::vector<std::vector<std::uint32_t>> objects_of_leaves(const Tree<D>& tree) {
  std::vector<std::vector<std::uint32_t>> leaves;
  for_each_node(tree, tree.root(), [&](NodeId id) {
    std::vector<std::uint32_t>& objects = leaves.emplace_back();
    for (const Entry& entry : tree[id].entries) objects.push_back(entry.object.value);
    std::ranges::sort(objects);
  });
  return leaves;
}

TYPED_TEST(Stream, WhatLeavesItsCellGoesWhereAllWouldGo) {
  for (const char* const free_directions : {"0", "1"}) {
    auto tree = TestFixture::grown(300, free_directions);
    std::size_t most = 0;
    std::size_t least = 300;
    for (int step = 0; step < 20; ++step) {
      TestFixture::walk(tree, step % 5 == 0 ? 30 : 0.4);
      auto expected = tree;
      TestFixture::stream_by(1, expected);
      const std::size_t left = TestFixture::stream_leavers_by(1, tree);
      most = std::max(most, left);
      least = std::min(least, left);
      ASSERT_TRUE(is_sound(tree)) << "step " << step;
      ASSERT_EQ(tree.entries(), expected.entries()) << "step " << step;
      ASSERT_EQ(objects_of_leaves(tree), objects_of_leaves(expected)) << "step " << step;
    }
    EXPECT_LT(least, most);
    if (*free_directions == '1') continue;
    EXPECT_LT(least, 250U) << "an object that stays is not sent down again";
  }
}

TYPED_TEST(Stream, LeaversAreTheSameForAnyNumberOfThreads) {
  auto expected = TestFixture::grown(300, "0");
  TestFixture::walk(expected, 2);
  const auto moved = expected;
  const std::size_t left = TestFixture::stream_leavers_by(1, expected);
  for (const unsigned threads : {2U, 3U, 8U}) {
    auto tree = moved;
    EXPECT_EQ(TestFixture::stream_leavers_by(threads, tree), left);
    EXPECT_TRUE(is_sound(tree));
    EXPECT_EQ(hash(tree), hash(expected)) << threads << " threads";
  }
}

TYPED_TEST(Stream, WhatAllNeededIsGivenBackWhenFewLeave) {
  auto tree = TestFixture::grown(300, "0");
  StreamMemory memory;
  LeaverPass<TypeParam::value> pass;
  LeafBoxes<TypeParam::value> boxes;
  TaskPool pool(1);
  stream(tree, boxes, memory, pool);
  const std::size_t needed_by_all = memory.by_thread.front().places.size();
  EXPECT_GE(needed_by_all, 600U);
  pass.run(tree, pool, boxes);
  stream(tree, pass, boxes, memory, pool);
  EXPECT_EQ(memory.by_thread.front().places.size(), needed_by_all) << "as many as straddle something leave";

  for (std::uint32_t id = 20; id < 300; ++id) EXPECT_EQ(tree.table.remove({id}), Status::ok);
  stream(tree, boxes, memory, pool);
  pass.run(tree, pool, boxes);
  stream(tree, pass, boxes, memory, pool);
  EXPECT_LT(memory.by_thread.front().places.size(), needed_by_all);
  EXPECT_TRUE(is_sound(tree));
}

/// What ends on a partitioner lies left of it, what begins there lies on both sides.
TYPED_TEST(Stream, WhatTouchesItsCellStaysOnlyIfItEndsThere) {
  constexpr int kD = TypeParam::value;
  for (const bool ends : {true, false}) {
    auto tree = TestFixture::grown(300, "0");
    std::size_t touching = 0;
    for_each_node(tree, tree.root(), [&](NodeId id) {
      if (!tree[id].is_leaf()) return;
      const Node<kD>& parent = tree[tree[id].parent];
      if ((parent.left == id) != ends) return;
      for (const Entry& entry : tree[id].entries) {
        if (entry.straddle != 0) continue;
        Box<kD> box = tree.table.box(entry.object);
        (ends ? box.max : box.min)[static_cast<int>(parent.direction)] = parent.plane.offset;
        tree.table.widen(entry.object, box);
        ++touching;
      }
    });
    EXPECT_GT(touching, 10U);
    const std::size_t left = TestFixture::stream_leavers_by(1, tree);
    EXPECT_TRUE(is_sound(tree));
    if (ends)
      EXPECT_LE(left, tree.objects() - touching);
    else
      EXPECT_GE(left, touching);
  }
}

TYPED_TEST(Stream, AnEmptyTableEmptiesEveryLeaf) {
  auto tree = TestFixture::grown(60, "1");
  for (std::uint32_t id = 0; id < 60; ++id) EXPECT_EQ(tree.table.remove({id}), Status::ok);
  TestFixture::stream_by(1, tree);
  EXPECT_TRUE(is_sound(tree));
  EXPECT_EQ(tree.entries(), 0U);
}

TYPED_TEST(Stream, BulkIsDividedInItsFirstStep) {
  constexpr int kD = TypeParam::value;
  const auto largest_leaf = [](const Tree<kD>& tree) {
    std::uint32_t largest = 0;
    for_each_node(tree, tree.root(), [&](NodeId id) {
      if (tree[id].is_leaf()) largest = std::max(largest, tree[id].population);
    });
    return largest;
  };
  for (const bool bulk : {true, false}) {
    Bsp<kD> tree(
        config_of("max_redundancy=0.4,min_threshold=16,max_threshold=16,free_directions=0,bulk_factor=" +
                  std::string(bulk ? "2" : "0")));
    MovingBoxes<kD> crowd(tree, 60, 1, 5);
    crowd.add(400);
    tree.step();
    if (bulk)
      EXPECT_LE(largest_leaf(tree.tree()), 16U) << "not only the largest leaves, of which it was made";
    else
      EXPECT_EQ(largest_leaf(tree.tree()), 400U);
    EXPECT_TRUE(is_sound(tree.tree()));
  }
}

TEST(TunedConfig, IsValidAndSwitchesThePoliciesOn) {
  const Config config = tuned_config();
  EXPECT_NO_THROW(check(config));
  EXPECT_TRUE(config.byte_sweep);
  EXPECT_GT(config.skin, 0);
  EXPECT_FALSE(Config{}.byte_sweep) << "the paper's parameters are the defaults";
}

}  // namespace
}  // namespace kerf::test
