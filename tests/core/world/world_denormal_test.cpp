// Boxes as small as floats get, where the caller makes the processor take denormals for zero: they stay as
// they were given, and are found.

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "core/world/world.h"
#include "core/world/world_index.h"
#include "tests/hard/flush_to_zero.h"
#include "tests/support/dimensions.h"

namespace kerf::test {
namespace {

constexpr Scalar kTinyEnd = 0x1p-140F;

template <class T>
class WorldOfDenormals : public testing::Test {
 public:
  static constexpr int kD = T::value;

  static Box<kD> cube(Scalar low, Scalar high) {
    Box<kD> box;
    box.min.value.fill(low);
    box.max.value.fill(high);
    return box;
  }
  static ObjectDef with_margin(Scalar margin) {
    ObjectDef def;
    def.margin = margin;
    return def;
  }

  World<kD> world;
};
TYPED_TEST_SUITE(WorldOfDenormals, Dimensions, DimensionNames);

TYPED_TEST(WorldOfDenormals, BoxesStayAsTheyWereGiven) {
  const auto inner = this->cube(-kTinyEnd, kTinyEnd);
  const auto outer = this->cube(-2 * kTinyEnd, 3 * kTinyEnd);
  std::array<Handle, 4> objects;
  {
    const FlushToZero flush(true);
    for (Handle& object : objects) object = this->world.insert(inner).handle;
    (void)this->world.insert(inner, this->with_margin(1));  // moves are requests of their own from now on
    (void)this->world.move(objects[1], outer);
    (void)this->world.set_margin(objects[2], 1);
    (void)this->world.set_margin(objects[2], 0);
    (void)this->world.set_margin(objects[3], 2 * kTinyEnd);
    (void)this->world.shift_origin({});
  }
  EXPECT_EQ(this->world.box(objects[0]), inner);
  EXPECT_EQ(this->world.box(objects[1]), outer);
  EXPECT_EQ(this->world.box(objects[2]), inner);
  EXPECT_EQ(this->world.box(objects[3]), inner);
  EXPECT_EQ(this->world.fat_box(objects[3]), this->cube(-3 * kTinyEnd, 3 * kTinyEnd));
}

TYPED_TEST(WorldOfDenormals, AreFoundByTheirOwnBoxes) {
  const auto box = this->cube(kTinyEnd, 2 * kTinyEnd);
  std::vector<Handle> found;
  std::vector<Handle> objects;
  {
    const FlushToZero flush(true);
    for (const Scalar margin : {0.0F, kTinyEnd}) {
      const Handle object = this->world.insert(box, this->with_margin(margin)).handle;
      objects.push_back(object);
      WorldIndex<TestFixture::kD> index;
      index.update(this->world);
      found.clear();
      EXPECT_EQ(index.overlaps(this->world, Sphere<TestFixture::kD>{box.max, 0}, found), QueryStatus::ok);
      EXPECT_EQ(found, objects);
      found.clear();
      EXPECT_EQ(index.overlaps(this->world, Sphere<TestFixture::kD>{this->cube(0, 0).min, 0}, found),
                QueryStatus::ok);
      EXPECT_TRUE(found.empty()) << "0 is beside it";
    }
  }
}

/// As many as need blocks of blocks.
TYPED_TEST(WorldOfDenormals, AreAllFoundHoweverManyTheyAre) {
  std::vector<Handle> objects;
  std::vector<Handle> found;
  for (int k = 0; k < 100; ++k)
    objects.push_back(this->world.insert(this->cube(kTinyEnd, 2 * kTinyEnd)).handle);
  WorldIndex<TestFixture::kD> index;
  for (const bool moves : {false, true}) {
    for (const Handle object : objects)
      if (moves) (void)this->world.move(object, this->cube(2 * kTinyEnd, 3 * kTinyEnd));
    {
      const FlushToZero flush(true);
      index.update(this->world);
    }
    found.clear();
    EXPECT_EQ(index.overlaps(this->world, this->cube(2 * kTinyEnd, 2 * kTinyEnd), found), QueryStatus::ok);
    EXPECT_EQ(found, objects) << moves;
  }
}

TYPED_TEST(WorldOfDenormals, AMarginIsOneInEveryMode) {
  Handle object;
  {
    const FlushToZero flush(true);
    object = this->world.insert(this->cube(0, 1), this->with_margin(kTinyEnd)).handle;
    EXPECT_EQ(this->world.set_margin(object, -kTinyEnd), WorldStatus::bad_value);
  }
  EXPECT_EQ(this->world.remove(object), WorldStatus::ok);
  object = this->world.insert(this->cube(0, 1), this->with_margin(2)).handle;
  (void)this->world.insert(this->cube(2, 3));
  EXPECT_EQ(this->world.move(object, this->cube(0.5F, 1)), WorldStatus::ok);
  EXPECT_EQ(this->world.box(object), this->cube(0.5F, 1));
  EXPECT_EQ(this->world.fat_box(object), this->cube(-2, 3)) << "it stayed within its fat box";
}

}  // namespace
}  // namespace kerf::test
