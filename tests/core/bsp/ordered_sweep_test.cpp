#include "core/bsp/ordered_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

bool in_order(const std::vector<Entry>& entries) {
  return std::is_sorted(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key.lo < b.key.lo || (a.key.lo == b.key.lo && a.object < b.object);
  });
}

TEST(SortEntries, OrdersByLowEndThenObject) {
  Random random(1);
  for (const std::uint32_t count : {0U, 1U, 2U, 7U, 100U, 1000U}) {
    std::vector<Entry> entries;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto lo = static_cast<Scalar>(random.below(50));
      entries.push_back({{lo, lo + 1}, {count - k}, random.bits()});
    }
    std::vector<Entry> sorted = entries;
    sort_entries(sorted);
    EXPECT_TRUE(in_order(sorted));
    for (const Entry& entry : entries) {
      const auto same = [&](const Entry& e) {
        return e.object == entry.object && e.key == entry.key && e.straddle == entry.straddle;
      };
      EXPECT_EQ(std::count_if(sorted.begin(), sorted.end(), same), 1) << "entries stay whole";
    }
  }
}

TEST(SortEntries, TakesReversedAndNearlyOrderedListsAndInfinities) {
  std::vector<Entry> reversed;
  for (std::uint32_t k = 0; k < 500; ++k) reversed.push_back({{-static_cast<Scalar>(k), 0}, {k}, 0});
  reversed.push_back({{-std::numeric_limits<Scalar>::infinity(), 0}, {900}, 0});
  sort_entries(reversed);
  EXPECT_TRUE(in_order(reversed));
  std::swap(reversed[3], reversed[4]);
  sort_entries(reversed);
  EXPECT_TRUE(in_order(reversed));
}

template <class T>
class Sweep : public testing::Test {};
TYPED_TEST_SUITE(Sweep, Dimensions, DimensionNames);

TYPED_TEST(Sweep, ReportsEachPairOnceInTreesOfRandomPlanes) {
  constexpr int kD = TypeParam::value;
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    auto tree = random_tree<kD>(random, 60, round % 3 == 0 ? 8 : 2, 30, 20);
    ASSERT_TRUE(same_pairs(swept(tree), overlapping(tree))) << "round " << round;
  }
}

TYPED_TEST(Sweep, ReportsTouchingBoxesOnALatticeWithPlanesOnTheirFaces) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> lattice;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) {
      Box<kD> box = slab<kD>(static_cast<Scalar>(x), static_cast<Scalar>(x + 1));
      box.min[1] = static_cast<Scalar>(y);
      box.max[1] = static_cast<Scalar>(y + 1);
      lattice.push_back(box);
    }
  auto tree = tree_of<kD>(lattice);
  plant(tree, tree.root(), 0, 2);
  plant(tree, tree[tree.root()].left, 1, 3);
  plant(tree, tree[tree.root()].right, 1, 2);
  const auto expected = overlapping(tree);
  EXPECT_EQ(expected.size(), 72U) << "40 faces, 32 corners";
  EXPECT_TRUE(same_pairs(swept(tree), expected));
}

TYPED_TEST(Sweep, LeavesOutPairsOfFixedObjects) {
  constexpr int kD = TypeParam::value;
  kerf::Tree<kD> tree = tree_of<kD>(std::vector<Box<kD>>{});
  for (std::uint32_t k = 0; k < 4; ++k) {
    ASSERT_EQ(tree.table.insert({k}, slab<kD>(0, 1), k < 2 ? Mobility::fixed : Mobility::moving), Status::ok);
    tree.add_entry(tree.root(), {k}, 0);
  }
  EXPECT_EQ(
      difference(swept(tree), std::vector<Pair>{{{0}, {2}}, {{0}, {3}}, {{1}, {2}}, {{1}, {3}}, {{2}, {3}}}),
      "");
}

TYPED_TEST(Sweep, ReportsAStraddlingPairInTheLeftmostLeafOfBoth) {
  constexpr int kD = TypeParam::value;
  auto tree = tree_of<kD>(std::vector{slab<kD>(0, 9), slab<kD>(4, 9), slab<kD>(0, 9)});
  plant(tree, tree.root(), 0, 2);  // 0 and 2 straddle, 1 lies right
  const NodeId right = tree[tree.root()].right;
  plant(tree, right, 0, 6);  // all straddle
  SweepBuffer<kD> buffer;
  const auto pairs_of = [&](NodeId leaf) {
    PairBuffer pairs;
    sweep_leaf(tree.table, tree[leaf], buffer, pairs);
    return sorted({pairs.all().begin(), pairs.all().end()});
  };
  EXPECT_EQ(pairs_of(tree[tree.root()].left), (std::vector<Pair>{{{0}, {2}}}));
  EXPECT_EQ(pairs_of(tree[right].left), (std::vector<Pair>{{{0}, {1}}, {{1}, {2}}}));
  EXPECT_EQ(pairs_of(tree[right].right), std::vector<Pair>{});
}

}  // namespace
}  // namespace kerf::test
