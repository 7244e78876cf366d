#include "viz/draw/skeleton.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "tests/support/dimensions.h"
#include "tests/viz/small_scene.h"

namespace kerf {
namespace {

constexpr double kRounding = 1e-6;

template <int D>
Box<D> bounds() {
  return {test::all<D>(-1), test::all<D>(13)};
}

double above(const HalfSpace& side, const Eigen::Vector3d& p) {
  return (side.normal.dot(p) - side.offset) / side.normal.norm();
}

/// Area of a convex polygon.
double area(const Polygon& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  return 0.5 * sum.norm();
}

/// Area in 2D, volume in 3D of a convex cell given by its faces.
template <int D>
double size_of(const std::vector<Polygon>& faces) {
  if (faces.empty()) return 0;
  if constexpr (D == 2) {
    return area(faces.front());
  } else {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double count = 0;
    for (const Polygon& face : faces) {
      for (const Eigen::Vector3d& p : face) middle += p;
      count += static_cast<double>(face.size());
    }
    middle /= count;
    double volume = 0;
    for (const Polygon& face : faces) {
      const Eigen::Vector3d normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
      volume += area(face) * std::abs(normal.dot(middle - face[0])) / 3;
    }
    return volume;
  }
}

template <class T>
class SkeletonTest : public testing::Test {};
TYPED_TEST_SUITE(SkeletonTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(SkeletonTest, PartitionersLieOnTheirPlanesInTheirCells) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  Skeleton<kD> skeleton;
  skeleton.assign(&scene.tree());
  int drawn = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    if (skeleton[id].is_leaf()) return;
    const Polygon polygon = partitioner_in_cell(skeleton, id, skeleton[id].plane, bounds<kD>());
    drawn += polygon.empty() ? 0 : 1;
    for (const Eigen::Vector3d& p : polygon) {
      EXPECT_NEAR(above(half_space(skeleton[id].plane, false), p), 0, kRounding);
      for (const HalfSpace& side : skeleton.cell_sides(id)) EXPECT_LE(above(side, p), kRounding);
      for (const HalfSpace& side : half_spaces(bounds<kD>())) EXPECT_LE(above(side, p), kRounding);
    }
  });
  EXPECT_GT(drawn, 5);
}

TYPED_TEST(SkeletonTest, LeafCellsFillTheBoundsExactly) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  Skeleton<kD> skeleton;
  skeleton.assign(&scene.tree());
  double sum = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    if (skeleton[id].is_leaf()) sum += size_of<kD>(cell_faces(skeleton, id, bounds<kD>()));
  });
  EXPECT_NEAR(sum / std::pow(14.0, kD), 1, 1e-6);
}

TYPED_TEST(SkeletonTest, BackToFrontNamesEveryNodeOnceAndTheFarSideFirst) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  Skeleton<kD> skeleton;
  skeleton.assign(&scene.tree());
  const Eigen::Vector3d eye(30, 20, kD == 3 ? 50 : 0);
  const std::vector<NodeId> order = skeleton.back_to_front(eye);
  std::map<NodeId, std::size_t> place;
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_TRUE(place.emplace(order[i], i).second);
  std::size_t nodes = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    ++nodes;
    const auto& joint = skeleton[id];
    if (joint.is_leaf()) return;
    const bool eye_is_left = above(half_space(joint.plane, false), eye) <= 0;
    EXPECT_LT(place[eye_is_left ? joint.right : joint.left], place[id]);
    EXPECT_LT(place[id], place[eye_is_left ? joint.left : joint.right]);
  });
  EXPECT_EQ(nodes, order.size());
}

TYPED_TEST(SkeletonTest, NoTreeIsEmpty) {
  constexpr int kD = TypeParam::value;
  Skeleton<kD> skeleton;
  skeleton.assign(nullptr);
  EXPECT_TRUE(skeleton.empty());
  EXPECT_TRUE(skeleton.back_to_front(Eigen::Vector3d::Zero()).empty());
  EXPECT_FALSE(skeleton.is_alive({NodeId{0}, 0}));
}

TEST(PlaneWithin, MissesAndDegenerateNormalsAreEmpty) {
  const Box<3> box{{{0, 0, 0}}, {{1, 1, 1}}};
  EXPECT_EQ(plane_within<3>({{1, 0, 0}, 0.5}, box, {}).size(), 4U);
  EXPECT_TRUE(plane_within<3>({{1, 0, 0}, 2}, box, {}).empty());
  EXPECT_TRUE(plane_within<3>({{0, 0, 0}, 2}, box, {}).empty());
  EXPECT_EQ(plane_within<3>({{1, 1, 1}, 1.5}, box, {}).size(), 6U);
  EXPECT_EQ(plane_within<2>({{0, 1, 0}, 0.5}, Box<2>{{{0, 0}}, {{1, 1}}}, {}).size(), 2U);
}

}  // namespace
}  // namespace kerf
