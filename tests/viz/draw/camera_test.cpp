#include "viz/draw/camera.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/viz/message_of.h"

namespace kerf {
namespace {

using Point = Eigen::Vector3d;

constexpr int kWidth = 640;
constexpr int kHeight = 360;
constexpr Viewport kViewport{10, 40, 600, 280};

template <int D>
std::string error_of(const char* text) {
  return test::message_of<std::invalid_argument>([&] { (void)parse_camera<D>(text); });
}

TEST(ParseCamera, ReadsEveryKey) {
  const auto camera = parse_camera<3>("yaw=-45,pitch=90,fov=60,distance=12.5,target=1:-2:3e1");
  EXPECT_EQ(camera.yaw, -45);
  EXPECT_EQ(camera.pitch, 90);
  EXPECT_EQ(camera.fov, 60);
  EXPECT_EQ(camera.distance, 12.5);
  EXPECT_EQ(camera.target, Point(1, -2, 30));
  const auto flat = parse_camera<2>("center=3:-4,width=20");
  EXPECT_EQ(flat.center, Eigen::Vector2d(3, -4));
  EXPECT_EQ(flat.width, 20);
}

TEST(ParseCamera, NothingIsTheDefault) {
  EXPECT_EQ(parse_camera<3>("").distance, std::nullopt);
  EXPECT_EQ(parse_camera<2>("").width, std::nullopt);
}

TEST(ParseCamera, JunkIsRefusedWithWhatIsValid) {
  for (const char* text :
       {"yaw", "yaw=", "yaw=x", "yaw=1x", "yaw=nan", "yaw=inf", "roll=3", "yaw=1,", "pitch=91", "fov=0",
        "distance=0", "distance=-1", "target=1:2", "target=1:2:3:4", "target=1,2,3"})
    EXPECT_THAT(error_of<3>(text), testing::HasSubstr("target=X:Y:Z")) << text;
  for (const char* text : {"width=0", "center=1", "yaw=3", "width"})
    EXPECT_THAT(error_of<2>(text), testing::HasSubstr("center=X:Y")) << text;
}

TEST(ParseCamera, NothingLiesFartherThanFramesCanShow) {
  EXPECT_THAT(error_of<2>("center=1e308:0"), testing::HasSubstr("out of range for center"));
  EXPECT_THAT(error_of<3>("target=0:-1e300:0"), testing::HasSubstr("out of range for target"));
  EXPECT_EQ(parse_camera<2>("center=1e12:-1e12").center->x(), 1e12);
}

TEST(FrameAll, HoldsTheWholeBoxAndFillsTheViewport3d) {
  const Box<3> box{{{-30, -2, -5}}, {{10, 8, 45}}};
  for (const double yaw : {0.0, 30.0, 135.0, 270.0}) {
    for (const double pitch : {-20.0, 0.0, 38.0, 90.0}) {
      CameraChoice<3> choice;
      choice.yaw = yaw;
      choice.pitch = pitch;
      const View view = frame_all(box, choice, kViewport, kWidth, kHeight);
      double slack = 1e9;
      for (int i = 0; i < 8; ++i) {
        const Point corner(i & 1 ? box.max[0] : box.min[0], i & 2 ? box.max[1] : box.min[1],
                           i & 4 ? box.max[2] : box.min[2]);
        const auto pixel = view.project(corner);
        ASSERT_TRUE(pixel.has_value()) << yaw << " " << pitch;
        const double left = pixel->x() - kViewport.left;
        const double top = pixel->y() - kViewport.top;
        for (const double x : {left, kViewport.width - left}) slack = std::min(slack, x / kViewport.width);
        for (const double y : {top, kViewport.height - top}) slack = std::min(slack, y / kViewport.height);
      }
      EXPECT_GE(slack, 0.01) << yaw << " " << pitch;
      EXPECT_LE(slack, 0.03) << yaw << " " << pitch;
    }
  }
}

TEST(FrameAll, HoldsTheWholeBoxAndFillsTheViewport2d) {
  for (const Box<2>& box : {Box<2>{{{-3, 0}}, {{3, 1}}}, Box<2>{{{100, 0}}, {{101, 50}}}}) {
    const View view = frame_all(box, {}, kViewport, kWidth, kHeight);
    const Eigen::Vector2d low = *view.project({box.min[0], box.min[1], 0});
    const Eigen::Vector2d high = *view.project({box.max[0], box.max[1], 0});
    EXPECT_LT(high.y(), low.y()) << "y goes up";
    EXPECT_NEAR(std::max((high.x() - low.x()) / kViewport.width, (low.y() - high.y()) / kViewport.height),
                0.96, 1e-6);
    EXPECT_NEAR(low.x() + high.x(), 2 * kViewport.left + kViewport.width, 1e-6);
    EXPECT_NEAR(low.y() + high.y(), 2 * kViewport.top + kViewport.height, 1e-6);
  }
}

TEST(FrameAll, ObeysTheChoice) {
  const Box<3> box{{{-1, -1, -1}}, {{1, 1, 1}}};
  const View view =
      frame_all(box, parse_camera<3>("yaw=0,pitch=0,distance=40,target=5:6:7"), kViewport, kWidth, kHeight);
  EXPECT_LT((view.eye - Point(5, 6, 47)).norm(), 1e-9);
  EXPECT_LT((*view.project({5, 6, 7}) - Eigen::Vector2d(310, 180)).norm(), 1e-6);
  const View flat = frame_all(Box<2>{{{0, 0}}, {{1, 1}}}, parse_camera<2>("center=9:9,width=3"), kViewport,
                              kWidth, kHeight);
  EXPECT_NEAR(flat.pixels_per_unit({0, 0, 0}), 200, 1e-9);
  EXPECT_LT((*flat.project({9, 9, 0}) - Eigen::Vector2d(310, 180)).norm(), 1e-6);
}

TEST(FrameAll, UpIsYAndRightIsRight) {
  const View view =
      frame_all(Box<3>{{{-1, -1, -1}}, {{1, 1, 1}}}, parse_camera<3>("yaw=0"), kViewport, kWidth, kHeight);
  const Eigen::Vector2d middle = *view.project({0, 0, 0});
  EXPECT_LT(view.project({0, 1, 0})->y(), middle.y());
  EXPECT_GT(view.project({1, 0, 0})->x(), middle.x());
}

TEST(View, DepthIsAShareOfTheFramedBox) {
  const Box<3> box{{{-1, -1, -1}}, {{1, 1, 1}}};
  const View view = frame_all(box, parse_camera<3>("front"), kViewport, kWidth, kHeight);
  EXPECT_NEAR(view.depth_share({0, 0, 1}), 0, 1e-9);
  EXPECT_NEAR(view.depth_share({0, 0, 0}), 0.5, 1e-9);
  EXPECT_NEAR(view.depth_share({1, 1, -1}), 1, 1e-9);
  EXPECT_EQ(view.depth_share({0, 0, -50}), 1);
  EXPECT_EQ(view.depth_share({0, 0, 50}), 0);
  EXPECT_EQ(frame_all(Box<2>{{{0, 0}}, {{1, 1}}}, {}, kViewport, kWidth, kHeight).depth_share({0, 0, 0}), 0);
}

TEST(View, NothingBehindTheEyeIsProjected) {
  const View view = frame_all(Box<3>{{{-1, -1, -1}}, {{1, 1, 1}}}, {}, kViewport, kWidth, kHeight);
  EXPECT_FALSE(view.project(view.eye - view.forward).has_value());
}

TEST(Camera, TheWordAllAsksForEverything) {
  EXPECT_EQ(parse_camera<2>("").framing, Framing::most);
  EXPECT_EQ(parse_camera<2>("all").framing, Framing::everything);
  EXPECT_EQ(parse_camera<3>("yaw=60,all").framing, Framing::everything);
  EXPECT_EQ(parse_camera<3>("all,yaw=60").yaw, 60);
  EXPECT_FALSE(parse_camera<3>("all,yaw=60").is_aimed());
  EXPECT_TRUE(parse_camera<3>("distance=60").is_aimed());
  EXPECT_TRUE(parse_camera<2>("width=60").is_aimed());
  EXPECT_THROW(parse_camera<2>("all=1"), std::invalid_argument);
  EXPECT_THROW(parse_camera<3>("all,"), std::invalid_argument);
  EXPECT_EQ(parse_camera<3>("top").pitch, 90);
  EXPECT_EQ(parse_camera<3>("side,all").yaw, 90);
  EXPECT_EQ(parse_camera<3>("side,all").framing, Framing::everything);
  EXPECT_EQ(parse_camera<3>("iso,yaw=60").yaw, 60);
  EXPECT_NEAR(parse_camera<3>("iso,yaw=60").pitch, 35.264, 1e-9);
  EXPECT_THROW(parse_camera<3>("iso=3"), std::invalid_argument);
  EXPECT_THROW(parse_camera<3>("yaw=3,yaw=4"), std::invalid_argument);
  for (const char* const undone : {"iso,top", "yaw=3,top", "pitch=3,all,side"})
    EXPECT_THROW(parse_camera<3>(undone), std::invalid_argument) << undone;
  EXPECT_THROW(parse_camera<2>("top"), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
