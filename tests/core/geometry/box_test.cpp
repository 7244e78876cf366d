#include "core/geometry/box.h"

#include <gtest/gtest.h>

#include <bit>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
constexpr Scalar kTiny = std::numeric_limits<Scalar>::denorm_min();
constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
class BoxOverlap : public testing::Test {};
TYPED_TEST_SUITE(BoxOverlap, Dimensions, DimensionNames);

TYPED_TEST(BoxOverlap, TouchCountsAndOneUlpBesideDoesNot) {
  constexpr int kD = TypeParam::value;
  for (int axis = 0; axis < kD; ++axis) {
    const Box<kD> left = slab<kD>(0, 1, axis);
    EXPECT_TRUE(overlaps(left, slab<kD>(1, 2, axis)));
    EXPECT_TRUE(overlaps(slab<kD>(1, 2, axis), left));
    EXPECT_FALSE(overlaps(left, slab<kD>(std::nextafter(1.0F, 2.0F), 2, axis)));
    EXPECT_FALSE(overlaps(slab<kD>(std::nextafter(1.0F, 2.0F), 2, axis), left));
    EXPECT_TRUE(overlaps(left, slab<kD>(std::nextafter(1.0F, 0.0F), 2, axis)));
  }
}

TYPED_TEST(BoxOverlap, NeedsEveryAxis) {
  constexpr int kD = TypeParam::value;
  const Box<kD> unit{all<kD>(0), all<kD>(1)};
  for (int axis = 0; axis < kD; ++axis) {
    Box<kD> beside = unit;
    beside.min[axis] = 5;
    beside.max[axis] = 6;
    EXPECT_FALSE(overlaps(unit, beside)) << "axis " << axis;
  }
  EXPECT_TRUE(overlaps(unit, unit));
}

TYPED_TEST(BoxOverlap, PointsPlatesAndZerosOfEitherSignTouch) {
  constexpr int kD = TypeParam::value;
  const Box<kD> origin{all<kD>(0), all<kD>(0)};
  const Box<kD> negative{all<kD>(-0.0F), all<kD>(-0.0F)};
  EXPECT_TRUE(overlaps(origin, negative));
  EXPECT_TRUE(overlaps(origin, Box<kD>{all<kD>(-1), all<kD>(-0.0F)}));
  EXPECT_TRUE(overlaps(origin, slab<kD>(0, 0)));
  EXPECT_FALSE(overlaps(origin, slab<kD>(kTiny, kTiny)));
}

TYPED_TEST(BoxOverlap, ReachesToTheLargestFloats) {
  constexpr int kD = TypeParam::value;
  const Box<kD> everything{all<kD>(-kMax), all<kD>(kMax)};
  EXPECT_TRUE(overlaps(everything, Box<kD>{all<kD>(kMax), all<kD>(kMax)}));
  EXPECT_TRUE(is_finite(everything.center()));
}

TYPED_TEST(BoxOverlap, JoinHoldsBothAndTheEmptyBoxAddsNothing) {
  constexpr int kD = TypeParam::value;
  const Box<kD> a = slab<kD>(0, 1);
  const Box<kD> b = slab<kD>(4, 7);
  EXPECT_EQ(join(a, b), slab<kD>(0, 7));
  EXPECT_EQ(join(Box<kD>::empty(), b), b);
  EXPECT_TRUE(contains(join(a, b), a));
  EXPECT_TRUE(contains(a, a));
  EXPECT_FALSE(contains(a, b));
  EXPECT_FALSE(contains(a, join(a, b)));
}

TYPED_TEST(BoxOverlap, ValidMeansFiniteAndOrdered) {
  constexpr int kD = TypeParam::value;
  for (int axis = 0; axis < kD; ++axis) {
    EXPECT_TRUE(is_valid(slab<kD>(2, 2, axis)));
    EXPECT_FALSE(is_valid(slab<kD>(3, 2, axis)));
    EXPECT_FALSE(is_valid(slab<kD>(kNan, 2, axis)));
    EXPECT_FALSE(is_valid(slab<kD>(0, kNan, axis)));
    EXPECT_FALSE(is_valid(slab<kD>(0, std::numeric_limits<Scalar>::infinity(), axis)));
  }
}

TEST(RoundOutward, KeepsDoublesThatAreFloats) {
  for (const double x : {0.0, 1.0, -2.5, double{kMax}, -double{kMax}, double{kTiny}, -double{kTiny}}) {
    EXPECT_EQ(round_down(x), x);
    EXPECT_EQ(round_up(x), x);
  }
}

TEST(RoundOutward, TakesTheNeighbouringFloats) {
  Random random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random.bits());
    const Scalar f = std::bit_cast<Scalar>(bits);
    if (!std::isfinite(f) || std::abs(f) >= kMax) continue;
    const double x = f + (double{std::nextafter(f, kMax)} - f) * random.uniform(0.01, 0.99);
    ASSERT_EQ(round_down(x), f) << x;
    ASSERT_EQ(round_up(x), std::nextafter(f, kMax)) << x;
  }
}

TEST(RoundOutward, StaysWithinTheFiniteRange) {
  for (const double x : {1e39, 1e300, kInfinity}) {
    EXPECT_EQ(round_down(x), kMax);
    EXPECT_EQ(round_up(x), kMax);
    EXPECT_EQ(round_down(-x), -kMax);
    EXPECT_EQ(round_up(-x), -kMax);
  }
}

TEST(RoundOutward, KeepsTheSmallestDoublesApartFromZero) {
  EXPECT_EQ(round_down(1e-320), 0);
  EXPECT_EQ(round_up(1e-320), kTiny);
  EXPECT_EQ(round_down(-1e-320), -kTiny);
  EXPECT_EQ(round_up(-1e-320), 0);
}

TEST(RoundOutward, LeavesNanToTheQuarantine) {
  EXPECT_TRUE(std::isnan(round_down(std::nan(""))));
  EXPECT_TRUE(std::isnan(round_up(std::nan(""))));
}

}  // namespace
}  // namespace kerf::test
