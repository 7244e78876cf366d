// Every kernel finds the pairs that the definition gives, and all kernels give the same in the same order.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "core/base/random.h"
#include "core/kernels/byte_sweep.h"
#include "core/kernels/divide_list.h"
#include "core/kernels/machine.h"
#include "core/kernels/stay_in_cell.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"
#include "tests/support/leaf_views.h"
#include "tests/support/pairs.h"
#include "tests/support/swept_alike.h"

namespace kerf::test {
namespace {

template <class T>
class Kernels : public EveryKernel<T> {};
TYPED_TEST_SUITE(Kernels, Dimensions, DimensionNames);

TYPED_TEST(Kernels, TheMachineHasTheBaselineAndRefusesOthers) {
  const std::string baseline = kernels().back();  // Highway 1.0: EMU128, later ones on x86: SSE2
  EXPECT_THAT(baseline, ::testing::AnyOf("EMU128", "SSE2"));
  EXPECT_THROW(use_kernel("ABACUS"), std::invalid_argument);
  use_kernel(baseline);
  EXPECT_EQ(kernel(), baseline);
}

TYPED_TEST(Kernels, SweepFindsWhatTheDefinitionGivesInOneOrder) {
  constexpr int kD = TypeParam::value;
  Random random(3);
  for (const Spread spread : {Spread::even, Spread::grid, Spread::tiny, Spread::huge, Spread::outlier,
                              Spread::one_point, Spread::flat, Spread::touching, Spread::dense}) {
    for (const std::size_t count : {0U, 1U, 2U, 63U, 64U, 65U, 129U, 400U, 600U}) {
      SCOPED_TRACE(testing::Message() << "spread " << static_cast<int>(spread) << ", entries " << count);
      expect_swept_alike(draw_leaf<kD>(spread, count, random));
    }
  }
}

/// No planes, planes in one byte of the mask, in several that do not meet where it is folded, and in several
/// that do.
TYPED_TEST(Kernels, DenseLeavesAreSweptAlikeWhateverKeepsTheirEntriesApart) {
  constexpr int kD = TypeParam::value;
  Random random(4);
  for (const DepthMask planes : {DepthMask{0}, DepthMask{7}, DepthMask{0x102040000000}, DepthMask{0x10101}}) {
    for (const Spread spread : {Spread::dense, Spread::even}) {
      SCOPED_TRACE(testing::Message() << "planes " << planes << ", spread " << static_cast<int>(spread));
      const auto sweep = expect_swept_alike(draw_leaf<kD>(spread, 1000, random, planes));
      EXPECT_EQ(sweep.is_dense, spread == Spread::dense);
    }
  }
}

/// Rods through the whole leaf along each axis: boxes of their mean lengths would all overlap, and no two
/// meet.
TEST(RodsInALeaf, AreNotDenseHoweverLong) {
  Random random(6);
  LeafView<3> leaf;
  for (int k = 0; k < 900; ++k) {
    Box<3> rod;
    rod.min = rod.max = random_point<3>(random, 0, 10);
    const int along = k % 3;
    rod.min[along] = -10;
    rod.max[along] = 20;
    add_entry(leaf, rod);
  }
  EXPECT_FALSE(expect_swept_alike(leaf).is_dense);
}

/// Boxes on a ring, which leave most of the leaf empty: boxes of their mean lengths would hardly meet.
TEST(ARingInALeaf, IsDenseThoughMostOfTheLeafIsEmpty) {
  Random random(7);
  LeafView<2> leaf;
  for (int k = 0; k < 900; ++k) {
    const double angle = random.uniform(0, 6.28);
    Box<2> box;
    box.min[0] = static_cast<Scalar>(20 * std::cos(angle));
    box.min[1] = static_cast<Scalar>(20 * std::sin(angle));
    box.max = box.min + Vector<2>{{2, 2}};
    add_entry(leaf, box);
  }
  EXPECT_TRUE(expect_swept_alike(leaf).is_dense);
}

/// Boxes of one size in a row, which keeps no two apart on the other axes: along it bytes are too coarse,
/// whether each meets few others or many, and wherever one begins where another one ends.
TYPED_TEST(Kernels, ALineIsOrderedByFinerSteps) {
  constexpr int kD = TypeParam::value;
  Random random(8);
  for (const double pairs : {2.0, 6.0, 12.0, 40.0}) {
    for (const bool on_grid : {false, true}) {
      SCOPED_TRACE(testing::Message() << pairs << (on_grid ? " pairs, on a grid" : " pairs"));
      LeafView<kD> leaf;
      for (int k = 0; k < 900; ++k) {
        const double at = random.uniform(0, 900 / pairs);
        Box<kD> box;
        box.min = random_point<kD>(random, 0, 0.1);
        box.min[0] = static_cast<Scalar>(on_grid ? std::round(8 * at) / 8 : at);
        for (int axis = 0; axis < kD; ++axis) box.max[axis] = box.min[axis] + 1;
        add_entry(leaf, box);
      }
      const auto sweep = expect_swept_alike(leaf);
      EXPECT_EQ(sweep.axis, 0);
      EXPECT_TRUE(sweep.is_fine);
      EXPECT_EQ(sweep.is_short, pairs < 20);
      EXPECT_EQ(sweep.is_dense, pairs > 5);
    }
  }
}

/// Objects that have left the scene, on either side.
TYPED_TEST(Kernels, FewFarBoxesLeaveTheBytesToTheOthers) {
  constexpr int kD = TypeParam::value;
  for (const float far : {1e4F, 1e7F, 1e37F}) {
    Random random(12);
    LeafView<kD> leaf;
    for (int k = 0; k < 900; ++k) {
      const Scalar offset = k % 300 == 0 ? (k == 300 ? -far : far) : 0;
      const Vector<kD> center = random_point<kD>(random, 0, 30) + all<kD>(offset);
      add_entry(leaf, box_at<kD>(center, 0.5F));
    }
    const auto sweep = expect_swept_alike(leaf);
    std::set<std::uint8_t> beginnings;
    for (const auto key : sweep.sorted_keys) beginnings.insert(static_cast<std::uint8_t>(key));
    EXPECT_GT(beginnings.size(), 50U) << far;
  }
}

/// Boxes along the diagonal: they meet all others on no axis, but whatever meets on one meets on all.
TYPED_TEST(Kernels, ASlantedLineIsOrderedByFinerSteps) {
  constexpr int kD = TypeParam::value;
  Random random(10);
  LeafView<kD> leaf;
  for (int k = 0; k < 900; ++k) {
    const double at = random.uniform(0, 90);
    Box<kD> box;
    for (int axis = 0; axis < kD; ++axis) {
      box.min[axis] = static_cast<Scalar>(at + random.uniform(0, 0.1));
      box.max[axis] = box.min[axis] + 1;
    }
    add_entry(leaf, box);
  }
  const auto sweep = expect_swept_alike(leaf);
  EXPECT_TRUE(sweep.is_fine);
  EXPECT_TRUE(sweep.is_dense);
}

/// A line of boxes so large that the leaf is longer than floats are, and with boxes of denormals: no scale is
/// so small or so large.
TYPED_TEST(Kernels, ALineOfAnySizeIsSweptByFloats) {
  constexpr int kD = TypeParam::value;
  Random random(9);
  for (const Scalar size : {5e36F, 1e-40F}) {
    SCOPED_TRACE(testing::Message() << "size " << size);
    LeafView<kD> leaf;
    for (int k = 0; k < 600; ++k) {
      Box<kD> box;
      box.min = random_point<kD>(random, 0, 0.1 * size);
      box.min[0] = static_cast<Scalar>(random.uniform(-60, 60)) * size;
      for (int axis = 0; axis < kD; ++axis) box.max[axis] = box.min[axis] + size;
      add_entry(leaf, box);
    }
    EXPECT_TRUE(expect_swept_alike(leaf).is_clumped);
  }
}

TYPED_TEST(Kernels, AnAxisOnWhichAllShareAPointIsNotSweptAlong) {
  constexpr int kD = TypeParam::value;
  Random random(5);
  for (const Spread spread : {Spread::flat, Spread::touching})
    EXPECT_NE(expect_swept_alike(draw_leaf<kD>(spread, 300, random)).axis, kD - 1);
}

/// A list of objects, and what they straddle, with room for its parts.
struct List {
  std::vector<std::uint32_t> objects;
  std::vector<DepthMask> straddle;

  List(std::size_t begin, std::size_t end)
      : objects(2 * end - begin + kDividePad), straddle(2 * end - begin + kDividePad) {}
  void copy(std::size_t from, std::size_t to) {
    objects[to] = objects[from];
    straddle[to] = straddle[from];
  }
  [[nodiscard]] bool same(const List& other, std::size_t from, std::size_t to) const {
    bool all = true;
    for (std::size_t k = from; k < to; ++k)
      all &= objects[k] == other.objects[k] && straddle[k] == other.straddle[k];
    return all;
  }
};

/// Objects in any order that straddle anything.
List draw_list(std::size_t begin, std::size_t end, std::size_t objects, Random& random) {
  List list(begin, end);
  for (std::size_t k = begin; k < end; ++k) {
    list.objects[k] = static_cast<std::uint32_t>(random.bits() % objects);
    list.straddle[k] = random.bits();
  }
  return list;
}

/// The same by the definition, one by one.
template <int D>
Divided divide_one_by_one(List& list, std::size_t begin, std::size_t end,
                          const std::vector<PackedBox<D>>& boxes, int axis, Scalar offset,
                          std::uint32_t depth) {
  Divided at{end, begin, end};
  for (std::size_t k = begin; k < end; ++k) {
    const Box<D> box = boxes[list.objects[k]].unpack();
    const Sides sides = classify({box.min[axis], box.max[axis]}, offset);
    if (sides.straddle()) list.straddle[k] |= depth_bit(depth);
    if (sides.right) list.copy(k, at.right++);
    if (sides.left) list.copy(k, at.left++);
  }
  return at;
}

TYPED_TEST(Kernels, ListsAreDividedAsTheDefinitionSays) {
  constexpr int kD = TypeParam::value;
  constexpr std::size_t kBegin = 5;
  constexpr std::uint32_t kDepth = 40;
  Random random(11);
  std::vector<PackedBox<kD>> boxes;
  for (int k = 0; k < 200; ++k) boxes.emplace_back(draw_box<kD>(Spread::grid, random));
  for (std::size_t round = 0; round < 12; ++round) {
    const std::size_t end = kBegin + std::array{0U, 1U, 7U, 16U, 65U, 150U}[round % 6];
    const auto axis = round % kD;
    const Scalar offset = std::round(static_cast<Scalar>(random.uniform(-3, 3)));  // many ends lie on it
    const List given = draw_list(kBegin, end, boxes.size(), random);
    List expected = given;
    divide_one_by_one<kD>(expected, kBegin, end, boxes, static_cast<int>(axis), offset, kDepth);
    for (const std::string& name : kernels()) {
      SCOPED_TRACE(testing::Message() << name << ", round " << round);
      use_kernel(name);
      List list = given;
      const auto& first = boxes.front().lane;
      const Divided at =
          divide_list<kD>({&first[axis], &first[axis + PackedBox<kD>::kHalf], offset, depth_bit(kDepth),
                           list.objects.data(), list.straddle.data(), kBegin, end, round >= 6});
      EXPECT_GT(at.done + 16, end) << "less than a vector is left";
      List vectors = given;
      const Divided part =
          divide_one_by_one<kD>(vectors, kBegin, at.done, boxes, static_cast<int>(axis), offset, kDepth);
      EXPECT_EQ(at.left, part.left);
      EXPECT_EQ(at.right - end, part.right - at.done) << "they lie behind the whole list";
      EXPECT_TRUE(list.same(expected, kBegin, at.left));
      EXPECT_TRUE(list.same(expected, end, at.right));
    }
  }
}

TYPED_TEST(Kernels, WhatLiesInTheCellAndStraddlesNothingStays) {
  constexpr int kD = TypeParam::value;
  constexpr DepthMask kRightOf = 0b0101;
  Random random(12);
  for (std::uint32_t round = 0; round < 30; ++round) {
    const std::uint32_t count = std::array{0U, 1U, 15U, 64U, 200U}[round % 5];
    std::vector<PackedBox<kD>> boxes;
    std::vector<Entry> given;
    for (std::uint32_t k = 0; k < count; ++k) {
      boxes.emplace_back(draw_box<kD>(Spread::grid, random));
      const DepthMask straddle = random.below(3) == 0 ? random.bits() & 7U : 0;
      given.push_back({{}, {count - 1 - k}, straddle});
    }
    Box<kD> cell;
    for (int i = 0; i < kD; ++i) {
      cell.min[i] = std::round(static_cast<Scalar>(random.uniform(-4, 1)));  // many ends lie on it
      cell.max[i] = std::round(static_cast<Scalar>(random.uniform(0, 4)));
    }
    const std::uint32_t axis = round % kD;
    std::vector<std::uint32_t> stayers;
    std::vector<std::uint32_t> leavers;
    for (const Entry& entry : given) {
      const bool inside = contains(PackedBox<kD>(cell), boxes[entry.object.index()]);
      if (inside && entry.straddle == 0)
        stayers.push_back(entry.object.value);
      else if ((entry.straddle & kRightOf) == 0)
        leavers.push_back(entry.object.value);
    }
    for (const std::string& name : kernels()) {
      SCOPED_TRACE(testing::Message() << name << ", round " << round);
      use_kernel(name);
      std::vector<Entry> entries = given;
      std::vector<std::uint32_t> left(count + 1);
      std::vector<PackedBox<kD>> left_boxes(count + 1);
      std::vector<PackedBox<kD>> kept_boxes(count + 1);
      const bool wanted = round % 2 == 0;
      const Stayed done = stay_in_cell<kD>({boxes.data(), PackedBox<kD>(cell), kRightOf, axis, entries.data(),
                                            count, left.data(), wanted ? left_boxes.data() : nullptr,
                                            wanted ? kept_boxes.data() : nullptr});
      ASSERT_EQ(done.stayed, stayers.size());
      for (std::size_t k = 0; k < done.stayed; ++k) {
        const Box<kD> box = boxes[stayers[k]].unpack();
        EXPECT_EQ(entries[k].object.value, stayers[k]);
        EXPECT_EQ(entries[k].straddle, 0U);
        EXPECT_EQ(entries[k].key.lo, box.min[static_cast<int>(axis)]);
        EXPECT_EQ(entries[k].key.hi, box.max[static_cast<int>(axis)]);
        EXPECT_EQ(kept_boxes[k].lane, wanted ? boxes[stayers[k]].lane : PackedBox<kD>().lane);
      }
      left.resize(done.left);
      EXPECT_EQ(left, leavers);
      for (std::size_t k = 0; k < leavers.size(); ++k)
        EXPECT_EQ(left_boxes[k].lane, wanted ? boxes[leavers[k]].lane : PackedBox<kD>().lane);
    }
  }
}

}  // namespace
}  // namespace kerf::test
