#include "core/broad_phase/pair_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

std::vector<Pair> copy(std::span<const Pair> pairs) { return {pairs.begin(), pairs.end()}; }

TEST(PairChanges, TheFirstPairsAllBeginAndTheLastAllEnd) {
  PairChanges changes;
  const std::vector<Pair> pairs{{{7}, {900000}}, {{0}, {1}}, {{0}, {4294967294}}};
  changes.update(pairs);
  EXPECT_EQ(copy(changes.begun()), (std::vector<Pair>{pairs[1], pairs[2], pairs[0]}));
  EXPECT_TRUE(changes.ended().empty());
  changes.update({});
  EXPECT_TRUE(changes.begun().empty());
  EXPECT_EQ(copy(changes.ended()), (std::vector<Pair>{pairs[1], pairs[2], pairs[0]}));
}

TEST(PairChanges, AnotherOrderIsNoChange) {
  PairChanges changes;
  std::vector<Pair> pairs{{{3}, {4}}, {{1}, {9}}, {{1}, {2}}};
  changes.update(pairs);
  std::reverse(pairs.begin(), pairs.end());
  changes.update(pairs);
  EXPECT_TRUE(changes.begun().empty());
  EXPECT_TRUE(changes.ended().empty());
}

template <class T>
class PairChangesOfTree : public testing::Test {};
TYPED_TEST_SUITE(PairChangesOfTree, Dimensions, DimensionNames);

TYPED_TEST(PairChangesOfTree, LeadFromTheSetOfAStepToThatOfTheNext) {
  Bsp<TypeParam::value> tree(tuned_config());
  MovingBoxes<TypeParam::value> crowd(tree, 14, 1.5, 3);
  crowd.add(300, 7);
  PairChanges changes;
  std::set<Pair> pairs;
  std::size_t begun = 0;
  std::size_t ended = 0;
  for (int step = 0; step < 60; ++step) {
    crowd.walk(0.4);
    if (step % 10 == 9) crowd.replace(20);
    tree.step();
    changes.update(tree.pairs());
    for (const Pair& pair : changes.ended()) ended += pairs.erase(pair);
    for (const Pair& pair : changes.begun()) begun += pairs.insert(pair).second ? 1 : 0;
    ASSERT_EQ(pairs, std::set<Pair>(tree.pairs().begin(), tree.pairs().end())) << "step " << step;
    ASSERT_EQ(begun - ended, pairs.size()) << "a change was reported that is none";
  }
  EXPECT_GT(ended, 300U);
}

}  // namespace
}  // namespace kerf::test
