#include "core/tree/stream.h"

#include <gtest/gtest.h>

#include "core/broad_phase/bsp.h"
#include "core/tree/hash.h"
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
  static void grow(Bsp<T::value>& tree, std::uint32_t count) {
    MovingBoxes<T::value> crowd(tree, 30, 1.5, 5);
    crowd.add(count, 4);
    for (int step = 0; step < 40; ++step) {
      crowd.walk(0.3);
      tree.step();
    }
  }
  static void stream_by(unsigned threads, Tree<T::value>& tree) {
    StreamMemory memory;
    TaskPool pool(threads);
    stream(tree, memory, pool);
  }
};
TYPED_TEST_SUITE(Stream, Dimensions, DimensionNames);

TYPED_TEST(Stream, FindsThePlacesThatAreThereAlready) {
  for (const std::string_view directions : {"0", "1"}) {
    Bsp<TypeParam::value> grown(
        config_of("max_redundancy=0.4,schedule_interval=1,budget_divisor=1,"
                  "min_threshold=8,max_threshold=8,free_directions=" +
                  std::string(directions)));
    TestFixture::grow(grown, 200);
    auto tree = grown.tree();
    TestFixture::stream_by(1, tree);
    EXPECT_TRUE(is_sound(tree));
    EXPECT_EQ(tree.entries(), grown.tree().entries());
    EXPECT_EQ(tree.objects(), 200U);
    EXPECT_GT(tree.slots(), 10U);
  }
}

TYPED_TEST(Stream, PlacesByTheNewBoxesOfTheTable) {
  Bsp<TypeParam::value> grown(
      config_of("max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=8,max_threshold=8"));
  TestFixture::grow(grown, 200);
  auto tree = grown.tree();
  for (std::uint32_t id = 0; id < 200; id += 2) tree.table.widen({id}, tree.table.box({199 - id}));
  TestFixture::stream_by(1, tree);
  EXPECT_TRUE(is_sound(tree));
}

TYPED_TEST(Stream, ListsAreTheSameForAnyNumberOfThreads) {
  Bsp<TypeParam::value> grown(
      config_of("max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=8,max_threshold=8"));
  TestFixture::grow(grown, 300);
  auto expected = grown.tree();
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

TYPED_TEST(Stream, AnEmptyTableEmptiesEveryLeaf) {
  Bsp<TypeParam::value> grown(
      config_of("max_redundancy=0.4,schedule_interval=1,budget_divisor=1,min_threshold=8,max_threshold=8"));
  TestFixture::grow(grown, 60);
  auto tree = grown.tree();
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
      EXPECT_LE(largest_leaf(tree.tree()), 32U);
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
