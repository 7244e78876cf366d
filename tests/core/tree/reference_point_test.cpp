#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/tree/partitioner.h"
#include "tests/support/config_of.h"

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();

/// The best score of any good offset, found by trying every end of an interval: between two of them nothing
/// changes. Less than any score if no offset is good.
float best_score(const std::vector<Interval>& intervals, const Config& config) {
  float best = -2;
  for (const Interval& interval : intervals) {
    for (const Scalar offset : {interval.lo, interval.hi}) {
      const Quality quality = measure(intervals, offset);
      if (std::isfinite(offset) && is_good(quality, config)) best = std::max(best, score(quality));
    }
  }
  return best;
}

std::string text_of(const std::vector<Interval>& intervals) {
  std::string text;
  for (const Interval& interval : intervals)
    text += "[" + std::to_string(interval.lo) + ", " + std::to_string(interval.hi) + "] ";
  return text;
}

/// Whether no gap below the point's scores as much.
bool is_lowest(const ReferencePoint& point, const std::vector<Interval>& intervals, const Config& config) {
  const auto is_as_good = [&](Scalar offset) {
    const Quality quality = measure(intervals, offset);
    return std::isfinite(offset) && offset < point.offset && quality != point.quality &&
           is_good(quality, config) && score(quality) == score(point.quality);
  };
  return std::ranges::none_of(intervals, is_as_good, &Interval::lo) &&
         std::ranges::none_of(intervals, is_as_good, &Interval::hi);
}

void expect_best(const std::vector<Interval>& intervals, const Config& config) {
  const auto point = best_reference_point(intervals, config);
  const float expected = best_score(intervals, config);
  ASSERT_EQ(point.has_value(), expected > -2) << text_of(intervals);
  if (!point) return;
  ASSERT_TRUE(std::isfinite(point->offset)) << text_of(intervals);
  ASSERT_EQ(point->quality, measure(intervals, point->offset)) << text_of(intervals) << point->offset;
  ASSERT_TRUE(is_good(point->quality, config)) << text_of(intervals);
  ASSERT_EQ(score(point->quality), expected) << text_of(intervals) << point->offset;
  ASSERT_TRUE(is_lowest(*point, intervals, config)) << text_of(intervals) << point->offset;
}

constexpr const char* kCriteria[] = {"", "max_redundancy=0.4", "min_balance=0,max_redundancy=1",
                                     "min_balance=0.9,max_redundancy=0.2", "min_balance=1,max_redundancy=0"};

class ReferencePointSearch : public testing::TestWithParam<const char*> {};

TEST_P(ReferencePointSearch, FindsTheBestOfAllOffsets) {
  const Config config = config_of(GetParam());
  Random random(3);
  for (int round = 0; round < 20'000; ++round) {
    const std::uint32_t count = random.below(60);
    const double longest = random.uniform(0, 3);
    std::vector<Interval> intervals(count);
    for (Interval& interval : intervals) {
      interval.lo = static_cast<Scalar>(random.uniform(0, 100));
      interval.hi = interval.lo + static_cast<Scalar>(random.uniform(0, longest));
    }
    ASSERT_NO_FATAL_FAILURE(expect_best(intervals, config));
  }
}

TEST_P(ReferencePointSearch, FindsTheBestAmongTiesTouchesAndCoincidence) {
  const Config config = config_of(GetParam());
  Random random(4);
  for (int round = 0; round < 50'000; ++round) {
    std::vector<Interval> intervals(random.below(12));
    for (Interval& interval : intervals) {
      interval.lo = static_cast<Scalar>(random.below(6));
      interval.hi = interval.lo + static_cast<Scalar>(random.below(3));
      if (interval.lo == 0 && random.below(2) == 0) interval.lo = -0.0F;
      if (interval.hi == 0 && random.below(2) == 0) interval.hi = -0.0F;
    }
    ASSERT_NO_FATAL_FAILURE(expect_best(intervals, config));
  }
}

TEST_P(ReferencePointSearch, FindsTheBestAmongNeighbouringFloatsAndOverflows) {
  const Config config = config_of(GetParam());
  Random random(5);
  const Scalar one_up = std::nextafter(1.0F, 2.0F);
  const Scalar two_up = std::nextafter(one_up, 2.0F);
  const Scalar tiny = std::numeric_limits<Scalar>::denorm_min();
  const std::vector<Scalar> ends{-kInfinity, -kMax,    -1,   -tiny,  -0.0F,  0.0F,
                                 tiny,       2 * tiny, 1.0F, one_up, two_up, std::nextafter(kMax, 0.0F),
                                 kMax,       kInfinity};
  for (int round = 0; round < 50'000; ++round) {
    std::vector<Interval> intervals(random.below(10));
    for (Interval& interval : intervals) {
      const Scalar p = ends[random.below(static_cast<std::uint32_t>(ends.size()))];
      const Scalar q = ends[random.below(static_cast<std::uint32_t>(ends.size()))];
      interval = {std::min(p, q), std::max(p, q)};
    }
    ASSERT_NO_FATAL_FAILURE(expect_best(intervals, config));
  }
}

INSTANTIATE_TEST_SUITE_P(AllCriteria, ReferencePointSearch, testing::ValuesIn(kCriteria));

TEST(ReferencePoint, LiesInTheMiddleOfTheGap) {
  const std::vector<Interval> intervals{{0, 1}, {0, 2}, {6, 7}, {8, 9}};
  const auto point = best_reference_point(intervals, Config{});
  ASSERT_TRUE(point);
  EXPECT_EQ(point->offset, 4);
  EXPECT_EQ(point->quality, (Quality{4, 2, 2}));
}

// The middle of two neighbouring floats rounds to the even one: to either end of the gap (HARD_CASES S5).
TEST(ReferencePoint, DividesBetweenNeighbouringFloats) {
  const Scalar even = 1;
  const Scalar odd = std::nextafter(even, 2.0F);
  const Scalar next_even = std::nextafter(odd, 2.0F);
  for (const auto& [low, high] : {std::pair{even, odd}, std::pair{odd, next_even}}) {
    const std::vector<Interval> intervals{{low, low}, {high, high}};
    const auto point = best_reference_point(intervals, Config{});
    ASSERT_TRUE(point);
    EXPECT_EQ(point->offset, low);
    EXPECT_EQ(measure(intervals, point->offset), (Quality{2, 1, 1}));
  }
}

TEST(ReferencePoint, TouchingObjectsAreDividedAtTheTouch) {
  const std::vector<Interval> intervals{{0, 1}, {1, 2}};
  EXPECT_FALSE(best_reference_point(intervals, Config{})) << "at 1 the second is on both sides";
  const auto point = best_reference_point(intervals, config_of("min_balance=0.5,max_redundancy=0.5"));
  EXPECT_FALSE(point) << "the first child would not shrink";
}

TEST(ReferencePoint, DoesNotOverflowBetweenTheLargestFloats) {
  const std::vector<Interval> intervals{{-kMax, -kMax}, {kMax, kMax}};
  const auto point = best_reference_point(intervals, Config{});
  ASSERT_TRUE(point);
  EXPECT_EQ(point->offset, 0);
}

TEST(ReferencePoint, IsNeverInfinite) {
  const std::vector<Interval> apart{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  EXPECT_FALSE(best_reference_point(apart, Config{}));
  const std::vector<Interval> overflowing{{-kInfinity, 1}, {2, kInfinity}};
  const auto point = best_reference_point(overflowing, Config{});
  ASSERT_TRUE(point);
  EXPECT_EQ(point->offset, 1.5F);
}

// Only ends of objects were tried, so that a better or the only good point behind a beginning was not found.
TEST(ReferencePoint, MayLieWhereAnObjectBegins) {
  const std::vector<Interval> intervals{{0, 1}, {2, 10}, {3, 11}, {12, 13}};
  const auto point = best_reference_point(intervals, config_of("max_redundancy=0.5"));
  ASSERT_TRUE(point);
  EXPECT_EQ(point->quality, (Quality{4, 3, 3}));
  EXPECT_GE(point->offset, 3);
  EXPECT_LT(point->offset, 10);
  EXPECT_TRUE(best_reference_point(intervals, config_of("max_redundancy=0.5,min_balance=1")));
}

TEST(ReferencePoint, OrderOfTheIntervalsDoesNotMatter) {
  Random random(6);
  std::vector<Interval> intervals(50);
  for (Interval& interval : intervals) {
    interval.lo = static_cast<Scalar>(random.uniform(0, 100));
    interval.hi = interval.lo + 0.1F;
  }
  const auto shuffled = best_reference_point(intervals, Config{});
  std::sort(intervals.begin(), intervals.end(), [](Interval a, Interval b) { return a.lo < b.lo; });
  const auto ordered = best_reference_point(intervals, Config{});
  ASSERT_TRUE(ordered);
  EXPECT_EQ(shuffled->offset, ordered->offset);
}

TEST(ReferencePoint, NothingIsGoodAmongNoneOneOrEqualIntervals) {
  const Config lax = config_of("min_balance=0,max_redundancy=1");
  EXPECT_FALSE(best_reference_point({}, lax));
  EXPECT_FALSE(best_reference_point(std::vector<Interval>{{0, 1}}, lax));
  EXPECT_FALSE(best_reference_point(std::vector<Interval>(9, {0, 1}), lax));
}

/// More than 32 times the sample of 4; the k-th four of them at `of_sample`, all others at `others`.
std::vector<Interval> crowd(const std::vector<Scalar>& of_sample, Scalar others) {
  std::vector<Interval> intervals;
  for (std::size_t k = 0; k < 400; ++k) {
    const Scalar low = k % 100 == 0 ? of_sample[k / 100] : others + 0.01F * static_cast<Scalar>(k);
    intervals.push_back({low, low + 0.001F});
  }
  return intervals;
}

TEST(GoodReferencePoint, OfManyObjectsIsThatOfASampleJudgedOnAll) {
  const std::vector<Interval> intervals = crowd({1, 1.5F, 3, 3.5F}, 0.1F);
  const auto point = good_reference_point(intervals, config_of("sample=4,min_balance=0.3"));
  ASSERT_TRUE(point);
  EXPECT_GT(point->offset, 1.5F);
  EXPECT_LT(point->offset, 3.0F);
  EXPECT_EQ(point->quality, measure(intervals, point->offset));
  EXPECT_EQ(point->quality.population, 400U);
}

TEST(GoodReferencePoint, IsThatOfAllIfTheSamplesIsNotGood) {
  const std::vector<Interval> intervals = crowd({1, 2, 3, 4}, 10);
  const Config config = config_of("sample=4,min_balance=0.5");
  const auto point = good_reference_point(intervals, config);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->offset, best_reference_point(intervals, config)->offset);
}

TEST(GoodReferencePoint, OfFewObjectsIsThatOfAll) {
  std::vector<Interval> intervals = crowd({1, 1.5F, 3, 3.5F}, 0.1F);
  intervals.resize(128);
  const Config config = config_of("sample=4,min_balance=0.3");
  const auto point = good_reference_point(intervals, config);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->offset, best_reference_point(intervals, config)->offset);
}

}  // namespace
}  // namespace kerf::test
