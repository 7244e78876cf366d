#include "viz/draw/camera_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/viz/message_of.h"

namespace kerf {
namespace {

TEST(CameraPath, GoesThroughItsKeyFramesAndStandsStillOutside) {
  const CameraPath<3> path("10 yaw=0,pitch=20\n20 yaw=90\n# a remark\n\n40 yaw=100,distance=5 # the end\n");
  CameraChoice<3> fixed;
  fixed.fov = 50;
  EXPECT_DOUBLE_EQ(path.at(0, fixed).yaw, 0);
  EXPECT_DOUBLE_EQ(path.at(10, fixed).yaw, 0);
  EXPECT_DOUBLE_EQ(path.at(20, fixed).yaw, 90);
  EXPECT_DOUBLE_EQ(path.at(40, fixed).yaw, 100);
  EXPECT_DOUBLE_EQ(path.at(99, fixed).yaw, 100);
  EXPECT_DOUBLE_EQ(path.at(30, fixed).pitch, 20) << "given once, it holds";
  EXPECT_DOUBLE_EQ(path.at(30, fixed).fov, 50) << "what the path does not say is as it was";
  EXPECT_DOUBLE_EQ(path.at(1, fixed).distance.value(), 5);
  EXPECT_FALSE(path.at(1, fixed).target.has_value());
}

TEST(CameraPath, ADirectionIsBothOfItsAngles) {
  const CameraPath<3> path("10 top\n20 fov=40,side");
  EXPECT_DOUBLE_EQ(path.at(10, {}).pitch, 90);
  EXPECT_DOUBLE_EQ(path.at(10, {}).yaw, 0);
  EXPECT_DOUBLE_EQ(path.at(20, {}).pitch, 0);
  EXPECT_DOUBLE_EQ(path.at(20, {}).yaw, 90);
}

TEST(CameraPath, IsSmoothAndNeverOvershoots) {
  const CameraPath<2> path("0 width=1\n10 width=100\n20 width=100\n30 width=10");
  double before = 1;
  double fastest_change = 0;
  double speed = 0;
  for (int i = 1; i <= 300; ++i) {
    const double width = path.at(0.1 * i, {}).width.value();
    EXPECT_GE(width, 1 - 1e-9);
    EXPECT_LE(width, 100 + 1e-9);
    EXPECT_TRUE(i > 200 || width >= before - 1e-9);
    const double now = std::log(width / before);
    fastest_change = std::max(fastest_change, std::abs(now - speed));
    speed = now;
    before = width;
  }
  EXPECT_LT(fastest_change, 0.01) << "a jerk";
}

TEST(CameraPath, ErrorsNameTheLine) {
  const auto message = [](const char* text) {
    return test::message_of<std::invalid_argument>([&] { CameraPath<3>{text}; });
  };
  EXPECT_THAT(message("1 yaw=0\nyaw=3"), testing::HasSubstr("line 2"));
  EXPECT_THAT(message("1 yaw=0\n\n# x\n5 jaw=3"), testing::HasSubstr("line 4: camera: unknown key \"jaw\""));
  EXPECT_THAT(message("5 yaw=0\n5 yaw=3"), testing::HasSubstr("does not come after"));
  EXPECT_THAT(message("5"), testing::HasSubstr("line 1"));
  EXPECT_THAT(message("nan yaw=1"), testing::HasSubstr("line 1"));
}

TEST(CameraPath, WhatHoldsForTheWholeFilmIsNoKeyFrame) {
  EXPECT_THROW(CameraPath<2>("1 all\n"), std::invalid_argument);
  EXPECT_THROW(CameraPath<3>("1 yaw=3\n9 all,yaw=4\n"), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
