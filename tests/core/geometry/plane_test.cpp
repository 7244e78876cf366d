#include "core/geometry/plane.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "core/base/random.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr Scalar kMax = std::numeric_limits<Scalar>::max();

template <int D>
Sides sides_of_box(const Plane<D>& plane, const Box<D>& box) {
  return classify(project(plane.normal, box), plane.offset);
}

template <class T>
class PlaneSides : public testing::Test {};
TYPED_TEST_SUITE(PlaneSides, Dimensions, DimensionNames);

TYPED_TEST(PlaneSides, AxisProjectionIsTheBoxItself) {
  constexpr int kD = TypeParam::value;
  for (int axis = 0; axis < kD; ++axis) {
    const Box<kD> box = slab<kD>(0.1F, 0.7F, axis);
    EXPECT_EQ(project(axis_vector<kD>(axis), box), (Interval{0.1F, 0.7F}));
    EXPECT_EQ(project(axis_vector<kD>(axis) * -1, box), (Interval{-0.7F, -0.1F}));
  }
}

TYPED_TEST(PlaneSides, OnlyTheFirstDirectionsAreTakenForAxes) {
  constexpr int kD = TypeParam::value;
  Random random(7);
  for (int round = 0; round < 1000; ++round) {
    const Box<kD> box = random_box<kD>(random, 100, 5);
    for (int axis = 0; axis < kD; ++axis) {
      const Vector<kD> normal = axis_vector<kD>(axis);
      EXPECT_EQ(project(static_cast<std::uint32_t>(axis), normal, box), project(normal, box));
    }
    const Vector<kD> normal = random_point<kD>(random, -1, 1);
    EXPECT_EQ(project(std::uint32_t{kD}, normal, box), project(normal, box));
  }
}

TYPED_TEST(PlaneSides, ProjectionTakesTheExtremeCorners) {
  constexpr int kD = TypeParam::value;
  Vector<kD> normal;
  normal[0] = 0.5F;
  normal[1] = -0.25F;
  const Box<kD> box{all<kD>(-4), all<kD>(8)};
  EXPECT_EQ(project(normal, box), (Interval{-4, 5}));
}

TYPED_TEST(PlaneSides, LeftIsClosedAndRightIsOpen) {
  constexpr int kD = TypeParam::value;
  const auto sides_of = [](Scalar lo, Scalar hi, Scalar offset) {
    return sides_of_box(Plane<kD>{axis_vector<kD>(0), offset}, slab<kD>(lo, hi));
  };
  EXPECT_EQ(sides_of(1, 2, 3), (Sides{true, false}));
  EXPECT_EQ(sides_of(1, 2, 0), (Sides{false, true}));
  EXPECT_EQ(sides_of(1, 2, 1.5F), (Sides{true, true}));
  EXPECT_EQ(sides_of(1, 2, 2), (Sides{true, false})) << "hi == d";
  EXPECT_EQ(sides_of(1, 2, 1), (Sides{true, true})) << "lo == d";
  EXPECT_EQ(sides_of(1, 1, 1), (Sides{true, false})) << "lo == hi == d";
  EXPECT_EQ(sides_of(0.0F, 0.0F, -0.0F), (Sides{true, false})) << "zeros of either sign";
}

TYPED_TEST(PlaneSides, OverflowingProjectionsKeepTheirSide) {
  constexpr int kD = TypeParam::value;
  const Vector<kD> diagonal = all<kD>(1);
  EXPECT_EQ(sides_of_box(Plane<kD>{diagonal, 0}, Box<kD>{all<kD>(kMax), all<kD>(kMax)}),
            (Sides{false, true}));
  EXPECT_EQ(sides_of_box(Plane<kD>{diagonal, 0}, Box<kD>{all<kD>(-kMax), all<kD>(-kMax)}),
            (Sides{true, false}));
  EXPECT_EQ(sides_of_box(Plane<kD>{diagonal, kMax}, Box<kD>{all<kD>(kMax), all<kD>(kMax)}),
            (Sides{false, true}));
  EXPECT_TRUE(sides_of_box(Plane<kD>{diagonal, kMax}, Box<kD>{all<kD>(-kMax), all<kD>(kMax)}).straddle());
}

/// Scenes in which a projection with an epsilon, or by centre and extent, goes wrong.
struct Adversary {
  const char* name;
  double offset;         ///< of the whole scene
  double extent;         ///< of a box
  double normal_length;  ///< directions need not be normalised
};

constexpr std::array kAdversaries{
    Adversary{"unit", 0, 1, 1},           Adversary{"far away", 1e7, 1, 1},
    Adversary{"flat", 1e5, 0, 1},         Adversary{"denormal", 0, 1e-42, 1},
    Adversary{"largest", 3e38, 1e31, 1},  Adversary{"short direction", 1e6, 1, 1e-20},
    Adversary{"tiny boxes", 1e3, 1e-6, 1}};

/// A box that shares exactly a corner, an edge or a face with `a`, or lies one ulp inside of it.
template <int D>
Box<D> barely_overlapping(const Box<D>& a, Scalar extent, Random& random) {
  Box<D> b;
  for (int i = 0; i < D; ++i) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) {
      b.min[i] = a.max[i];
      b.max[i] = std::min(kMax, b.min[i] + extent);
    } else if (kind == 1) {
      b.max[i] = a.min[i];
      b.min[i] = std::max(-kMax, b.max[i] - extent);
    } else if (kind == 2) {
      b.min[i] = std::max(a.min[i], std::nextafter(a.max[i], -kMax));
      b.max[i] = std::min(kMax, b.min[i] + extent);
    } else {
      b.min[i] = a.min[i];
      b.max[i] = a.max[i];
    }
  }
  return b;
}

template <int D>
Vector<D> adversarial_direction(Random& random, double length) {
  Vector<D> normal = random_point<D>(random, -length, length);
  const std::uint32_t kind = random.below(4);
  const auto axis = static_cast<int>(random.below(D));
  if (kind == 0) normal[axis] = 0;
  if (kind == 1) normal[axis] = static_cast<Scalar>(normal[axis] * 1e-7);  // nearly along the other axes
  return normal;
}

TYPED_TEST(PlaneSides, OverlappingBoxesHaveOverlappingIntervalsAndShareASide) {
  constexpr int kD = TypeParam::value;
  constexpr int kPairs = 40'000;
  for (const Adversary& adversary : kAdversaries) {
    Random random(7);
    for (int i = 0; i < kPairs; ++i) {
      const Vector<kD> low = random_point<kD>(random, adversary.offset - adversary.extent, adversary.offset);
      const Vector<kD> reach = random_point<kD>(random, 0, adversary.extent);
      const Box<kD> a{low, low + reach};
      const Box<kD> b = barely_overlapping(a, static_cast<Scalar>(adversary.extent), random);
      ASSERT_TRUE(overlaps(a, b)) << adversary.name;
      const Vector<kD> normal = adversarial_direction<kD>(random, adversary.normal_length);
      const Interval s = project(normal, a);
      const Interval t = project(normal, b);
      ASSERT_LE(s.lo, s.hi) << adversary.name;
      ASSERT_TRUE(s.lo <= t.hi && t.lo <= s.hi) << adversary.name << " pair " << i;
      // The planes most likely to part them lie at the ends of their intervals and one ulp beside.
      for (const Scalar end : {s.lo, s.hi, t.lo, t.hi}) {
        for (const Scalar d : {std::nextafter(end, -kMax), end, std::nextafter(end, kMax)}) {
          const Sides p = classify(s, d);
          const Sides q = classify(t, d);
          ASSERT_TRUE(p.left || p.right);
          ASSERT_TRUE((p.left && q.left) || (p.right && q.right)) << adversary.name << " pair " << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
