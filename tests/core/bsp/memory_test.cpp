#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <vector>

#include "core/bsp/bsp.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

static_assert(sizeof(Entry) == 20);

/// Bytes that the C library has given out: all that lists have room for, used or not.
double bytes_in_use() {
  const auto all = mallinfo2();
  return static_cast<double>(all.uordblks + all.hblkhd);
}

/// What a tree takes after some steps, an object, without the list of pairs: by luck that has room for up to
/// half as many more. The boxes have side 1 and some four pairs each, and go up to `way` along each axis in
/// each step.
template <int D>
double bytes_an_object(std::uint32_t count, double way, Mode mode) {
  const double world = std::pow(count * std::pow(2, D - 1) / 4, 1.0 / D);
  Random random(5);
  std::vector<ObjectId> objects(count);
  std::vector<Box<D>> boxes(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    objects[k] = {k};
    boxes[k] = box_at<D>(random_point<D>(random, 0, world), 0.5F);
  }
  const double before = bytes_in_use();
  Bsp<D> tree(tuned_config());
  for (std::uint32_t k = 0; k < count; ++k)
    EXPECT_EQ(tree.insert(objects[k], boxes[k], Mobility::moving), Status::ok);
  tree.step();
  for (int step = 0; step < 6; ++step) {
    for (Box<D>& box : boxes) {
      const Vector<D> by = random_point<D>(random, -way, way);
      box = {box.min + by, box.max + by};
    }
    EXPECT_EQ(tree.move_many(objects, boxes), Status::ok);
    tree.step();
  }
  EXPECT_EQ(tree.mode(), mode);
  {
    PairBuffer pairs;
    tree.exchange_pairs(pairs);
  }
  return (bytes_in_use() - before) / count;
}

/// With sanitizers the C library gives out nothing, and all that is measured is 0.
template <class T>
class Memory : public testing::Test {
 protected:
  /// What a process has once, as the set of directions, is there before.
  static void SetUpTestSuite() {
    (void)kept(4250);
    (void)swept(4250);
  }
  static double kept(std::uint32_t count) { return bytes_an_object<T::value>(count, 0.002, Mode::kept); }
  static double swept(std::uint32_t count) { return bytes_an_object<T::value>(count, 0.5, Mode::swept); }
};
TYPED_TEST_SUITE(Memory, Dimensions, DimensionNames);

TYPED_TEST(Memory, OfASettledWorldIsBounded) {
  EXPECT_LT(TestFixture::kept(4250), TypeParam::value == 2 ? 183 : 235);
  EXPECT_LT(TestFixture::kept(16000), TypeParam::value == 2 ? 161 : 219);
}

TYPED_TEST(Memory, OfAWorldThatFliesIsBounded) {
  EXPECT_LT(TestFixture::swept(4250), TypeParam::value == 2 ? 95 : 141);
  EXPECT_LT(TestFixture::swept(16000), TypeParam::value == 2 ? 85 : 130);
}

/// In 3D so many boxes are more than is read fast, so that those of each leaf are copied, too.
TYPED_TEST(Memory, OfALargeWorldThatFliesIsBounded) {
  EXPECT_LT(TestFixture::swept(120000), TypeParam::value == 2 ? 83 : 198);
}

}  // namespace
}  // namespace kerf::test
