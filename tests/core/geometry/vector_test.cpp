#include "core/geometry/vector.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/random.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

template <class T>
class VectorValue : public testing::Test {};
TYPED_TEST_SUITE(VectorValue, Dimensions, DimensionNames);

TYPED_TEST(VectorValue, IsPlainMemory) {
  constexpr int kD = TypeParam::value;
  static_assert(sizeof(Vector<kD>) == kD * sizeof(Scalar));
  static_assert(std::is_trivially_copyable_v<Vector<kD>>);
  for (int axis = 0; axis < kD; ++axis) EXPECT_EQ(Vector<kD>{}[axis], 0);
}

TYPED_TEST(VectorValue, ComputesAxisByAxis) {
  constexpr int kD = TypeParam::value;
  Vector<kD> a;
  for (int axis = 0; axis < kD; ++axis) a[axis] = static_cast<Scalar>(axis + 1);
  const Vector<kD> b = all<kD>(10);
  for (int axis = 0; axis < kD; ++axis) {
    const auto x = static_cast<Scalar>(axis + 1);
    EXPECT_EQ((a + b)[axis], x + 10);
    EXPECT_EQ((b - a)[axis], 10 - x);
    EXPECT_EQ((a * 3)[axis], 3 * x);
    EXPECT_EQ(dot(a, axis_vector<kD>(axis)), x);
  }
  EXPECT_EQ(length(axis_vector<kD>(1) * 4), 4);
}

TYPED_TEST(VectorValue, DotProductIsMonotoneInEachArgument) {
  constexpr int kD = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 100'000; ++i) {
    const Vector<kD> normal = random_point<kD>(random, 0, 1);
    const Vector<kD> p = random_point<kD>(random, -1000, 1000);
    Vector<kD> q = p;
    const auto axis = static_cast<int>(random.below(kD));
    q[axis] = std::nextafter(q[axis], std::numeric_limits<Scalar>::max());
    ASSERT_LE(dot(normal, p), dot(normal, q));
  }
}

// Fused, x*x - fl(x*x) keeps what the rounding of a product loses (HARD_CASES N1).
TYPED_TEST(VectorValue, DotProductIsNotContracted) {
  constexpr int kD = TypeParam::value;
  volatile Scalar x = 1.0F + 0x1p-12F;
  Vector<kD> a;
  Vector<kD> b;
  a[0] = x;
  b[0] = x;
  a[1] = -1;
  b[1] = x * x;
  EXPECT_EQ(dot(a, b), 0);
  std::swap(a.value[0], a.value[1]);
  std::swap(b.value[0], b.value[1]);
  EXPECT_EQ(dot(a, b), 0);
}

TYPED_TEST(VectorValue, FiniteMeansEveryComponent) {
  constexpr int kD = TypeParam::value;
  EXPECT_TRUE(is_finite(all<kD>(std::numeric_limits<Scalar>::max())));
  for (int axis = 0; axis < kD; ++axis) {
    for (const Scalar bad :
         {std::numeric_limits<Scalar>::infinity(), std::numeric_limits<Scalar>::quiet_NaN()}) {
      Vector<kD> v;
      v[axis] = bad;
      EXPECT_FALSE(is_finite(v));
    }
  }
}

}  // namespace
}  // namespace kerf::test
