#include "viz/draw/cells.h"

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
class Cells : public testing::Test {};
TYPED_TEST_SUITE(Cells, test::Dimensions, test::DimensionNames);

TYPED_TEST(Cells, PartitionersLieOnTheirPlanesInTheirCells) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  TreeSnapshotOf<kD> snapshot;
  snapshot.assign(&scene.tree());
  int drawn = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    if (snapshot[id].is_leaf()) return;
    const Polygon polygon = partitioner_in_cell(snapshot, id, bounds<kD>());
    drawn += polygon.empty() ? 0 : 1;
    for (const Eigen::Vector3d& p : polygon) {
      EXPECT_NEAR(above(half_space(snapshot.plane(id), false), p), 0, kRounding);
      for (const HalfSpace& side : cell_sides(snapshot, id)) EXPECT_LE(above(side, p), kRounding);
      for (const HalfSpace& side : half_spaces(bounds<kD>())) EXPECT_LE(above(side, p), kRounding);
    }
  });
  EXPECT_GT(drawn, 5);
}

TYPED_TEST(Cells, LeafCellsFillTheBoundsExactly) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  TreeSnapshotOf<kD> snapshot;
  snapshot.assign(&scene.tree());
  double sum = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    if (snapshot[id].is_leaf()) sum += size_of<kD>(cell_faces(snapshot, id, bounds<kD>()));
  });
  EXPECT_NEAR(sum / std::pow(14.0, kD), 1, 1e-6);
}

TYPED_TEST(Cells, BackToFrontNamesEveryNodeOnceAndTheFarSideFirst) {
  constexpr int kD = TypeParam::value;
  const test::SmallScene<kD> scene;
  TreeSnapshotOf<kD> snapshot;
  snapshot.assign(&scene.tree());
  const Eigen::Vector3d eye(30, 20, kD == 3 ? 50 : 0);
  const std::vector<NodeId> order = back_to_front(snapshot, eye);
  std::map<NodeId, std::size_t> place;
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_TRUE(place.emplace(order[i], i).second);
  std::size_t nodes = 0;
  for_each_node(scene.tree(), scene.tree().root(), [&](NodeId id) {
    ++nodes;
    const auto& node = snapshot[id];
    if (node.is_leaf()) return;
    const bool eye_is_left = above(half_space(snapshot.plane(id), false), eye) <= 0;
    EXPECT_LT(place[eye_is_left ? node.right : node.left], place[id]);
    EXPECT_LT(place[id], place[eye_is_left ? node.left : node.right]);
  });
  EXPECT_EQ(nodes, order.size());
}

TYPED_TEST(Cells, NoTreeIsEmpty) {
  constexpr int kD = TypeParam::value;
  TreeSnapshotOf<kD> snapshot;
  snapshot.assign(nullptr);
  EXPECT_TRUE(snapshot.empty());
  EXPECT_TRUE(back_to_front(snapshot, Eigen::Vector3d::Zero()).empty());
  EXPECT_FALSE(snapshot.is_alive({NodeId{0}, 0}));
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
