#include "core/bsp/leaf_pass.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

/// Divides the leaf until each object of a row from `first` to `end` has a leaf of its own.
template <int D>
void divide_row(kerf::Tree<D>& tree, NodeId leaf, std::uint32_t first, std::uint32_t end) {
  if (end - first < 2) return;
  const std::uint32_t middle = (first + end) / 2;
  plant(tree, leaf, 0, static_cast<Scalar>(2 * middle) - 0.5F);
  divide_row(tree, tree[leaf].left, first, middle);
  divide_row(tree, tree[leaf].right, middle, end);
}

/// A leaf for each object, in their order.
template <int D>
kerf::Tree<D> row_of_leaves(std::uint32_t count) {
  std::vector<Box<D>> boxes;
  for (std::uint32_t k = 0; k < count; ++k)
    boxes.push_back(slab<D>(static_cast<Scalar>(2 * k), static_cast<Scalar>(2 * k + 1)));
  kerf::Tree<D> tree = tree_of<D>(boxes);
  divide_row(tree, tree.root(), 0, count);
  return tree;
}

/// Makes the thread that has the first leaf wait in its second one until the other has done many, which
/// begins only when the first leaf is done. Waits end after some time, in case that no other thread comes.
class Delays {
 public:
  explicit Delays(std::size_t enough) : enough_(enough) {}

  void do_leaf(std::size_t leaf, const void* thread) {
    std::unique_lock lock(mutex_);
    const auto wait_for = [&](auto condition) {
      changed_.wait_for(lock, std::chrono::seconds(2), condition);
    };
    if (leaf == 0) {
      first_ = thread;
    } else if (first_ == thread) {
      if (!std::exchange(has_waited_, true)) wait_for([&] { return done_by_other_ >= enough_; });
    } else {
      wait_for([&] { return first_ != nullptr; });
      ++done_by_other_;
    }
    changed_.notify_all();
  }

 private:
  std::size_t enough_;
  std::mutex mutex_;
  std::condition_variable changed_;
  const void* first_ = nullptr;
  std::size_t done_by_other_ = 0;
  bool has_waited_ = false;
};

template <class T>
class LeafPasses : public testing::Test {};
TYPED_TEST_SUITE(LeafPasses, Dimensions, DimensionNames);

/// Where one thread is late with its leaves, the pairs of later ones wait for theirs.
TYPED_TEST(LeafPasses, JoinPairsInTheOrderOfLeavesWhicheverThreadIsLate) {
  constexpr int kD = TypeParam::value;
  TaskPool pool(2);
  const auto count = static_cast<std::uint32_t>(pool.pieces());
  const kerf::Tree<kD> tree = row_of_leaves<kD>(count);
  Delays delays(count / 2);
  LeafPass<kD> pass;
  PairBuffer pairs;
  pass.run(
      tree, pool, true,
      [&](NodeId leaf, LeafScratch<kD>& scratch, PairBuffer& found) {
        const ObjectId object = tree[leaf].entries.front().object;
        delays.do_leaf(object.index(), &scratch);
        found.push_back({object, ObjectId{1000}});
      },
      pairs);
  ASSERT_EQ(pairs.size(), count);
  for (std::uint32_t k = 0; k < count; ++k) EXPECT_EQ(pairs.all()[k].a, ObjectId{k});
}

}  // namespace
}  // namespace kerf::test
