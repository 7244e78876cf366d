#include "core/objects/skin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr Skin kUsual{.level = 5};  // a sixteenth of an object's size

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
  EXPECT_EQ(fatten(cube<kD>(0, 1), cube<kD>(0, 1), kUsual, 8, 1), cube<kD>(0, 1));
}

TYPED_TEST(Skins, TheFatBoxHoldsTheWayAhead) {
  constexpr int kD = TypeParam::value;
  const Box<kD> before = cube<kD>(0, 1);
  Box<kD> box = moved(before, 0, 0.05F);
  const Box<kD> fat = fatten(box, before, kUsual, 8, 1);
  for (int step = 0; step <= 8; ++step, box = moved(box, 0, 0.05F)) EXPECT_TRUE(contains(fat, box)) << step;
  EXPECT_FALSE(contains(fat, moved(before, 0, -0.1F))) << "nothing is spent on the way back";
}

TYPED_TEST(Skins, NoFatIsThickerThanTheObjectAheadOrAround) {
  constexpr int kD = TypeParam::value;
  const Box<kD> fat = fatten(moved(cube<kD>(0, 1), 0, 0.12F), cube<kD>(0, 1), kUsual, 1000, 1);
  EXPECT_LE(fat.max[0], 2.25F);
  EXPECT_GE(fat.min[0], -0.01F);
}

TYPED_TEST(Skins, ARodGetsASkinForItsThickness) {
  constexpr int kD = TypeParam::value;
  for (int axis = 0; axis < kD; ++axis) {
    Box<kD> rod = cube<kD>(0, 1);
    rod.max[axis] = 100;
    const Box<kD> fat = wrap(rod, kUsual);
    for (int i = 0; i < kD; ++i) EXPECT_EQ(fat.max[i] - rod.max[i], kUsual.thickness(1)) << axis;
    EXPECT_TRUE(size_and_speed(moved(rod, axis, 0.13F), rod).is_fast()) << axis;
    EXPECT_FALSE(size_and_speed(moved(rod, axis, 0.12F), rod).is_fast()) << axis;
  }
}

TYPED_TEST(Skins, WhatMovesByMoreThanASkinGetsNoFat) {
  constexpr int kD = TypeParam::value;
  for (const Scalar by : {0.13F, 100.0F}) {
    const Box<kD> there = moved(cube<kD>(0, 1), 0, by);
    EXPECT_EQ(fatten(there, cube<kD>(0, 1), kUsual, 8, 1), there);
  }
}

TYPED_TEST(Skins, FastIsWhatMovesByMoreThanTheThickestSkin) {
  constexpr int kD = TypeParam::value;
  EXPECT_TRUE(size_and_speed(moved(cube<kD>(0, 1), kD - 1, 0.126F), cube<kD>(0, 1)).is_fast());
  EXPECT_FALSE(size_and_speed(moved(cube<kD>(0, 1), kD - 1, 0.124F), cube<kD>(0, 1)).is_fast());
  EXPECT_TRUE(size_and_speed(cube<kD>(1, 1), cube<kD>(0, 0)).is_fast()) << "a point";
  EXPECT_FALSE(size_and_speed(cube<kD>(1, 1), cube<kD>(1, 1)).is_fast()) << "a point at rest";
}

TYPED_TEST(Skins, AShareOfTheWayAheadIsGivenAndTheNextStepAlways) {
  constexpr int kD = TypeParam::value;
  const Box<kD> before = cube<kD>(0, 1);
  const Box<kD> box = moved(before, 0, 0.05F);
  const Box<kD> all = fatten(box, before, kUsual, 8, 1);
  const Box<kD> half = fatten(box, before, kUsual, 8, 0.5F);
  EXPECT_TRUE(contains(all, half));
  EXPECT_NEAR(half.max[0] - box.max[0], 0.0625F + 0.2F, 1e-5F);
  EXPECT_TRUE(contains(half, before)) << "back by a step, too";
}

TYPED_TEST(Skins, OnlyTheFatOfAFlightIsThickerThanAnySkin) {
  constexpr int kD = TypeParam::value;
  Skin thick;
  thick.level = Skin::kThickest;
  const Box<kD> before = cube<kD>(0, 1);
  const Box<kD> crept = moved(before, 0, 1e-6F);
  const Box<kD> flew = moved(before, 0, 0.1F);
  EXPECT_FALSE(is_for_flight(fatten(crept, before, thick, 8, 1), crept));
  EXPECT_TRUE(is_for_flight(fatten(flew, before, thick, 8, 1), flew));
}

TYPED_TEST(Skins, AWrapIsAsThickAsTheSkinOnEverySide) {
  constexpr int kD = TypeParam::value;
  EXPECT_EQ(wrap(cube<kD>(0, 16), kUsual), cube<kD>(-1, 17));
  constexpr Scalar kEnd = std::numeric_limits<Scalar>::max();
  EXPECT_EQ(wrap(cube<kD>(0, kEnd), kUsual), cube<kD>(0, kEnd));
}

TEST(Skin, WhatLeavesSoonAfterBeingWrappedIsLeftInPeaceTwiceAsLong) {
  Skin skin;
  constexpr std::uint32_t kRest = tuning::kRestSteps;
  skin.left(10, true);
  EXPECT_FALSE(skin.is_at_rest(10 + kRest - 1));
  EXPECT_TRUE(skin.is_at_rest(10 + kRest));
  skin.wrap(2000);
  skin.left(2002, true);
  EXPECT_FALSE(skin.is_at_rest(2002 + 2 * kRest - 1));
  EXPECT_TRUE(skin.is_at_rest(2002 + 2 * kRest));
  skin.wrap(5000);
  skin.left(5300, true);
  EXPECT_TRUE(skin.is_at_rest(5300 + kRest)) << "it rested for long";
}

TEST(Skin, WhatWasFastIsRestlessUntilItWasSlowForSomeSteps) {
  Skin skin;
  EXPECT_FALSE(skin.is_restless());
  skin.moved(true);
  for (int slow = 1; slow < Skin::kRestless; ++slow) skin.moved(false);
  EXPECT_TRUE(skin.is_restless());
  skin.moved(true);
  for (int slow = 1; slow <= Skin::kRestless; ++slow) skin.moved(false);
  EXPECT_FALSE(skin.is_restless());
  skin.moved(false);
  EXPECT_FALSE(skin.is_restless());
}

TEST(Skin, SharesLieBetweenAThirdAndOneAndDifferBetweenNeighbours) {
  float least = 1;
  float most = 0;
  for (std::uint32_t object = 0; object < 1000; ++object) {
    least = std::min(least, fat_share(object));
    most = std::max(most, fat_share(object));
    EXPECT_GT(std::abs(fat_share(object) - fat_share(object + 1)), 0.1F);
  }
  EXPECT_GE(least, 1.0F / 3);
  EXPECT_LT(least, 0.35F);
  EXPECT_LE(most, 1);
  EXPECT_GT(most, 0.98F);
}

TYPED_TEST(Skins, WhatWouldOverflowStaysAsItIs) {
  constexpr int kD = TypeParam::value;
  constexpr Scalar kEnd = std::numeric_limits<Scalar>::max();
  EXPECT_EQ(fatten(cube<kD>(-kEnd, kEnd), cube<kD>(-kEnd / 2, kEnd), kUsual, 8, 1), cube<kD>(-kEnd, kEnd));
  const Box<kD> fat = fatten(cube<kD>(kEnd / 2, kEnd), cube<kD>(-kEnd, kEnd), kUsual, 0, 1);
  EXPECT_TRUE(is_valid(fat));
  EXPECT_TRUE(contains(fat, cube<kD>(kEnd / 2, kEnd)));
}

TEST(Skin, GrowsIfItIsLeftSoonAndThinsIfItLasts) {
  Skin skin = kUsual;
  const std::uint8_t first = skin.level;
  skin.since = 100;
  skin.left(105, true);
  EXPECT_EQ(skin.level, first + 1);
  EXPECT_EQ(skin.since, 105);
  skin.left(405, true);
  EXPECT_EQ(skin.level, first);
  for (std::uint32_t step = 406; step < 440; ++step) skin.left(step, true);
  EXPECT_EQ(skin.level, Skin::kThickest);
  EXPECT_FLOAT_EQ(skin.thickness(8), 1);
  skin.since = 65530;
  skin.left(65540, true);  // the count begins anew at 65,536
  EXPECT_EQ(skin.since, 4);
}

TEST(Skin, WithoutFatNothingShowsHowThickItMustBe) {
  Skin skin = kUsual;
  skin.left(5, false);
  skin.left(1000, false);
  EXPECT_EQ(skin.level, kUsual.level);
  EXPECT_EQ(skin.since, 1000);
}

TEST(Skin, TheBoxOfTheLastLookIsUnmoved) {
  Skin skin;
  EXPECT_FALSE(skin.is_unmoved(7));
  EXPECT_FALSE(skin.is_unmoved(7)) << "to ask is not to look";
  skin.look(7);
  EXPECT_TRUE(skin.is_unmoved(7));
  EXPECT_FALSE(skin.is_unmoved(8));
  skin.look(8);
  EXPECT_FALSE(skin.is_unmoved(7));
}

TYPED_TEST(Skins, FingerprintsDistinguishBoxes) {
  constexpr int kD = TypeParam::value;
  std::set<std::uint16_t> prints;
  const Box<kD> box = cube<kD>(1, 2);
  for (int axis = 0; axis < kD; ++axis)
    for (const float step : {-1e-6F, 0.0F, 1e-6F})
      for (const bool at_min : {false, true}) {
        Box<kD> other = box;
        (at_min ? other.min : other.max)[axis] += step;
        prints.insert(fingerprint(PackedBox<kD>(other)));
      }
  EXPECT_EQ(prints.size(), 1U + 4 * kD) << "the box itself, and two for each end that moved";
}

}  // namespace
}  // namespace kerf::test
