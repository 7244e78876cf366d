#include "core/tree/partitioner.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/tree/ballot.h"
#include "tests/support/boxes.h"
#include "tests/support/config_of.h"
#include "tests/support/dimensions.h"
#include "tests/support/planted_tree.h"

namespace kerf::test {
namespace {

TEST(PartitionerQuality, FollowsThePaperOnHandMadeCases) {
  const Quality even{10, 5, 5};
  EXPECT_EQ(population(even), 10U);
  EXPECT_EQ(balance(even), 1.0F);
  EXPECT_EQ(redundancy(even), 0U);
  const Quality straddled{10, 8, 4};
  EXPECT_EQ(balance(straddled), 0.5F);
  EXPECT_EQ(redundancy(straddled), 2U);
  EXPECT_EQ(balance(Quality{10, 10, 0}), 0.0F);
  EXPECT_EQ(balance(Quality{}), 1.0F) << "nothing to balance";
  EXPECT_EQ(redundancy(Quality{7, 7, 7}), 7U);
}

TEST(PartitionerQuality, MeasureCountsEachSide) {
  const std::vector<Interval> intervals{{0, 1}, {1, 2}, {2, 3}, {3, 3}, {0, 3}};
  EXPECT_EQ(measure(intervals, 2), (Quality{5, 4, 3}));
  EXPECT_EQ(measure(intervals, 3), (Quality{5, 5, 0}));
  EXPECT_EQ(measure(intervals, -1), (Quality{5, 0, 5}));
  EXPECT_EQ(measure({}, 0), Quality{});
}

TEST(PartitionerQuality, ScoreIsBalanceLessTheShareOfStraddlers) {
  EXPECT_EQ(score(Quality{10, 5, 5}), 1.0F);
  EXPECT_FLOAT_EQ(score(Quality{10, 8, 4}), 0.5F - 0.2F);
  EXPECT_EQ(score(Quality{}), 0.0F);
}

TEST(PartitionerQuality, IsGoodOnlyWithinBothLimits) {
  const Config config;
  EXPECT_TRUE(is_good({30, 20, 10}, config)) << "balance exactly 0.5";
  EXPECT_FALSE(is_good({31, 21, 10}, config));
  EXPECT_TRUE(is_good({40, 21, 20}, config)) << "redundancy exactly 2.5 %";
  EXPECT_FALSE(is_good({40, 21, 21}, config));
  EXPECT_FALSE(is_good({39, 20, 20}, config));
}

TEST(PartitionerQuality, IsGoodOnlyIfBothChildrenShrink) {
  const Config lax = config_of("min_balance=0,max_redundancy=1");
  EXPECT_FALSE(is_good({10, 10, 5}, lax));
  EXPECT_FALSE(is_good({10, 5, 10}, lax));
  EXPECT_FALSE(is_good({10, 0, 10}, lax));
  EXPECT_FALSE(is_good({0, 0, 0}, lax));
  EXPECT_TRUE(is_good({10, 9, 9}, lax));
}

TEST(CandidateCount, IsTwiceTheRootOfTheObjects) {
  const Config config;
  EXPECT_EQ(candidate_count(16, 256, config), 8U);
  EXPECT_EQ(candidate_count(100, 256, config), 20U);
  EXPECT_EQ(candidate_count(101, 256, config), 21U) << "rounded up";
  EXPECT_EQ(candidate_count(1'000'000, 256, config), 256U) << "no more than there are";
  EXPECT_EQ(candidate_count(0, 256, config), 1U);
  EXPECT_EQ(candidate_count(100, 256, config_of("candidate_factor=0")), 1U);
}

template <class T>
class ChoosePartitioner : public testing::Test {};
TYPED_TEST_SUITE(ChoosePartitioner, Dimensions, DimensionNames);

template <int D>
std::vector<Box<D>> scattered(std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Box<D>> boxes;
  for (std::uint32_t k = 0; k < count; ++k) boxes.push_back(random_box<D>(random, 100, 0.2));
  return boxes;
}

/// The best candidate by trying each direction on all objects.
template <int D>
std::optional<Candidate> best_of_all(const kerf::Tree<D>& tree, std::uint32_t tries, const Config& config) {
  std::optional<Candidate> best;
  for (std::uint32_t direction = 0; direction < tries; ++direction) {
    const auto point = best_reference_point(shadows(tree, direction), config);
    if (point && (!best || score(point->quality) > score(best->quality)))
      best = Candidate{direction, point->offset, point->quality, true};
  }
  return best;
}

TYPED_TEST(ChoosePartitioner, TakesTheBestOfItsCandidates) {
  constexpr int kD = TypeParam::value;
  const Config config;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto tree = tree_of<kD>(scattered<kD>(100, seed));
    const auto chosen = choose_partitioner(tree, tree.root(), config);
    const auto best = best_of_all(tree, candidate_count(100, tree.directions().size(), config), config);
    ASSERT_EQ(chosen.has_value(), best.has_value());
    if (!best) continue;
    EXPECT_EQ(chosen->direction, best->direction);
    EXPECT_EQ(chosen->offset, best->offset);
    EXPECT_EQ(chosen->quality, best->quality);
    EXPECT_TRUE(chosen->exact);
  }
}

TYPED_TEST(ChoosePartitioner, WithoutFreeDirectionsStaysOnTheAxes) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> stairs;  // only a diagonal plane divides them evenly without straddlers
  for (int k = 0; k < 20; ++k) stairs.push_back(box_at(all<kD>(static_cast<Scalar>(k)), 0.4F));
  const auto tree = tree_of<kD>(stairs);
  const auto tried = ballot(tree, Operator::split, tree.root(), config_of("free_directions=0"));
  for (const BallotEntry& entry : tried) EXPECT_LT(entry.direction, kD);
  EXPECT_EQ(tried.size(), kD);
  const auto chosen = choose_partitioner(tree, tree.root(), config_of("free_directions=0"));
  ASSERT_TRUE(chosen);
  EXPECT_LT(chosen->direction, kD);
}

TYPED_TEST(ChoosePartitioner, TriesEveryAxisHoweverFewCandidatesAreAsked) {
  constexpr int kD = TypeParam::value;
  std::vector<Box<kD>> column;  // only the last axis divides
  for (int k = 0; k < 20; ++k)
    column.push_back(slab<kD>(static_cast<Scalar>(k), static_cast<Scalar>(k) + 0.5F, kD - 1));
  const auto tree = tree_of<kD>(column);
  const auto chosen = choose_partitioner(tree, tree.root(), config_of("candidate_factor=0"));
  ASSERT_TRUE(chosen);
  EXPECT_EQ(chosen->direction, kD - 1);
}

TYPED_TEST(ChoosePartitioner, SampledChoiceIsConfirmedOnAllObjects) {
  constexpr int kD = TypeParam::value;
  const Config config = config_of("sample=16");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto tree = tree_of<kD>(scattered<kD>(200, seed));
    const auto chosen = choose_partitioner(tree, tree.root(), config);
    ASSERT_TRUE(chosen);
    EXPECT_TRUE(chosen->exact);
    EXPECT_EQ(chosen->quality, measure(shadows(tree, chosen->direction), chosen->offset));
    EXPECT_TRUE(is_good(chosen->quality, config));
  }
}

TYPED_TEST(ChoosePartitioner, FindsNothingWhereEverythingCoincides) {
  constexpr int kD = TypeParam::value;
  const std::vector<Box<kD>> same(50, slab<kD>(0, 1));
  const auto tree = tree_of<kD>(same);
  for (const char* text : {"", "sample=4", "min_balance=0,max_redundancy=1"}) {
    EXPECT_FALSE(choose_partitioner(tree, tree.root(), config_of(text))) << text;
  }
}

TYPED_TEST(ChoosePartitioner, FindsNothingAmongNoneOrOneObject) {
  constexpr int kD = TypeParam::value;
  for (std::uint32_t count : {0U, 1U}) {
    const auto tree = tree_of<kD>(scattered<kD>(count, 1));
    EXPECT_FALSE(choose_partitioner(tree, tree.root(), config_of("min_balance=0,max_redundancy=1")));
  }
}

}  // namespace
}  // namespace kerf::test
