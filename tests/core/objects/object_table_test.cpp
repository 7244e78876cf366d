#include "core/objects/object_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/broad_phase/brute_force.h"
#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/pairs.h"

namespace kerf::test {
namespace {

constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();

template <class T>
class ObjectTable : public testing::Test {
 public:
  kerf::ObjectTable<T::value> table;
};
TYPED_TEST_SUITE(ObjectTable, Dimensions, DimensionNames);

TYPED_TEST(ObjectTable, TakesKeepsAndForgetsObjects) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(this->table.insert({3}, slab<kD>(0, 1), Mobility::fixed), Status::ok);
  EXPECT_EQ(this->table.size(), 1U);
  EXPECT_EQ(this->table.bound(), 4U);
  EXPECT_TRUE(this->table.is_placed({3}));
  EXPECT_TRUE(this->table.is_fixed({3}));
  EXPECT_EQ(this->table.box({3}), slab<kD>(0, 1));
  EXPECT_EQ(this->table.move({3}, slab<kD>(2, 3)), Status::ok);
  EXPECT_EQ(this->table.box({3}), slab<kD>(2, 3));
  EXPECT_TRUE(this->table.is_fixed({3}));
  EXPECT_EQ(this->table.remove({3}), Status::ok);
  EXPECT_EQ(this->table.state({3}), ObjectState::absent);
  EXPECT_EQ(this->table.size(), 0U);
}

TYPED_TEST(ObjectTable, AnswersUnknownAndDuplicateIdsAndDoesNothing) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(this->table.move({0}, slab<kD>(0, 1)), Status::unknown_id);
  EXPECT_EQ(this->table.remove({0}), Status::unknown_id);
  EXPECT_EQ(this->table.insert(ObjectId::none(), slab<kD>(0, 1), Mobility::moving), Status::unknown_id);
  ASSERT_EQ(this->table.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  EXPECT_EQ(this->table.insert({0}, slab<kD>(5, 6), Mobility::fixed), Status::duplicate_id);
  EXPECT_EQ(this->table.box({0}), slab<kD>(0, 1));
  EXPECT_FALSE(this->table.is_fixed({0}));
  ASSERT_EQ(this->table.remove({0}), Status::ok);
  EXPECT_EQ(this->table.remove({0}), Status::unknown_id) << "double remove";
  EXPECT_EQ(this->table.insert({0}, slab<kD>(5, 6), Mobility::fixed), Status::ok) << "an id used again";
  EXPECT_EQ(this->table.size(), 1U);
}

TYPED_TEST(ObjectTable, QuarantinesNanAndInvertedBoxesUntilAValidOneComes) {
  constexpr int kD = TypeParam::value;
  for (int axis = 0; axis < kD; ++axis) {
    for (const Box<kD>& bad : {slab<kD>(kNan, 1, axis), slab<kD>(0, kNan, axis), slab<kD>(1, 0, axis),
                               slab<kD>(kInfinity, -kInfinity, axis)}) {
      kerf::ObjectTable<kD> fresh;
      EXPECT_EQ(fresh.insert({0}, bad, Mobility::moving), Status::quarantined);
      EXPECT_EQ(fresh.state({0}), ObjectState::quarantined);
      EXPECT_FALSE(fresh.is_placed({0}));
      EXPECT_EQ(fresh.size(), 1U);
      EXPECT_EQ(fresh.insert({0}, slab<kD>(0, 1), Mobility::moving), Status::duplicate_id);
      EXPECT_EQ(fresh.move({0}, slab<kD>(0, 1)), Status::ok);
      EXPECT_TRUE(fresh.is_placed({0}));
      EXPECT_EQ(fresh.move({0}, bad), Status::quarantined);
      EXPECT_EQ(fresh.remove({0}), Status::ok);
      EXPECT_EQ(fresh.size(), 0U);
    }
  }
}

TYPED_TEST(ObjectTable, ClampsInfiniteBounds) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(this->table.insert({0}, slab<kD>(-kInfinity, kInfinity), Mobility::moving), Status::clamped);
  EXPECT_EQ(this->table.box({0}), slab<kD>(-kMax, kMax));
  EXPECT_EQ(this->table.move({0}, slab<kD>(kInfinity, kInfinity)), Status::clamped);
  EXPECT_EQ(this->table.box({0}), slab<kD>(kMax, kMax));
  EXPECT_EQ(this->table.move({0}, slab<kD>(-kMax, kMax)), Status::ok) << "the largest floats are finite";
}

TEST(StatusNames, AreAllDifferent) {
  EXPECT_EQ(to_string(Status::ok), "ok");
  EXPECT_EQ(to_string(Status::clamped), "clamped");
  EXPECT_EQ(to_string(Status::quarantined), "quarantined");
  EXPECT_EQ(to_string(Status::unknown_id), "unknown id");
  EXPECT_EQ(to_string(Status::duplicate_id), "duplicate id");
}

template <class T>
class BruteForce : public testing::Test {};
TYPED_TEST_SUITE(BruteForce, Dimensions, DimensionNames);

TYPED_TEST(BruteForce, ReportsEachOverlapOnceInOrder) {
  constexpr int kD = TypeParam::value;
  kerf::BruteForce<kD> oracle;
  for (std::uint32_t k : {4U, 0U, 2U})  // ids may come in any order and leave gaps
    ASSERT_EQ(
        oracle.insert({k}, slab<kD>(static_cast<Scalar>(k), static_cast<Scalar>(k) + 2), Mobility::moving),
        Status::ok);
  oracle.step();
  EXPECT_EQ(difference(oracle.pairs(), std::vector<Pair>{{{0}, {2}}, {{2}, {4}}}), "") << "touching counts";
  ASSERT_EQ(oracle.remove({2}), Status::ok);
  oracle.step();
  EXPECT_TRUE(oracle.pairs().empty());
}

TYPED_TEST(BruteForce, LeavesOutFixedPairsAndTheQuarantined) {
  constexpr int kD = TypeParam::value;
  kerf::BruteForce<kD> oracle;
  ASSERT_EQ(oracle.insert({0}, slab<kD>(0, 1), Mobility::fixed), Status::ok);
  ASSERT_EQ(oracle.insert({1}, slab<kD>(0, 1), Mobility::fixed), Status::ok);
  ASSERT_EQ(oracle.insert({2}, slab<kD>(0, 1), Mobility::moving), Status::ok);
  ASSERT_EQ(oracle.insert({3}, slab<kD>(1, 0), Mobility::moving), Status::quarantined);
  oracle.step();
  EXPECT_EQ(difference(oracle.pairs(), std::vector<Pair>{{{0}, {2}}, {{1}, {2}}}), "");
}

TEST(PairDifference, NamesWhatIsMissedInventedAndReportedAgain) {
  const std::vector<Pair> expected{{{1}, {2}}, {{3}, {4}}};
  EXPECT_EQ(difference(expected, expected), "");
  EXPECT_EQ(difference(std::vector<Pair>{{{3}, {4}}, {{1}, {2}}}, expected), "") << "any order";
  EXPECT_EQ(difference(std::vector<Pair>{{{1}, {2}}, {{1}, {2}}, {{5}, {6}}}, expected),
            "2 pairs expected; 1 missed: 3-4; 1 invented: 5-6; 1 reported again: 1-2");
  EXPECT_FALSE(same_pairs({}, expected));
}

}  // namespace
}  // namespace kerf::test
