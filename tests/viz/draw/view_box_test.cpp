#include "viz/draw/view_box.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"

namespace kerf {
namespace {

template <int D>
Body<D> body_at(const Vector<D>& center, Scalar half, Mobility mobility) {
  Body<D> body;
  body.shape = Ball{half};
  body.pose.position = center;
  body.box = test::box_at(center, half);
  body.mobility = mobility;
  return body;
}

template <class T>
class ViewBoxTest : public testing::Test {};
TYPED_TEST_SUITE(ViewBoxTest, test::Dimensions, test::DimensionNames);

TYPED_TEST(ViewBoxTest, HoldsEverythingSeenAndNeverShrinks) {
  constexpr int kD = TypeParam::value;
  ViewBox<kD> view;
  std::vector<Body<kD>> bodies{body_at(test::all<kD>(0), 1, Mobility::moving)};
  view.update(bodies);
  EXPECT_TRUE(contains(view.box(), bodies[0].box));
  bodies[0] = body_at(test::all<kD>(9), 1, Mobility::moving);
  view.update(bodies);
  EXPECT_TRUE(contains(view.box(), bodies[0].box));
  EXPECT_TRUE(contains(view.box(), test::box_at(test::all<kD>(0), 1)));
}

TYPED_TEST(ViewBoxTest, SlowGrowthMovesThePictureRarely) {
  constexpr int kD = TypeParam::value;
  ViewBox<kD> view;
  int changes = 0;
  for (int step = 0; step < 500; ++step) {
    const std::vector<Body<kD>> bodies{
        body_at(test::all<kD>(0), 1, Mobility::moving),
        body_at(test::all<kD>(static_cast<Scalar>(step) * 0.1F), 1, Mobility::moving)};
    const Box<kD> before = view.box();
    view.update(bodies);
    EXPECT_TRUE(contains(view.box(), bodies[1].box));
    changes += before == view.box() ? 0 : 1;
  }
  EXPECT_LE(changes, 40);
}

TYPED_TEST(ViewBoxTest, WhatFellOffOrIsBrokenIsNotFollowed) {
  constexpr int kD = TypeParam::value;
  ViewBox<kD> view;
  std::vector<Body<kD>> bodies{body_at(test::all<kD>(0), 10, Mobility::fixed),
                               body_at(test::all<kD>(1), 1, Mobility::moving)};
  view.update(bodies);
  const Box<kD> before = view.box();
  bodies.push_back(body_at(test::all<kD>(-500), 1, Mobility::moving));
  bodies.push_back(body_at(test::all<kD>(std::numeric_limits<Scalar>::quiet_NaN()), 1, Mobility::moving));
  bodies.push_back(body_at(test::all<kD>(1e30F), 1, Mobility::fixed));
  view.update(bodies);
  EXPECT_EQ(view.box(), before);
}

TYPED_TEST(ViewBoxTest, FixedBoxStays) {
  constexpr int kD = TypeParam::value;
  ViewBox<kD> view;
  const Box<kD> box = test::box_at(test::all<kD>(0), 3);
  view.fix(box);
  view.update(std::vector<Body<kD>>{body_at(test::all<kD>(100), 1, Mobility::fixed)});
  EXPECT_EQ(view.box(), box);
  EXPECT_THROW(view.fix(Box<kD>::empty()), std::invalid_argument);
  EXPECT_THROW(view.fix(test::box_at(test::all<kD>(0), 1e20F)), std::invalid_argument);
}

TYPED_TEST(ViewBoxTest, NothingSeenIsStillABox) {
  constexpr int kD = TypeParam::value;
  ViewBox<kD> view;
  view.update({});
  EXPECT_TRUE(is_valid(view.box()));
  EXPECT_GT(view.box().extent()[0], 0);
}

TYPED_TEST(ViewBoxTest, OfALargeFloorOnlyThePartAroundTheActionIsFramedIn3D) {
  constexpr int kD = TypeParam::value;
  std::vector<Body<kD>> bodies;
  for (int k = 0; k < 20; ++k)
    bodies.push_back(body_at(test::all<kD>(static_cast<Scalar>(k) * 0.5F), 0.5F, Mobility::moving));
  bodies.push_back(body_at(test::all<kD>(5), 50, Mobility::fixed));
  SceneBox<kD> scene;
  ViewBox<kD> view;
  scene.update(bodies);
  view.update(bodies);
  EXPECT_TRUE(contains(view.box(), bodies.back().box));
  EXPECT_TRUE(contains(scene.box(), test::box_at(test::all<kD>(5), 5)));
  EXPECT_EQ(scene.box().extent()[0] < 20, kD == 3);
  EXPECT_EQ(scene.box() == view.box(), kD == 2);
}

TYPED_TEST(ViewBoxTest, EverythingAskedForIsFramedWhole) {
  constexpr int kD = TypeParam::value;
  const std::vector<Body<kD>> bodies{body_at(test::all<kD>(0), 1, Mobility::moving),
                                     body_at(test::all<kD>(5), 50, Mobility::fixed)};
  SceneBox<kD> scene(Framing::everything);
  scene.update(bodies);
  EXPECT_TRUE(contains(scene.box(), bodies.back().box));
}

TYPED_TEST(ViewBoxTest, AFloorAloneIsFramedWhole) {
  constexpr int kD = TypeParam::value;
  const std::vector<Body<kD>> bodies{body_at(test::all<kD>(5), 50, Mobility::fixed)};
  SceneBox<kD> scene;
  scene.update(bodies);
  EXPECT_TRUE(contains(scene.box(), bodies.back().box));
}

}  // namespace
}  // namespace kerf
