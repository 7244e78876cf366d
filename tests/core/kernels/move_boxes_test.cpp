#include "core/kernels/move_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/kernels/machine.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"

namespace kerf::test {
namespace {

template <class T>
class MoveBoxes : public EveryKernel<T> {};
TYPED_TEST_SUITE(MoveBoxes, Dimensions, DimensionNames);

TYPED_TEST(MoveBoxes, ReturnsWhatLeftAndLeavesTheOddToTheCaller) {
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
    std::vector<ObjectFlags> flags(latest.size(), 0);
    flags[5] = flag::kUnplaced;
    std::vector<ObjectId> changed(given.size());
    std::vector<PackedBox<kD>> before(given.size());
    std::vector<std::uint32_t> left_over(given.size());
    const MoveAnswer answer = move_boxes<kD>(
        {objects, given, latest, flags, fat.data(), changed.data(), before.data(), left_over.data()});
    EXPECT_EQ(answer.changed, 1U) << name;
    EXPECT_EQ(changed[0], ObjectId{1}) << name;
    EXPECT_EQ(before[0].unpack(), cube(-1, 1)) << name;
    EXPECT_EQ(latest[0].unpack(), cube(0, 1)) << name;
    EXPECT_EQ(latest[1].unpack(), cube(0, 1.5F)) << name;
    EXPECT_EQ(latest[2].unpack(), cube(-1, 1)) << name << ": what is left to the caller is not touched";
    EXPECT_EQ(flags[1], flag::kChanged) << name;
    EXPECT_EQ(answer.left_over, given.size() - 2) << name;
    const MoveAnswer again =
        move_boxes<kD>({objects, given, latest, flags, nullptr, changed.data(), nullptr, left_over.data()});
    EXPECT_EQ(again.changed, 1U) << name << ": object 1 has been noted; without fat boxes object 0 asks";
    EXPECT_EQ(changed[0], ObjectId{0}) << name;
  }
}

TYPED_TEST(MoveBoxes, WhatFillsItsFatBoxAndShrinksHasLeftIt) {
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
      std::vector<ObjectFlags> flags(2, 0);
      std::vector<ObjectId> changed(2);
      std::vector<PackedBox<kD>> before(2);
      std::vector<std::uint32_t> left_over(2);
      const std::vector<ObjectId> both{{0}, {1}};
      const auto move = [&](const Box<kD>& box) {
        return move_boxes<kD>({both, std::vector{box, box}, latest, flags, fat.data(), changed.data(),
                               before.data(), left_over.data()});
      };
      EXPECT_EQ(move(least).changed, 1U) << name << ", axis " << axis;
      EXPECT_EQ(changed[0], ObjectId{0}) << name << ", axis " << axis;
    }
  }
}

/// What the kernel reads and writes, and what it answered so far. Without fat boxes `before` says nothing.
template <int D>
struct Moved {
  std::vector<PackedBox<D>> latest;
  std::vector<ObjectFlags> flags;
  std::vector<ObjectId> changed;
  std::vector<PackedBox<D>> before;
  std::vector<std::uint32_t> left_over;

  void move(std::span<const ObjectId> objects, std::span<const Box<D>> boxes,
            const std::vector<PackedBox<D>>& fat, TaskPool& pool) {
    std::vector<ObjectId> asking(objects.size());
    std::vector<PackedBox<D>> were(objects.size());
    std::vector<std::uint32_t> odd(objects.size());
    const MoveAnswer answer =
        move_boxes<D>({objects, boxes, latest, flags, fat.empty() ? nullptr : fat.data(), asking.data(),
                       were.data(), odd.data()},
                      pool);
    changed.insert(changed.end(), asking.begin(),
                   asking.begin() + static_cast<std::ptrdiff_t>(answer.changed));
    before.insert(before.end(), were.begin(), were.begin() + static_cast<std::ptrdiff_t>(answer.changed));
    left_over.insert(left_over.end(), odd.begin(),
                     odd.begin() + static_cast<std::ptrdiff_t>(answer.left_over));
  }
};

template <int D>
bool are_equal(const std::vector<PackedBox<D>>& a, const std::vector<PackedBox<D>>& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x.lane == y.lane; });
}

template <int D>
struct Requests {
  std::vector<ObjectId> objects;
  std::vector<Box<D>> boxes;
};

/// A box near that of the object, or one of the odd ones: it leaves, shrinks, is inverted, has no number.
template <int D>
Box<D> next_box(Random& random, Box<D> box, double odd) {
  const auto axis = static_cast<int>(random.below(D));
  const double what = random.uniform(0, 1) / odd;
  if (what < 0.2) box.max[axis] += 2;
  if (what >= 0.2 && what < 0.4) box.min[axis] = box.max[axis];
  if (what >= 0.4 && what < 0.6) box.min[axis] = box.max[axis] + 1;
  if (what >= 0.6 && what < 0.8) box.max[axis] = std::numeric_limits<Scalar>::quiet_NaN();
  if (what >= 0.8 && what < 1) box.max[axis] = std::numeric_limits<Scalar>::infinity();
  return box;
}

/// Some objects are given twice, the last are unknown.
template <int D>
Requests<D> make_requests(Random& random, const std::vector<PackedBox<D>>& latest, double odd,
                          bool shuffled) {
  constexpr std::uint32_t kUnknown = 10;
  Requests<D> requests;
  for (std::uint32_t id = 0; id < latest.size() + kUnknown; id += random.uniform(0, 1) < odd ? 0 : 1) {
    requests.objects.push_back({id});
    requests.boxes.push_back(id < latest.size() ? next_box(random, latest[id].unpack(), odd) : Box<D>{});
  }
  for (std::uint32_t k = 1; shuffled && k < requests.objects.size(); ++k) {
    const std::uint32_t other = random.below(k + 1);
    std::swap(requests.objects[k], requests.objects[other]);
    std::swap(requests.boxes[k], requests.boxes[other]);
  }
  return requests;
}

template <int D>
void expect_at_once_as_one_by_one(const Moved<D>& start, const Requests<D>& requests,
                                  const std::vector<PackedBox<D>>& fat) {
  TaskPool alone;
  Moved<D> at_once = start;
  Moved<D> expected = start;
  at_once.move(requests.objects, requests.boxes, fat, alone);
  for (std::uint32_t k = 0; k < requests.objects.size(); ++k) {
    const std::size_t left_over = expected.left_over.size();
    expected.move({&requests.objects[k], 1}, {&requests.boxes[k], 1}, fat, alone);
    if (expected.left_over.size() > left_over) expected.left_over.back() = k;
  }
  EXPECT_TRUE(are_equal<D>(at_once.latest, expected.latest));
  EXPECT_EQ(at_once.flags, expected.flags);
  EXPECT_EQ(at_once.changed, expected.changed);
  EXPECT_EQ(at_once.left_over, expected.left_over);
  EXPECT_TRUE(fat.empty() || are_equal<D>(at_once.before, expected.before));
}

/// Any mix in a block: objects that stay, leave, shrink, are unrequested, wait, are given twice, are
/// unknown, or have no box.
TYPED_TEST(MoveBoxes, ManyAtOnceAreMovedAsOneByOne) {
  constexpr int kD = TypeParam::value;
  Random random(7);
  for (int round = 0; round < 40; ++round) {
    const double odd = round % 4 == 0 ? 0.3 : 0.02;  // else most blocks have nothing odd
    const double quiet = round % 4 == 1 ? 0.3 : 0;   // then most blocks have an unrequested object
    Moved<kD> start;
    std::vector<PackedBox<kD>> fat;
    for (std::uint32_t id = 0; id < 400; ++id) {
      const Box<kD> box = random_box<kD>(random, 10, 1);
      start.latest.emplace_back(box);
      const bool fills = random.uniform(0, 1) < 0.3;
      fat.emplace_back(fills ? box : Box<kD>{box.min - all<kD>(0.5F), box.max + all<kD>(0.5F)});
      const std::array<std::uint8_t, 3> attended{flag::kUnrequested, 2, flag::kUnrequested | flag::kChanged};
      const std::uint8_t usual = random.uniform(0, 1) < quiet ? flag::kUnrequested : 0;
      start.flags.push_back(random.uniform(0, 1) < odd ? attended[id % 3] : usual);
    }
    const Requests<kD> requests = make_requests(random, start.latest, odd, round % 3 == 0);
    for (const std::string& name : kernels()) {
      SCOPED_TRACE(name + ", round " + std::to_string(round));
      use_kernel(name);
      expect_at_once_as_one_by_one<kD>(start, requests, fat);
      expect_at_once_as_one_by_one<kD>(start, requests, {});
      if (testing::Test::HasFailure()) return;
    }
  }
}

/// An object that is given twice, the second time where another thread would begin, waits once it has asked.
TYPED_TEST(MoveBoxes, ThreadsMoveAsOneDoes) {
  constexpr int kD = TypeParam::value;
  constexpr std::uint32_t kObjects = 10000;
  TaskPool alone;
  TaskPool shared(3);
  const std::size_t second = slice(kObjects, shared.slices_of(kObjects), 1).begin;
  for (const bool twice : {false, true}) {
    std::vector<ObjectId> objects;
    std::vector<Box<kD>> boxes;
    for (std::uint32_t k = 0; k < kObjects; ++k) {
      objects.push_back({twice && k == second ? k - 1 : k});
      boxes.push_back(box_at<kD>({}, k % 7 == 0 || k == second - 1 ? 3.0F : 1.0F));
    }
    Moved<kD> one{std::vector(kObjects, PackedBox<kD>(box_at<kD>({}, 1))),
                  std::vector<std::uint8_t>(kObjects),
                  {},
                  {},
                  {}};
    const std::vector<PackedBox<kD>> fat(kObjects, PackedBox<kD>(box_at<kD>({}, 2)));
    Moved<kD> many = one;
    one.move(objects, boxes, fat, alone);
    many.move(objects, boxes, fat, shared);
    EXPECT_TRUE(are_equal<kD>(one.latest, many.latest));
    EXPECT_TRUE(are_equal<kD>(one.before, many.before));
    EXPECT_EQ(one.flags, many.flags);
    EXPECT_EQ(one.changed, many.changed);
    EXPECT_EQ(one.left_over, many.left_over);
    EXPECT_EQ(one.left_over.size(), twice ? 1U : 0U);
  }
}

/// An unrequested object requests nothing, but its odd boxes are left to the caller as well.
TYPED_TEST(MoveBoxes, TheUnrequestedAreMovedAndNotNoted) {
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
    std::vector<ObjectFlags> flags{flag::kUnrequested, 0, flag::kUnrequested,
                                   flag::kUnrequested | flag::kChanged};
    std::vector<ObjectId> changed(4);
    std::vector<PackedBox<kD>> before(4);
    std::vector<std::uint32_t> left_over(4);
    const MoveAnswer answer = move_boxes<kD>({objects, std::vector{far, far, bad, far}, latest, flags,
                                              fat.data(), changed.data(), before.data(), left_over.data()});
    EXPECT_EQ(latest[0].unpack(), far) << name;
    EXPECT_EQ(flags[0], flag::kUnrequested) << name;
    ASSERT_EQ(answer.changed, 1U) << name;
    EXPECT_EQ(changed[0], ObjectId{1}) << name;
    ASSERT_EQ(answer.left_over, 2U) << name;
    EXPECT_EQ(left_over[0], 2U) << name << ": no box";
    EXPECT_EQ(left_over[1], 3U) << name << ": something else was asked";
  }
}

}  // namespace
}  // namespace kerf::test
