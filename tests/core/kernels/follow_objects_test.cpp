#include "core/kernels/follow_objects.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"
#include "core/kernels/machine.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"

namespace kerf::test {
namespace {

template <int D>
struct Crowd {
  std::vector<PackedBox<D>> latest;
  std::vector<PackedBox<D>> followed;
  std::vector<Skin> skins;
  std::vector<ObjectFlags> flags;
  std::vector<std::uint32_t> objects;
  PackedBox<D> cell;
};

/// Many ends lie on the cell's, and many ways are as long as the thickest skin.
template <int D>
Crowd<D> draw_crowd(std::uint32_t count, Random& random) {
  Crowd<D> crowd;
  Box<D> cell;
  for (int i = 0; i < D; ++i) {
    cell.min[i] = -4;
    cell.max[i] = 4;
  }
  crowd.cell = PackedBox<D>(cell);
  for (std::uint32_t id = 0; id < count; ++id) {
    Box<D> before;
    Box<D> now;
    for (int i = 0; i < D; ++i) {
      before.min[i] = static_cast<Scalar>(random.below(9)) - 5;
      before.max[i] = before.min[i] + 1 + static_cast<Scalar>(random.below(2));
      const Scalar way = (static_cast<Scalar>(random.below(5)) - 2) * Skin::kMost;
      now.min[i] = before.min[i] + way;
      now.max[i] = before.max[i] + way;
    }
    crowd.latest.emplace_back(now);
    crowd.followed.emplace_back(before);
    crowd.skins.emplace_back();
    crowd.skins.back().restless = 3;
    crowd.flags.push_back(random.below(8) == 0 ? flag::kUnrequested | flag::kChanged : flag::kUnrequested);
    if (random.below(4) != 0) crowd.objects.push_back(id);
  }
  return crowd;
}

template <class T>
class FollowObjects : public EveryKernel<T> {};
TYPED_TEST_SUITE(FollowObjects, Dimensions, DimensionNames);

TYPED_TEST(FollowObjects, WhatLiesInTheCellAndIsFastIsFollowedTheRestIsLeftOver) {
  constexpr int kD = TypeParam::value;
  Random random(3);
  std::size_t followed = 0;
  for (const std::uint32_t count : {0U, 1U, 20U, 2000U}) {
    const Crowd<kD> given = draw_crowd<kD>(count, random);
    for (const std::string& name : kernels()) {
      SCOPED_TRACE(testing::Message() << name << ", " << count << " objects");
      use_kernel(name);
      Crowd<kD> crowd = given;
      std::vector<std::uint32_t> left_over(crowd.objects.size());
      left_over.resize(follow_objects<kD>({crowd.latest.data(), crowd.followed.data(), crowd.skins.data(),
                                           crowd.flags.data(), crowd.cell, crowd.objects.data(),
                                           crowd.objects.size(), left_over.data()}));
      std::vector<std::uint32_t> expected;
      for (const std::uint32_t id : given.objects) {
        const PackedBox<kD>& now = given.latest[id];
        const PackedBox<kD>& before = given.followed[id];
        const auto [size, speed] = size_and_speed(now, before);
        const bool follows = given.flags[id] == flag::kUnrequested && contains(given.cell, now) &&
                             contains(given.cell, before) && speed > Skin::kMost * size;
        if (!follows) expected.push_back(id);
        EXPECT_EQ(crowd.followed[id].lane, follows ? now.lane : before.lane);
        EXPECT_EQ(crowd.skins[id].restless, follows ? Skin::kRestless : 3);
        followed += follows ? 1U : 0U;
      }
      EXPECT_EQ(left_over, expected);
    }
  }
  EXPECT_GT(followed, 20U);
}

}  // namespace
}  // namespace kerf::test
