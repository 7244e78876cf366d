#include "viz/draw/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/geometry/vector.h"

namespace kerf {
namespace {

const Box<3> kBounds{{{-10, -4, -10}}, {{10, 10, 10}}};

Body<3> block(const Vector<3>& center, const Vector<3>& half, Mobility mobility = Mobility::fixed) {
  Body<3> body;
  body.shape = Brick<3>{half};
  body.pose.position = center;
  body.box = {center - half, center + half};
  body.mobility = mobility;
  return body;
}

TEST(Ground, IsTheHighestTopBelowAPoint) {
  const std::vector<Body<3>> bodies{block({{0, -1, 0}}, {{9, 1, 9}}), block({{2, 1, 2}}, {{1, 1, 1}}),
                                    block({{-5, 3, -5}}, {{1, 1, 1}}, Mobility::moving)};
  const Ground ground(bodies, kBounds);
  EXPECT_EQ(ground.below({-5, 8, -5}).height, 0) << "what moves is no ground";
  EXPECT_EQ(ground.below({2.5, 8, 1.5}).height, 2);
  EXPECT_EQ(ground.below({2.5, 1, 1.5}).height, 0) << "a top above the point is not below it";
  EXPECT_TRUE(ground.below({2.5, 8, 1.5}).is_body);
}

TEST(Ground, ElsewhereIsTheLowerEndOfTheBounds) {
  const std::vector<Body<3>> bodies{block({{0, -1, 0}}, {{2, 1, 2}})};
  const GroundPlane plane = Ground(bodies, kBounds).below({8, 3, 8});
  EXPECT_EQ(plane.height, -4);
  EXPECT_FALSE(plane.is_body);
  EXPECT_EQ(Ground({}, kBounds).below({1e9, 3, -1e9}).height, -4);
}

TEST(Ground, ATiltedBoxIsNone) {
  Body<3> tilted = block({{0, 1, 0}}, {{2, 1, 2}});
  const auto c = static_cast<Scalar>(std::cos(0.4));
  const auto s = static_cast<Scalar>(std::sin(0.4));
  tilted.pose.axes = {{{{c, s, 0}}, {{-s, c, 0}}, {{0, 0, 1}}}};
  const std::vector<Body<3>> bodies{tilted};
  EXPECT_FALSE(Ground(bodies, kBounds).below({0, 8, 0}).is_body);
}

TEST(Ground, ASurfaceHasItsHeightAndSlope) {
  Surface surface;
  surface.vertices = {{{-4, 0, -4}}, {{4, 4, -4}}, {{4, 4, 4}}, {{-4, 0, 4}}};
  surface.triangles = {{0, 2, 1}, {0, 3, 2}, {7, 8, 9}};
  Body<3> hill;
  hill.shape = std::make_shared<const Surface>(surface);
  hill.pose.position = {{1, 0, 0}};
  hill.box = {{{-3, 0, -4}}, {{5, 4, 4}}};
  hill.mobility = Mobility::fixed;
  const std::vector<Body<3>> bodies{hill};
  const Ground ground(bodies, kBounds);
  const GroundPlane plane = ground.below({1, 9, 2});
  EXPECT_NEAR(plane.height, 2, 1e-6);
  EXPECT_NEAR(plane.slope_x, 0.5, 1e-6);
  EXPECT_NEAR(plane.slope_z, 0, 1e-6);
  EXPECT_FALSE(ground.below({1, 1, 2}).is_body) << "under the hill";
}

}  // namespace
}  // namespace kerf
