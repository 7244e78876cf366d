#include "core/bsp/kept_pairs.h"

#include <gtest/gtest.h>

#include "core/tree/merge.h"
#include "core/tree/placement.h"
#include "core/tree/swap.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

/// Trees of random boxes, divided at random: their pairs are kept while operators change them.
template <class T>
class Kept : public testing::Test {
 protected:
  static constexpr std::uint32_t kCount = 60;

  static kerf::Tree<T::value> divided(Random& random) {
    std::vector<Box<T::value>> boxes(kCount);
    for (Box<T::value>& box : boxes) {
      for (int i = 0; i < T::value; ++i) {
        box.min[i] = static_cast<Scalar>(random.uniform(0, 10));
        box.max[i] = box.min[i] + static_cast<Scalar>(random.uniform(0, 3));
      }
    }
    auto tree = tree_of<T::value>(boxes);
    plant_at_random(tree, 8, 6, random);
    return tree;
  }

  static std::vector<Pair> pairs_of(KeptPairs<T::value>& kept, kerf::Tree<T::value>& tree,
                                    const ObjectTable<T::value>& table) {
    const Config config{};
    Requests<T::value> requests(VolumeKind::box);
    StepMemory<T::value> memory;
    ThreadUse threads;
    threads.set(2, Sharing::always);
    const std::vector<ObjectFlags> flags(kCount);
    PairBuffer pairs;
    kept.find({config, tree, requests, memory, threads, 1}, {tree.table, table, flags, true, true}, pairs);
    return {pairs.all().begin(), pairs.all().end()};
  }
  static std::vector<Pair> pairs_of(KeptPairs<T::value>& kept, kerf::Tree<T::value>& tree) {
    return pairs_of(kept, tree, tree.table);
  }
};
TYPED_TEST_SUITE(Kept, Dimensions, DimensionNames);

TYPED_TEST(Kept, PairsAreThoseOfTheFatBoxesBeforeAndAfterEachSwap) {
  Random random(7);
  std::size_t swaps = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto tree = TestFixture::divided(random);
    KeptPairs<TypeParam::value> kept;
    EXPECT_EQ(difference(TestFixture::pairs_of(kept, tree), overlapping(tree)), "");
    while (!tree[tree.root()].is_leaf()) {
      const std::vector<NodeId> nodes = inner_nodes(tree);
      swap(tree, nodes[random.below(static_cast<std::uint32_t>(nodes.size()))]);
      ++swaps;
      ASSERT_EQ(difference(TestFixture::pairs_of(kept, tree), overlapping(tree)), "") << "trial " << trial;
    }
  }
  EXPECT_GT(swaps, 200U);
}

TYPED_TEST(Kept, PairsOutliveMergesAndNewLivesOfNodes) {
  Random random(8);
  for (int trial = 0; trial < 60; ++trial) {
    auto tree = TestFixture::divided(random);
    KeptPairs<TypeParam::value> kept;
    TestFixture::pairs_of(kept, tree);
    merge(tree, inner_nodes(tree).back());
    plant_at_random(tree, 3, 6, random);
    ASSERT_EQ(difference(TestFixture::pairs_of(kept, tree), overlapping(tree)), "") << "trial " << trial;
  }
}

TYPED_TEST(Kept, ALeafThatNothingChangedIsNotSweptAgain) {
  Random random(9);
  auto tree = TestFixture::divided(random);
  KeptPairs<TypeParam::value> kept;
  const std::vector<Pair> before = TestFixture::pairs_of(kept, tree);
  const auto table = tree.table;
  for (std::uint32_t id = 0; id < TestFixture::kCount; ++id)  // unnoticed on purpose: the fat boxes are gone
    tree.table.widen({id}, {});
  EXPECT_EQ(difference(TestFixture::pairs_of(kept, tree, table), before), "");
}

}  // namespace
}  // namespace kerf::test
