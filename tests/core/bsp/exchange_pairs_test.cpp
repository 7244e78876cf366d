#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/support/dimensions.h"
#include "tests/support/moving_boxes.h"

namespace kerf::test {
namespace {

template <class T>
class ExchangePairs : public testing::Test {};
TYPED_TEST_SUITE(ExchangePairs, Dimensions, DimensionNames);

std::vector<Pair> copy_of(std::span<const Pair> pairs) { return {pairs.begin(), pairs.end()}; }

/// A tree, and a crowd of its own that moves as every other one does.
template <int D>
struct Run {
  explicit Run(const Config& config) : tree(config), crowd(tree, 10, 1, 7) { crowd.add(200); }
  void step(double time) {
    crowd.bounce(time);
    tree.step();
  }
  Bsp<D> tree;
  MovingBoxes<D> crowd;
};

/// Two trees with the same crowd: one gives its lists away, and its pairs are the same in each step.
template <int D>
void give_all_away(const Config& config) {
  Run<D> keeps(config);
  Run<D> gives(config);
  std::array<PairBuffer, 2> lists;
  std::vector<Pair> before;
  for (std::size_t step = 0; step < 40; ++step) {
    const double time = step < 20 ? 0.01 : 1;
    keeps.step(time);
    gives.step(time);
    gives.tree.exchange_pairs(lists[step % 2]);
    EXPECT_TRUE(gives.tree.pairs().empty());
    EXPECT_EQ(copy_of(lists[step % 2].all()), copy_of(keeps.tree.pairs()));
    EXPECT_EQ(copy_of(lists[(step + 1) % 2].all()), before) << "a list that was given away has changed";
    EXPECT_EQ(keeps.tree.state_hash(), gives.tree.state_hash());
    before = copy_of(keeps.tree.pairs());
  }
}

TYPED_TEST(ExchangePairs, GivesEachListAway) {
  give_all_away<TypeParam::value>(Config{});
  give_all_away<TypeParam::value>(tuned_config());
}

/// What is moved away is empty, and serves again.
TYPED_TEST(ExchangePairs, ABufferThatWasMovedFromIsEmpty) {
  Run<TypeParam::value> run(tuned_config());
  PairBuffer buffer;
  std::vector<PairBuffer> lists;
  for (std::size_t step = 0; step < 5; ++step) {
    run.step(0.01);
    run.tree.exchange_pairs(buffer);
    const std::size_t pairs = buffer.size();
    EXPECT_GT(pairs, 0U);
    lists.push_back(std::move(buffer));
    EXPECT_EQ(buffer.size(), 0U);  // NOLINT(bugprone-use-after-move): that is what is tested
    EXPECT_EQ(lists.back().size(), pairs);
  }
}

}  // namespace
}  // namespace kerf::test
