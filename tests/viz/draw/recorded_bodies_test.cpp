#include "viz/draw/recorded_bodies.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/boxes.h"
#include "tests/support/crowd_shapes.h"
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

template <int D>
Looks<D> looks_of(std::initializer_list<Look<D>> list) {
  Looks<D> looks;
  std::uint32_t id = 0;
  for (const Look<D>& look : list) looks.set({id++}, look);
  return looks;
}

/// What has no shape is its box; a shape stands in the middle of its box.
TYPED_TEST(RecordedBodies, HaveTheShapesThatWereRecorded) {
  constexpr int kD = TypeParam::value;
  ObjectTable<kD> objects(VolumeKind::box);
  for (std::uint32_t id = 0; id < 4; ++id)
    (void)objects.insert({id}, test::box_at<kD>(test::all<kD>(5), 1), Mobility::moving);
  (void)objects.remove({3});
  const std::vector<Shape<kD>> shapes = test::all_shapes<kD>(0.9F);
  const auto axes = test::turned_axes<kD>(0.4);
  ObjectMarks marks;
  marks.set({2}, {"wheel", Rgb{1, 2, 3}});
  const auto looks = looks_of<kD>({{0, {}, {}}, {1, turn_of<kD>(axes), {}}, {}, {0, {}, {}}});
  const auto bodies = recorded_bodies<kD>(objects, {looks, shapes, marks});
  ASSERT_EQ(bodies.size(), 4U);
  EXPECT_EQ(bodies[0].shape, shapes[0]);
  EXPECT_EQ(bodies[0].pose.position, test::box_at<kD>(test::all<kD>(5), 1).center());
  EXPECT_EQ(bodies[1].shape, shapes[1]);
  EXPECT_LE(length(bodies[1].pose.axes[0] - axes[0]), 0x1p-11F);
  EXPECT_EQ(bodies[2].shape, Shape<kD>(Brick<kD>{bodies[2].box.extent() * 0.5F}));
  EXPECT_EQ(bodies[1].color, std::nullopt);
  EXPECT_EQ(own_color(bodies[2].mobility, bodies[2].color), (Color{1, 2, 3}));
  EXPECT_FALSE(is_drawable(bodies[3]));
}

TYPED_TEST(RecordedBodies, AShapeThatIsLargerThanItsBoxIsDamage) {
  constexpr int kD = TypeParam::value;
  ObjectTable<kD> objects(VolumeKind::box);
  (void)objects.insert({0}, test::box_at<kD>(test::all<kD>(5), 1), Mobility::moving);
  const std::vector<Shape<kD>> shapes{Ball{3}};
  EXPECT_THAT(
      [&] {
        const auto looks = looks_of<kD>({{0, {}, {}}});
        (void)recorded_bodies<kD>(objects, {looks, shapes, ObjectMarks()});
      },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("damaged: the shape of object 0")));
}

}  // namespace
}  // namespace kerf
