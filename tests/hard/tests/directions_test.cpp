// S11 and S12: directions and offsets that are poor or none.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/bsp/bsp.h"
#include "core/geometry/direction_set.h"
#include "core/tree/partitioner.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
constexpr Scalar kNan = std::numeric_limits<Scalar>::quiet_NaN();

template <class T>
class HardDirections : public testing::Test {};
TYPED_TEST_SUITE(HardDirections, Dimensions, DimensionNames);

/// A box, and one that touches it or reaches into it by some ulps, at any scale.
template <int D>
std::pair<Box<D>, Box<D>> touching(Random& random) {
  const auto scale = std::ldexp(1.0F, static_cast<int>(random.below(60)) - 30);
  const Box<D> a = random_box<D>(random, 100, 2);
  const Vector<D> extent = random_point<D>(random, 0, 2);
  Box<D> b{a.max, a.max + extent};
  const auto axis = static_cast<int>(random.below(D));
  b.min[axis] = std::nextafter(b.min[axis], -kMax);
  return {{a.min * scale, a.max * scale}, {b.min * scale, b.max * scale}};
}

TYPED_TEST(HardDirections, S11_PoorDirectionsSeparateNoPair) {
  constexpr int kD = TypeParam::value;
  Random random(11);
  for (int round = 0; round < 20000; ++round) {
    const auto [a, b] = touching<kD>(random);
    ASSERT_TRUE(overlaps(a, b));
    // Nearly along an axis, far from length one, or with parts that are lost in the sum.
    Vector<kD> normal = random_point<kD>(random, -1, 1);
    const std::uint32_t way = random.below(4);
    for (int axis = 0; axis < kD; ++axis) {
      if (way == 0 && axis > 0) normal[axis] *= 1e-6F;
      if (way == 1 && axis > 0) normal[axis] *= 1e-30F;
      if (way == 2) normal[axis] *= 1e-20F;
      if (way == 3) normal[axis] = normal[0];  // a duplicate of the diagonal
    }
    const Interval of_a = project(normal, a);
    const Interval of_b = project(normal, b);
    ASSERT_TRUE(of_a.lo <= of_b.hi && of_b.lo <= of_a.hi);
    for (const Scalar offset : {of_a.lo, of_a.hi, of_b.lo, of_b.hi}) {
      const Sides side_a = classify(of_a, offset);
      const Sides side_b = classify(of_b, offset);
      ASSERT_TRUE((side_a.left && side_b.left) || (side_a.right && side_b.right));
    }
  }
}

TYPED_TEST(HardDirections, S12_TheSetHoldsNoZeroNoNanAndNothingBeyondOne) {
  constexpr int kD = TypeParam::value;
  for (const std::uint32_t size : {3U, 4U, 7U, 64U, 200U}) {
    const DirectionSet<kD> set(size, 5);
    for (const Vector<kD>& direction : set.all()) {
      ASSERT_TRUE(is_finite(direction));
      ASSERT_NEAR(length(direction), 1, 1e-6);
      for (int axis = 0; axis < kD; ++axis) ASSERT_LE(std::abs(direction[axis]), 1);
    }
  }
}

TYPED_TEST(HardDirections, S12_AxesThatAreNoneAreQuarantined) {
  constexpr int kD = TypeParam::value;
  auto axes = identity_axes<kD>();
  Bsp<kD> bsp({}, VolumeKind::oriented_box);
  const auto answer = [&](std::uint32_t object) {
    return bsp.insert({object}, make_oriented_box<kD>(all<kD>(0), axes, all<kD>(1)), Mobility::moving);
  };
  EXPECT_EQ(answer(0), Status::ok);
  axes[0] = {};
  EXPECT_EQ(answer(1), Status::quarantined) << "zero";
  axes[0] = all<kD>(kNan);
  EXPECT_EQ(answer(2), Status::quarantined) << "NaN";
  axes[0] = axes[1];
  EXPECT_EQ(answer(3), Status::quarantined) << "a duplicate";
  axes = identity_axes<kD>();
  axes[0] = axes[0] * 2;
  EXPECT_EQ(answer(4), Status::quarantined) << "too long";
  bsp.step();
  EXPECT_EQ(bsp.statistics().objects, 1U);
}

/// Gaps between infinite or extreme projections give no infinite or NaN offset.
TEST(HardOffsets, S12_NoOffsetIsInfinite) {
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  Config config;
  config.max_redundancy = 1;
  config.min_balance = 0.1F;
  const std::vector<std::vector<Interval>> rows{
      {{-kInfinity, -kInfinity}, {-kInfinity, -kInfinity}, {kInfinity, kInfinity}, {kInfinity, kInfinity}},
      {{-kInfinity, kInfinity}, {-kInfinity, kInfinity}},
      {{-kMax, -kMax}, {kMax, kMax}},
      {{-kMax, -kMax}, {-kMax, 0}, {kMax, kInfinity}, {kInfinity, kInfinity}},
      {{kInfinity, kInfinity}, {kMax, kMax}, {kMax, kMax}, {kInfinity, kInfinity}}};
  for (const std::vector<Interval>& row : rows) {
    const auto point = best_reference_point(row, config);
    if (!point) continue;
    EXPECT_TRUE(std::isfinite(point->offset));
    EXPECT_EQ(point->quality, measure(row, point->offset));
  }
}

}  // namespace
}  // namespace kerf::test
