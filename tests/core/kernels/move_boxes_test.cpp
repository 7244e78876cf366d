#include "core/kernels/move_boxes.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/kernels/machine.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"

namespace kerf::test {
namespace {

template <class T>
class MoveBoxes : public EveryKernel<T> {};
TYPED_TEST_SUITE(MoveBoxes, Dimensions, DimensionNames);

TYPED_TEST(MoveBoxes, TellsWhoLeftAndLeavesTheOddToTheCaller) {
  constexpr int kD = TypeParam::value;
  const auto cube = [](Scalar low, Scalar high) {
    Box<kD> box;
    for (int i = 0; i < kD; ++i) {
      box.min[i] = low;
      box.max[i] = high;
    }
    return box;
  };
  const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
  const Scalar infinity = std::numeric_limits<Scalar>::infinity();
  std::vector<Box<kD>> given{cube(0, 1), cube(0, 1.5F),     cube(nan, 1),
                             cube(1, 0), cube(0, infinity), cube(0, 1)};
  for (int axis = 0; axis < kD; ++axis) {  // one bad end each is enough
    given.push_back(cube(0, 1));
    given.back().min[axis] = nan;
    given.push_back(cube(0, 1));
    given.back().max[axis] = -infinity;
  }
  std::vector<ObjectId> objects;
  for (std::uint32_t id = 0; id < given.size(); ++id) objects.push_back({id});
  objects.push_back({1000});
  given.push_back(cube(0, 1));
  for (const std::string& name : kernels()) {
    use_kernel(name);
    std::vector<PackedBox<kD>> latest(given.size() - 1, PackedBox<kD>(cube(-1, 1)));
    const std::vector<PackedBox<kD>> fat(latest.size(), PackedBox<kD>(cube(-1, 1.25F)));
    std::vector<std::uint8_t> attention(latest.size(), 0);
    attention[5] = 2;
    std::vector<ObjectId> changed(given.size());
    std::vector<PackedBox<kD>> before(given.size());
    std::vector<std::uint32_t> left_over(given.size());
    const MoveAnswer answer = move_boxes<kD>(
        {objects, given, latest, attention, fat.data(), changed.data(), before.data(), left_over.data()});
    EXPECT_EQ(answer.changed, 1U) << name;
    EXPECT_EQ(changed[0], ObjectId{1}) << name;
    EXPECT_EQ(before[0].unpack(), cube(-1, 1)) << name;
    EXPECT_EQ(latest[0].unpack(), cube(0, 1)) << name;
    EXPECT_EQ(latest[1].unpack(), cube(0, 1.5F)) << name;
    EXPECT_EQ(latest[2].unpack(), cube(-1, 1)) << name << ": what is left to the caller is not touched";
    EXPECT_EQ(attention[1], 1) << name;
    EXPECT_EQ(answer.left_over, given.size() - 2) << name;
    const MoveAnswer again = move_boxes<kD>(
        {objects, given, latest, attention, nullptr, changed.data(), nullptr, left_over.data()});
    EXPECT_EQ(again.changed, 1U) << name << ": object 1 has been noted; without fat boxes object 0 asks";
    EXPECT_EQ(changed[0], ObjectId{0}) << name;
  }
}

TYPED_TEST(MoveBoxes, WhoFillsItsFatBoxAndShrinksHasLeftIt) {
  constexpr int kD = TypeParam::value;
  Box<kD> whole;
  for (int i = 0; i < kD; ++i) whole.max[i] = 4;
  const std::vector<PackedBox<kD>> fat(2, PackedBox<kD>(whole));
  for (int axis = 0; axis < kD; ++axis) {
    Box<kD> less = whole;
    less.max[axis] = 3;
    Box<kD> least = less;
    least.min[axis] = 1;
    for (const std::string& name : kernels()) {
      use_kernel(name);
      std::vector<PackedBox<kD>> latest{PackedBox<kD>(whole), PackedBox<kD>(less)};
      std::vector<std::uint8_t> attention(2, 0);
      std::vector<ObjectId> changed(2);
      std::vector<PackedBox<kD>> before(2);
      std::vector<std::uint32_t> left_over(2);
      const std::vector<ObjectId> both{{0}, {1}};
      const auto move = [&](const Box<kD>& box) {
        return move_boxes<kD>({both, std::vector{box, box}, latest, attention, fat.data(), changed.data(),
                               before.data(), left_over.data()});
      };
      EXPECT_EQ(move(least).changed, 1U) << name << ", axis " << axis;
      EXPECT_EQ(changed[0], ObjectId{0}) << name << ", axis " << axis;
    }
  }
}

/// Who is silent asks for nothing, but what is odd is left to the caller all the same.
TYPED_TEST(MoveBoxes, TheSilentAreMovedAndNotNoted) {
  constexpr int kD = TypeParam::value;
  Box<kD> near;
  Box<kD> far;
  for (int i = 0; i < kD; ++i) {
    near.max[i] = 1;
    far.min[i] = 8;
    far.max[i] = 9;
  }
  Box<kD> bad = near;
  bad.min[0] = std::numeric_limits<Scalar>::quiet_NaN();
  const std::vector<PackedBox<kD>> fat(4, PackedBox<kD>(near));
  const std::vector<ObjectId> objects{{0}, {1}, {2}, {3}};
  for (const std::string& name : kernels()) {
    use_kernel(name);
    std::vector<PackedBox<kD>> latest = fat;
    std::vector<std::uint8_t> attention{kSilent, 0, kSilent, kSilent | 1};
    std::vector<ObjectId> changed(4);
    std::vector<PackedBox<kD>> before(4);
    std::vector<std::uint32_t> left_over(4);
    const MoveAnswer answer = move_boxes<kD>({objects, std::vector{far, far, bad, far}, latest, attention,
                                              fat.data(), changed.data(), before.data(), left_over.data()});
    EXPECT_EQ(latest[0].unpack(), far) << name;
    EXPECT_EQ(attention[0], kSilent) << name;
    ASSERT_EQ(answer.changed, 1U) << name;
    EXPECT_EQ(changed[0], ObjectId{1}) << name;
    ASSERT_EQ(answer.left_over, 2U) << name;
    EXPECT_EQ(left_over[0], 2U) << name << ": no box";
    EXPECT_EQ(left_over[1], 3U) << name << ": something else was asked";
  }
}

}  // namespace
}  // namespace kerf::test
