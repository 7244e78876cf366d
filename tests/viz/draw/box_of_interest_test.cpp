#include "viz/draw/box_of_interest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/base/random.h"
#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "viz/draw/view_box.h"

namespace kerf {
namespace {

constexpr int kMany = 60;

template <int D>
Body<D> body_at(const Vector<D>& center, Scalar half, Mobility mobility = Mobility::moving) {
  Body<D> body;
  body.shape = Ball{half};
  body.pose.position = center;
  body.box = test::box_at(center, half);
  body.mobility = mobility;
  return body;
}

/// Spread evenly between 0 and 10 on each axis.
template <int D>
std::vector<Body<D>> crowd() {
  Random random(3);
  std::vector<Body<D>> bodies;
  for (int k = 0; k < kMany; ++k) {
    Vector<D> center;
    for (int i = 0; i < D; ++i) center[i] = static_cast<Scalar>(random.uniform(0, 10));
    bodies.push_back(body_at(center, 0.5F));
  }
  return bodies;
}

template <int D>
Box<D> most(const std::vector<Body<D>>& bodies) {
  return *box_of_interest(std::span<const Body<D>>(bodies), Framing::most);
}

template <int D>
Box<D> everything(const std::vector<Body<D>>& bodies) {
  return *box_of_interest(std::span<const Body<D>>(bodies), Framing::everything);
}

template <class T>
class BoxOfInterest : public testing::Test {};
TYPED_TEST_SUITE(BoxOfInterest, test::Dimensions, test::DimensionNames);

TYPED_TEST(BoxOfInterest, AnOrdinaryCrowdIsWhole) {
  constexpr int kD = TypeParam::value;
  auto bodies = crowd<kD>();
  EXPECT_EQ(most(bodies), everything(bodies));
  bodies.push_back(body_at(test::all<kD>(5), 60, Mobility::fixed));  // a floor
  EXPECT_EQ(most(bodies), everything(bodies));
}

TYPED_TEST(BoxOfInterest, OneFarAwayLeavesThePictureAsItWas) {
  constexpr int kD = TypeParam::value;
  const auto near = crowd<kD>();
  for (const Scalar distance : {-5e8F, -4000.0F, 300.0F, 1e9F, 1e30F}) {
    for (const Mobility mobility : {Mobility::moving, Mobility::fixed}) {
      if (mobility == Mobility::fixed && std::abs(distance) < 1e4F) continue;
      auto bodies = near;
      bodies.push_back(body_at(test::all<kD>(distance), 0.5F, mobility));
      EXPECT_EQ(most(bodies), most(near)) << distance;
      EXPECT_EQ(count_outside(std::span<const Body<kD>>(bodies), most(bodies)), 1U) << distance;
    }
  }
}

TYPED_TEST(BoxOfInterest, AFloorWithoutEndIsCutNearTheCrowd) {
  constexpr int kD = TypeParam::value;
  auto bodies = crowd<kD>();
  const Scalar size = most(bodies).extent()[0];
  bodies.push_back(body_at(test::all<kD>(0), 1e8F, Mobility::fixed));
  EXPECT_TRUE(contains(most(bodies), bodies.front().box));
  EXPECT_LT(most(bodies).extent()[0], 4 * size);
  EXPECT_EQ(count_outside(std::span<const Body<kD>>(bodies), most(bodies)), 0U);
}

/// A post beside them does not show where they are.
TYPED_TEST(BoxOfInterest, ASmallFixedObjectDoesNotHideTheCrowd) {
  constexpr int kD = TypeParam::value;
  auto bodies = crowd<kD>();
  bodies.push_back(body_at(test::all<kD>(-1), 0.1F, Mobility::fixed));
  EXPECT_EQ(most(bodies), everything(bodies));
}

TYPED_TEST(BoxOfInterest, OfTwoNoneIsTheFarOne) {
  constexpr int kD = TypeParam::value;
  const std::vector<Body<kD>> bodies{body_at(test::all<kD>(0), 1), body_at(test::all<kD>(5000), 1)};
  EXPECT_EQ(most(bodies), everything(bodies));
}

/// It is seen as long as it is near; from then on nothing moves because of it.
TYPED_TEST(BoxOfInterest, WhatFallsForEverIsFollowedNotFar) {
  constexpr int kD = TypeParam::value;
  auto bodies = crowd<kD>();
  ViewBox<kD> view;
  bodies.push_back(body_at(test::all<kD>(12), 0.5F));
  int changes = 0;
  for (int step = 0; step < 1200; ++step) {
    const Scalar time = static_cast<Scalar>(step) / 60;
    Vector<kD> place = test::all<kD>(12);
    place[1] -= 4.905F * time * time;
    bodies.back() = body_at(place, 0.5F);
    const Box<kD> before = view.box();
    view.update(bodies);
    if (!(before == view.box())) ++changes;
  }
  EXPECT_LT(view.box().extent()[1], 50);
  EXPECT_LT(changes, 20);
}

TYPED_TEST(BoxOfInterest, WhereAllIsFarAwayThatIsTheView) {
  constexpr int kD = TypeParam::value;
  for (const Scalar far : {1e9F, 1e12F, 9e17F}) {
    std::vector<Body<kD>> bodies;
    for (int k = 0; k < kMany; ++k)
      bodies.push_back(body_at(test::all<kD>(far * (1 + 0.001F * static_cast<Scalar>(k))), 1e-4F * far));
    SceneBox<kD> view;
    view.update(bodies);
    EXPECT_TRUE(contains(view.box(), everything(bodies))) << far;
    EXPECT_EQ(count_outside(std::span<const Body<kD>>(bodies), view.box()), 0U) << far;
  }
}

/// What flies away later does not take the view with it.
TYPED_TEST(BoxOfInterest, TheViewStaysWhereTheCrowdHasBeen) {
  constexpr int kD = TypeParam::value;
  const auto near = crowd<kD>();
  SceneBox<kD> view;
  view.update(near);
  const Box<kD> before = view.box();
  view.update(std::vector<Body<kD>>(kMany, body_at(test::all<kD>(1e12F), 0.5F)));
  EXPECT_EQ(view.box(), before);
}

TYPED_TEST(BoxOfInterest, EverythingIsAllThatIsFinite) {
  constexpr int kD = TypeParam::value;
  auto bodies = crowd<kD>();
  bodies.push_back(body_at(test::all<kD>(2e9F), 1));
  bodies.push_back(body_at(test::all<kD>(std::numeric_limits<Scalar>::quiet_NaN()), 1));
  EXPECT_TRUE(contains(everything(bodies), bodies[kMany].box));
  EXPECT_TRUE(is_valid(everything(bodies)));
}

}  // namespace
}  // namespace kerf
