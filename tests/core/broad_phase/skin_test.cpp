#include "core/broad_phase/skin.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <int D>
Box<D> cube(Scalar low, Scalar high) {
  Box<D> box;
  for (int i = 0; i < D; ++i) {
    box.min[i] = low;
    box.max[i] = high;
  }
  return box;
}

template <int D>
Box<D> moved(Box<D> box, int axis, Scalar by) {
  box.min[axis] += by;
  box.max[axis] += by;
  return box;
}

template <class T>
class Skins : public testing::Test {};
TYPED_TEST_SUITE(Skins, Dimensions, DimensionNames);

TYPED_TEST(Skins, WhatStandsStillGetsNoFat) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(fatten(cube<kD>(0, 1), cube<kD>(0, 1), Skin{}, 8), cube<kD>(0, 1));
}

TYPED_TEST(Skins, TheFatBoxHoldsTheWayAhead) {
  constexpr int kD = TypeParam::value;
  const Box<kD> before = cube<kD>(0, 1);
  Box<kD> box = moved(before, 0, 0.05F);
  const Box<kD> fat = fatten(box, before, Skin{}, 8);
  for (int step = 0; step <= 8; ++step, box = moved(box, 0, 0.05F)) EXPECT_TRUE(contains(fat, box)) << step;
  EXPECT_FALSE(contains(fat, moved(before, 0, -0.1F))) << "nothing is spent on the way back";
}

TYPED_TEST(Skins, NoFatIsThickerThanTheObjectAheadOrAround) {
  constexpr int kD = TypeParam::value;
  const Box<kD> fat = fatten(moved(cube<kD>(0, 1), 0, 100), cube<kD>(0, 1), Skin{}, 1000);
  EXPECT_LE(fat.max[0], 103.0F);
  EXPECT_GE(fat.min[0], 99.0F);
}

TYPED_TEST(Skins, WhatWouldOverflowStaysAsItIs) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kMax = std::numeric_limits<Scalar>::max();
  EXPECT_EQ(fatten(cube<kD>(-kMax, kMax), cube<kD>(-kMax / 2, kMax), Skin{}, 8), cube<kD>(-kMax, kMax));
  const Box<kD> fat = fatten(cube<kD>(kMax / 2, kMax), cube<kD>(-kMax, kMax), Skin{}, 0);
  EXPECT_TRUE(is_valid(fat));
  EXPECT_TRUE(contains(fat, cube<kD>(kMax / 2, kMax)));
}

TEST(Skin, GrowsForWhoLeavesSoonAndThinsForWhoStaysLong) {
  Skin skin;
  const std::uint8_t first = skin.level;
  skin.since = 100;
  skin.left(105);
  EXPECT_EQ(skin.level, first + 1);
  EXPECT_EQ(skin.since, 105);
  skin.left(405);
  EXPECT_EQ(skin.level, first);
  for (std::uint32_t step = 406; step < 440; ++step) skin.left(step);
  EXPECT_EQ(skin.level, Skin::kThickest);
  EXPECT_FLOAT_EQ(skin.thickness(8), 2);
  skin.since = 65530;
  skin.left(65540);  // the count begins anew at 65,536
  EXPECT_EQ(skin.since, 4);
}

}  // namespace
}  // namespace kerf::test
