#include "viz/draw/recorded_bodies.h"

#include <gtest/gtest.h>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "viz/draw/draw_context.h"
#include "viz/draw/view_box.h"

namespace kerf {
namespace {

template <class T>
class RecordedBodies : public testing::Test {};
TYPED_TEST_SUITE(RecordedBodies, test::Dimensions, test::DimensionNames);

/// An absent object, or one with a broken box, keeps its number, is not drawn, and moves no view.
TYPED_TEST(RecordedBodies, OnlyWhatIsPresentIsDrawnAndCounted) {
  constexpr int kD = TypeParam::value;
  ObjectTable<kD> objects(VolumeKind::box);
  (void)objects.insert({0}, test::slab<kD>(0, 1), Mobility::moving);
  (void)objects.insert({1}, test::slab<kD>(2, 3), Mobility::moving);
  (void)objects.insert({2}, test::slab<kD>(4, 5), Mobility::fixed);
  (void)objects.insert({3}, Box<kD>::empty(), Mobility::moving);
  (void)objects.remove({1});
  const auto bodies = recorded_bodies(objects);
  ASSERT_EQ(bodies.size(), 4U);
  EXPECT_TRUE(is_drawable(bodies[0]));
  EXPECT_FALSE(is_drawable(bodies[1]));
  EXPECT_TRUE(is_drawable(bodies[2]));
  EXPECT_FALSE(is_drawable(bodies[3]));
  EXPECT_EQ(bodies[2].mobility, Mobility::fixed);
  EXPECT_EQ(bodies[0].box, test::slab<kD>(0, 1));
  EXPECT_EQ(count_moving(objects), 2U);  // a broken box is one that moves, too

  ViewBox<kD> all;
  all.update(std::span<const Body<kD>>(bodies));
  ViewBox<kD> present;
  const std::vector<Body<kD>> those{bodies[0], bodies[2]};
  present.update(std::span<const Body<kD>>(those));
  EXPECT_EQ(all.box(), present.box());
}

}  // namespace
}  // namespace kerf
