// Leaves whose boxes lie in clumps far from one another: each clump is swept by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "tests/support/every_kernel.h"
#include "tests/support/leaf_views.h"
#include "tests/support/swept_alike.h"

namespace kerf::test {
namespace {

template <class T>
class Clumped : public EveryKernel<T> {};
TYPED_TEST_SUITE(Clumped, Dimensions, DimensionNames);

/// Boxes on islands, every one of which `far` from the next one. One island: some fall from it for ever.
template <int D>
LeafView<D> draw_islands(std::size_t count, std::size_t islands, float far, std::size_t grounds) {
  Random random(13);
  LeafView<D> leaf;
  for (std::size_t k = 0; k < count; ++k) {
    const double way = islands > 1 ? static_cast<double>(k % islands) : random.uniform(0, 1);
    const bool is_off = islands > 1 || k % 8 == 0;
    const Vector<D> center =
        random_point<D>(random, 0, 10) + all<D>(is_off ? far * static_cast<Scalar>(way) : 0);
    add_entry(leaf, box_at<D>(center, 0.2F));
    leaf.apart.back() = k % 7 == 0 ? DepthMask{2} : 0;
  }
  for (std::size_t k = 0; k < grounds; ++k) add_entry(leaf, box_at<D>(all<D>(0), 60 * far));
  return leaf;
}

/// Islands of hundreds and of few, some on one ground or several, of which each pair comes once.
TYPED_TEST(Clumped, LeavesAreSweptPartByPart) {
  constexpr int kD = TypeParam::value;
  for (const std::size_t count : {200U, 900U})
    for (const std::size_t islands : {1U, 2U, 6U, 50U})
      for (const std::size_t grounds : {0U, 1U, 3U, 20U})
        for (const float far : {1e3F, 1e6F, 1e37F}) {
          SCOPED_TRACE(testing::Message()
                       << count << " boxes, " << islands << " islands, " << grounds << " grounds, " << far);
          const auto sweep = expect_swept_alike(draw_islands<kD>(count, islands, far, grounds));
          EXPECT_TRUE(sweep.is_clumped || islands != 2 || far == 1e3F || (count == 200 && grounds > 1));
        }
}

/// Islands in a row of boxes so tall that bytes are too coarse, and finer steps order them: bytes of one step
/// differ.
TYPED_TEST(Clumped, IslandsOfTallBoxesAreDividedBetweenSteps) {
  constexpr int kD = TypeParam::value;
  for (std::size_t islands = 10; islands < 60; islands += 5) {
    Random random(17);
    LeafView<kD> leaf;
    for (std::size_t k = 0; k < 50 * islands; ++k) {
      Box<kD> box;
      box.min = random_point<kD>(random, 0, 1000);
      box.min[0] = static_cast<Scalar>(k % islands * 37) + static_cast<Scalar>(random.uniform(0, 1));
      for (int axis = 0; axis < kD; ++axis) box.max[axis] = box.min[axis] + (axis == 0 ? 0.05F : 500.0F);
      add_entry(leaf, box);
    }
    SCOPED_TRACE(testing::Message() << islands << " islands");
    expect_swept_alike(leaf);
  }
}

/// Islands of the same number of boxes, one behind the other in the leaf: a sample with a stride of its own
/// would see the first box of each, or the last one, and no clump.
TYPED_TEST(Clumped, IslandsInStepWithASampleAreSeen) {
  constexpr int kD = TypeParam::value;
  Random random(21);
  for (const std::size_t size : {25U, 50U, 125U}) {
    LeafView<kD> leaf;
    for (std::size_t k = 0; k < 1000; k += size) {
      const Vector<kD> center = random_point<kD>(random, -1e5, 1e5);
      for (std::size_t i = 0; i < size; ++i)
        add_entry(leaf, box_at<kD>(center + random_point<kD>(random, -3, 3), 0.5F));
    }
    SCOPED_TRACE(testing::Message() << "islands of " << size);
    EXPECT_TRUE(expect_swept_alike(leaf).is_clumped);
  }
}

/// On a floor at 0, in so many columns that floats are swept: not along the floor's axis.
TYPED_TEST(Clumped, FloatsOfAFloorSeparateNothing) {
  constexpr int kD = TypeParam::value;
  Random random(18);
  LeafView<kD> leaf;
  for (std::size_t k = 0; k < 4000; ++k) {
    Box<kD> box;
    box.min = random_point<kD>(random, 0, 0.1);
    box.min[0] = static_cast<Scalar>(k / 40);
    box.min[kD - 1] = 0;
    for (int axis = 0; axis < kD; ++axis) box.max[axis] = box.min[axis] + 1;
    add_entry(leaf, box);
  }
  EXPECT_NE(expect_swept_alike(leaf).axis, kD - 1);
}

/// Boxes about one point, of sizes that span decades as their distances do: no bytes separate them, and each
/// division at a gap would leave nearly all in one part. `crowding`: of their sizes.
template <int D>
LeafView<D> draw_all_sizes(std::size_t count, double decades, float crowding,
                           std::span<const DepthMask> masks, Random& random) {
  LeafView<D> leaf;
  for (std::size_t k = 0; k < count; ++k) {
    const auto scale = static_cast<Scalar>(std::pow(10, random.uniform(-decades / 2, decades / 2)));
    add_entry(leaf, box_at<D>(random_point<D>(random, -1, 1) * scale, crowding * scale));
    leaf.apart.back() = masks[k % masks.size()];
  }
  return leaf;
}

/// Sparse and crowded, with masks that exclude none, some, and two bits that fold to one.
TYPED_TEST(Clumped, BoxesOfAllSizesAreSweptByFloats) {
  constexpr int kD = TypeParam::value;
  const std::vector<std::vector<DepthMask>> all_masks{{0}, {0, 0, 2, 6}, {0, 1, DepthMask{1} << 8U, 0, 0}};
  Random random(19);
  for (const std::size_t count : {300U, 700U, 1500U})
    for (const double decades : {4, 12, 30})
      for (const float crowding : {0.03F, 0.2F, 0.6F})
        for (const std::vector<DepthMask>& masks : all_masks) {
          SCOPED_TRACE(testing::Message() << count << " boxes, " << decades << " decades, sizes " << crowding
                                          << ", " << masks.size() << " masks");
          const auto sweep = expect_swept_alike(draw_all_sizes<kD>(count, decades, crowding, masks, random));
          EXPECT_TRUE(sweep.is_clumped || decades < 12);
          EXPECT_TRUE(decades < 12 || !sweep.floats.order.items.empty());
        }
}

/// Boxes that touch, of coordinates that occur often, beside such that bytes cannot separate: an entry that
/// begins where a row of another one ends is one of it.
TYPED_TEST(Clumped, FloatsThatTouchAreFound) {
  constexpr int kD = TypeParam::value;
  Random random(20);
  for (int round = 0; round < 20; ++round) {
    LeafView<kD> leaf = draw_all_sizes<kD>(300, 20, 0.05F, std::vector<DepthMask>{0}, random);
    for (int k = 0; k < 200; ++k) {
      Box<kD> box;
      for (int axis = 0; axis < kD; ++axis) {
        box.min[axis] = static_cast<Scalar>(random.below(4)) - 2;
        box.max[axis] = box.min[axis] + 1;
      }
      add_entry(leaf, box);
    }
    SCOPED_TRACE(testing::Message() << "round " << round);
    EXPECT_FALSE(expect_swept_alike(leaf).floats.order.items.empty());
  }
}

}  // namespace
}  // namespace kerf::test
