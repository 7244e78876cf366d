#include "viz/draw/gliding_box.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/boxes.h"
#include "tests/support/dimensions.h"
#include "viz/draw/frame_planner.h"

namespace kerf {
namespace {

template <class T>
class GlidingBoxTest : public testing::Test {};
TYPED_TEST_SUITE(GlidingBoxTest, test::Dimensions, test::DimensionNames);

/// A box around the origin, from there to its sides.
template <int D>
Box<D> around(Scalar half) {
  return test::box_at(test::all<D>(0), half);
}

TYPED_TEST(GlidingBoxTest, GoesOverToALargerBoxInSmallStepsAndComesToRest) {
  constexpr int kD = TypeParam::value;
  GlidingBox<kD> glide;
  glide.go_on(around<kD>(10), around<kD>(10));
  EXPECT_EQ(glide.box(), around<kD>(10)) << "the first frame has all of it";
  int frames = 0;
  for (; glide.box() != around<kD>(12) && frames < 20; ++frames) {
    const Scalar before = glide.box()->max[0];
    glide.go_on(around<kD>(12), around<kD>(10));
    EXPECT_GT(glide.box()->max[0], before);
    EXPECT_LE(glide.box()->max[0] - before, 0.55F) << frames;
  }
  EXPECT_EQ(frames, 4);
}

TYPED_TEST(GlidingBoxTest, ShowsWhatAFrameNeedsAtOnce) {
  constexpr int kD = TypeParam::value;
  GlidingBox<kD> glide;
  glide.go_on(around<kD>(10), around<kD>(10));
  glide.go_on(around<kD>(20), around<kD>(18));
  EXPECT_EQ(glide.box(), around<kD>(18));
  glide.go_on(around<kD>(20), std::nullopt);
  EXPECT_TRUE(contains(*glide.box(), around<kD>(18)));
  EXPECT_NE(glide.box(), around<kD>(20));
}

/// Before the first object the view is one that no object has asked for.
TYPED_TEST(GlidingBoxTest, GoesToABoxElsewhereAtOnce) {
  constexpr int kD = TypeParam::value;
  GlidingBox<kD> glide;
  glide.go_on(around<kD>(1), std::nullopt);
  const Box<kD> elsewhere = test::box_at(test::all<kD>(50), 5);
  glide.go_on(elsewhere, elsewhere);
  EXPECT_EQ(glide.box(), elsewhere);
}

/// A live scene does not know what comes: its camera zoomed out by an eighth from one frame to the next.
TYPED_TEST(GlidingBoxTest, AnObjectThatFliesOffMovesTheCameraOfALiveSceneSmoothly) {
  constexpr int kD = TypeParam::value;
  FramePlanner<kD> planner(LayerSet::parse("objects"), 1);
  planner.glide();
  std::vector<Body<kD>> bodies(6);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bodies[k].box = test::box_at(test::all<kD>(2 * static_cast<Scalar>(k)), 1);
    bodies[k].pose.position = bodies[k].box.center();
    bodies[k].shape = Ball{1};
  }
  FrameInput<kD> input;
  input.bodies = bodies;
  Box<kD> before = planner.plan(input).bounds;
  Scalar most = 0;
  for (int frame = 0; frame < 60; ++frame) {
    Body<kD>& flying = bodies.back();
    flying.pose.position[0] += 0.1F;
    flying.box = test::box_at(flying.pose.position, 1);
    const Box<kD> now = planner.plan(input).bounds;
    EXPECT_TRUE(contains(now, flying.box)) << frame;
    most = std::max(most, (now.extent()[0] - before.extent()[0]) / before.extent()[0]);
    before = now;
  }
  EXPECT_GT(before.extent()[0], 15) << "it has grown";
  EXPECT_LT(most, 0.05F);
}

}  // namespace
}  // namespace kerf
