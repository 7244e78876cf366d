#include "core/bsp/leaf_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/bsp/bsp.h"
#include "core/bsp/stream.h"
#include "core/kernels/prefetch.h"
#include "tests/support/boxes.h"
#include "tests/support/checked.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

/// A divided tree of boxes that are where they were a moment ago.
template <class T>
class LeavesWithBoxes : public testing::Test {
 protected:
  static Tree<T::value> moved_tree() {
    Random random(21);
    std::vector<Box<T::value>> boxes(300);
    for (Box<T::value>& box : boxes) {
      box.min = random_point<T::value>(random, 0, 20);
      box.max = box.min + random_point<T::value>(random, 0, 2);
    }
    auto tree = tree_of<T::value>(boxes);
    plant_at_random(tree, 12, 8, random);
    for (std::uint32_t id = 0; id < 300; id += 2) {
      const Vector<T::value> by = random_point<T::value>(random, -2, 2);
      tree.table.widen({id}, {boxes[id].min + by, boxes[id].max + by});
    }
    return tree;
  }
  /// Leaves that lack boxes, or have others than their entries' objects.
  static std::size_t wrong(const Tree<T::value>& tree, LeafBoxes<T::value>& boxes) {
    std::size_t count = 0;
    for_each_node(tree, tree.root(), [&](NodeId id) {
      if (!tree[id].is_leaf()) return;
      std::vector<PackedBox<T::value>> of_table;
      for (const Entry& entry : tree[id].entries) of_table.push_back(tree.table.packed(entry.object));
      std::vector<PackedBox<T::value>> lent;
      boxes.swap(id, lent);
      const bool same =
          std::ranges::equal(lent, of_table, {}, &PackedBox<T::value>::lane, &PackedBox<T::value>::lane);
      boxes.swap(id, lent);
      if (!boxes.has(tree, id) || !same) ++count;
    });
    return count;
  }
  static void stream_all(Tree<T::value>& tree, LeafBoxes<T::value>& boxes, unsigned threads) {
    StreamMemory memory;
    TaskPool pool(threads);
    stream(tree, boxes, memory, pool);
  }
  static void stream_leavers(Tree<T::value>& tree, LeafBoxes<T::value>& boxes, unsigned threads) {
    StreamMemory memory;
    LeaverPass<T::value> pass;
    TaskPool pool(threads);
    pass.run(tree, pool, boxes);
    stream(tree, pass, boxes, memory, pool);
  }
};
TYPED_TEST_SUITE(LeavesWithBoxes, Dimensions, DimensionNames);

TYPED_TEST(LeavesWithBoxes, HaveThoseOfTheirEntriesInTheirOrder) {
  for (const unsigned threads : {1U, 2U, 3U, 8U}) {
    for (const auto place : {&TestFixture::stream_all, &TestFixture::stream_leavers}) {
      auto tree = TestFixture::moved_tree();
      LeafBoxes<TypeParam::value> boxes;
      boxes.begin(tree, true);
      place(tree, boxes, threads);
      EXPECT_EQ(TestFixture::wrong(tree, boxes), 0U) << threads << " threads";
    }
  }
}

TYPED_TEST(LeavesWithBoxes, LoseThemWithEveryChange) {
  constexpr int kD = TypeParam::value;
  using Change = void (*)(Tree<kD>&, NodeId);
  for (const Change change : {Change([](Tree<kD>&tree, NodeId leaf) { tree.add_entry(leaf, {0}, 0); }),
                              Change([](Tree<kD>&tree, NodeId leaf) { tree.clear_entries(leaf); }),
                              Change([](Tree<kD>&tree, NodeId leaf) { tree.set_entries(leaf, {}); }),
                              Change([](Tree<kD>&tree, NodeId leaf) { ++tree[leaf].generation; })}) {
    auto tree = TestFixture::moved_tree();
    LeafBoxes<kD> boxes;
    boxes.begin(tree, true);
    TestFixture::stream_leavers(tree, boxes, 1);
    NodeId leaf = tree.root();
    while (!tree[leaf].is_leaf()) leaf = tree[leaf].right;
    ASSERT_TRUE(boxes.has(tree, leaf));
    change(tree, leaf);
    EXPECT_FALSE(boxes.has(tree, leaf));
  }
}

TYPED_TEST(LeavesWithBoxes, HaveNoneUnlessTheyAreWanted) {
  auto tree = TestFixture::moved_tree();
  LeafBoxes<TypeParam::value> boxes;
  boxes.begin(tree, true);
  TestFixture::stream_leavers(tree, boxes, 1);
  boxes.begin(tree, false);
  TestFixture::stream_leavers(tree, boxes, 1);
  for_each_node(tree, tree.root(), [&](NodeId id) { EXPECT_FALSE(boxes.has(tree, id)); });
}

/// Some objects with high ids, which make the table as long as that of a large scene. They move alone in some
/// steps, so little that most stay in their leaves.
template <int D>
class Outliers {
 public:
  explicit Outliers(BroadPhase<D>& broad_phase) : broad_phase_(broad_phase) {
    for (std::uint32_t k = 0; k < kCount; ++k)
      EXPECT_EQ(broad_phase_.insert(object(k), next_box(), Mobility::moving), Status::ok);
  }
  void move() {
    random_ = Random(17);  // where they began, but for the shift
    shift_ += 0.2F;
    for (std::uint32_t k = 0; k < kCount; ++k)
      EXPECT_EQ(broad_phase_.move(object(k), next_box()), Status::ok);
  }

 private:
  static constexpr std::uint32_t kCount = 10;
  static ObjectId object(std::uint32_t k) {
    return {static_cast<std::uint32_t>(tuning::kOwnPages / sizeof(PackedBox<D>)) + k};
  }
  Box<D> next_box() { return box_at<D>(random_point<D>(random_, 4, 12) + all<D>(shift_), 1); }

  BroadPhase<D>& broad_phase_;
  Random random_{17};
  Scalar shift_ = 0;
};

TYPED_TEST(LeavesWithBoxes, FindThePairsOfLongTables) {
  constexpr int kD = TypeParam::value;
  for (const unsigned threads : {1U, 2U}) {
    Bsp<kD> tree(
        config_of("byte_sweep=1,skin=0,stream_share=0.06,max_redundancy=0.4,schedule_interval=1,"
                  "budget_divisor=1,min_threshold=16,max_threshold=32,free_directions=0"));
    tree.set_threads(threads, Sharing::always);
    Checked<kD> checked(tree);
    MovingBoxes<kD> crowd(checked, kD == 2 ? 20 : 10, 1, 31);
    crowd.add(200, 9);
    Outliers<kD> outliers(checked);
    for (int step = 0; step < 60; ++step) {
      if (step % 7 == 0) {
        crowd.gather(step % 14 == 0 ? 0.3 : -0.3);
      } else if (step % 3 == 0) {
        outliers.move();
      } else {
        crowd.walk(0.5);
      }
      if (step % 4 == 1) crowd.remove(3);
      if (step % 4 == 2) crowd.add(3, 9);
      checked.step();
    }
    EXPECT_GT(tree.statistics().leaves, 4U);
  }
}

}  // namespace
}  // namespace kerf::test
