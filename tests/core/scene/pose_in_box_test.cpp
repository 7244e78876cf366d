#include "core/scene/pose_in_box.h"

#include <gtest/gtest.h>

#include "core/scene/bounding.h"
#include "tests/support/crowd_shapes.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

template <class T>
class PoseInBox : public testing::Test {};
TYPED_TEST_SUITE(PoseInBox, test::Dimensions, test::DimensionNames);

template <int D>
Pose<D> any_pose(double angle) {
  Pose<D> pose{{}, test::turned_axes<D>(angle)};
  for (int i = 0; i < D; ++i) pose.position[i] = 17.3F - 9.1F * static_cast<Scalar>(i);
  return pose;
}

template <int D>
Box<D> box_of(const Shape<D>& shape, const Pose<D>& pose) {
  return bound<D>(VolumeKind::box, shape, precise(pose)).box;
}

/// Also where the shape's origin is not the middle of its box.
TYPED_TEST(PoseInBox, AShapeIsFoundWhereItsBoxIs) {
  constexpr int kD = TypeParam::value;
  for (const Shape<kD>& shape : test::all_shapes<kD>(1.5F))
    for (double angle = 0; angle < 6; angle += 0.37) {
      const Pose<kD> pose = any_pose<kD>(angle);
      const auto found = pose_in_box<kD>(shape, pose.axes, box_of<kD>(shape, pose));
      ASSERT_TRUE(found) << shape.index() << " at " << angle;
      EXPECT_LE(length(found->position - pose.position), 1e-5F) << shape.index() << " at " << angle;
      EXPECT_EQ(found->axes, pose.axes);
    }
}

TYPED_TEST(PoseInBox, AShapeThatIsLargerThanItsBoxIsNowhere) {
  constexpr int kD = TypeParam::value;
  for (const Shape<kD>& shape : test::all_shapes<kD>(1.5F)) {
    const Pose<kD> pose = any_pose<kD>(0.5);
    Box<kD> box = box_of<kD>(shape, pose);
    box.max[1] -= 0.05F * (box.max[1] - box.min[1]);
    EXPECT_FALSE(pose_in_box<kD>(shape, pose.axes, box)) << shape.index();
    box.max[1] = box.min[1] - 1;
    EXPECT_FALSE(pose_in_box<kD>(shape, pose.axes, box));
    box.max[1] = std::nanf("");
    EXPECT_FALSE(pose_in_box<kD>(shape, pose.axes, box));
  }
}

}  // namespace
}  // namespace kerf
