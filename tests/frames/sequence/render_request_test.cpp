#include "frames/sequence/render_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "frames/support/errors.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

using Option = std::string RenderTexts::*;

RenderTexts with(const char* scene, Option option = &RenderTexts::scene, const char* value = nullptr) {
  RenderTexts texts;
  texts.scene = scene;
  if (value != nullptr) texts.*option = value;
  return texts;
}

/// What `parse_request` says against one option; empty if it is content.
std::string complaint(const char* scene, Option option = &RenderTexts::scene, const char* value = nullptr) {
  try {
    (void)parse_request(with(scene, option, value));
    return {};
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(RenderRequest, NothingButAName) {
  const RenderRequest request = parse_request(with("pile"));
  EXPECT_EQ(request.scene.dimension(), 2);
  EXPECT_EQ(request.size, PictureSize{});
  EXPECT_EQ(request.layers, LayerSet::all());
  EXPECT_EQ(request.options.objects, 0U);
  EXPECT_EQ(request.out, "out/pile");
  EXPECT_FALSE(request.overwrite);
}

TEST(RenderRequest, NumbersArrive) {
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::steps, "5:50:5")).steps, (StepRange{5, 50, 5}));
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::size, "320x200")).size, (PictureSize{320, 200}));
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::objects, "77")).options.objects, 77U);
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::grow, "40")).options.steps, 40U);
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::seed, "18446744073709551615")).options.seed, UINT64_MAX);
  RenderTexts film = with("pile", &RenderTexts::video, "film.mp4");
  film.fps = "50";
  EXPECT_EQ(parse_request(film).film.fps, 50);
}

TEST(RenderRequest, TextsArrive) {
  const RenderRequest shown = parse_request(with("pile", &RenderTexts::show, "objects,pairs"));
  EXPECT_EQ(shown.layers, LayerSet::parse("objects,pairs"));
  const Config config =
      parse_request(with("pile", &RenderTexts::config, "max_redundancy=0.5,sample=99")).broad_phase.config;
  EXPECT_FLOAT_EQ(config.max_redundancy, 0.5F);
  EXPECT_EQ(config.sample, 99U);
  EXPECT_EQ(parse_request(with("buckets", &RenderTexts::camera, "yaw=10")).camera, "yaw=10");
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::out, "here")).out, "here");
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::video, "film.mp4")).film.video, "film.mp4");
  EXPECT_EQ(parse_request(with("pile", &RenderTexts::contact_sheet, "sheet.png")).film.contact_sheet,
            "sheet.png");
}

TEST(RenderRequest, NameOfBothDimensionsIsTheOneIn3D) {
  EXPECT_EQ(parse_request(with("buckets")).scene.dimension(), 3);
  EXPECT_EQ(parse_request(with("buckets-3d")).scene.dimension(), 3);
  EXPECT_EQ(parse_request(with("buckets-2d")).scene.dimension(), 2);
  EXPECT_EQ(parse_request(with("buckets-2d")).scene.name, "buckets-2d");
  EXPECT_EQ(parse_request(with("pile-2d")).scene.name, "pile");
}

TEST(RenderRequest, UnknownNamesAreAnsweredWithTheNearest) {
  EXPECT_THAT(complaint("buckts"), HasSubstr("did you mean 'buckets'"));
  EXPECT_THAT(complaint("xyzzy"), HasSubstr("terrain"));
  EXPECT_THAT(complaint("pile", &RenderTexts::config, "max_redundncy=1"), HasSubstr("'max_redundancy'"));
  EXPECT_THAT(complaint("pile", &RenderTexts::show, "objects,pears"), HasSubstr("pairs"));
}

TEST(RenderRequest, BadValuesAreRefused) {
  EXPECT_THAT(complaint("pile", &RenderTexts::objects, "0"), HasSubstr("--objects '0'"));
  EXPECT_THAT(complaint("pile", &RenderTexts::objects, "1000001"), HasSubstr("1000000"));
  EXPECT_THAT(complaint("pile", &RenderTexts::objects, "many"), HasSubstr("whole number"));
  EXPECT_THAT(complaint("pile", &RenderTexts::grow, "0"), HasSubstr("--grow"));
  EXPECT_THAT(complaint("pile", &RenderTexts::fps, "0"), HasSubstr("--fps"));
  EXPECT_THAT(complaint("pile", &RenderTexts::seed, "-1"), HasSubstr("--seed"));
  EXPECT_THAT(complaint("pile", &RenderTexts::config, "sample"), HasSubstr("K=V"));
  EXPECT_THAT(complaint("pile", &RenderTexts::config, "sample=lots"), HasSubstr("sample"));
  EXPECT_THAT(complaint("pile", &RenderTexts::video, "film.avi"), HasSubstr(".mp4"));
  EXPECT_THAT(complaint("pile", &RenderTexts::contact_sheet, "sheet.jpg"), HasSubstr(".png"));
}

TEST(RenderRequest, CameraIsReadInTheSceneDimension) {
  EXPECT_EQ(complaint("buckets", &RenderTexts::camera, "yaw=10"), "");
  EXPECT_THAT(complaint("pile", &RenderTexts::camera, "yaw=10"), HasSubstr("--camera"));
  EXPECT_EQ(complaint("pile", &RenderTexts::camera, "center=0:5,width=40"), "");
  EXPECT_THAT(complaint("buckets", &RenderTexts::camera, "width=40"), HasSubstr("--camera"));
}

TEST(RenderRequest, AViewIsTheDirectionOfTheCamera) {
  EXPECT_EQ(parse_request(with("buckets", &RenderTexts::view, "top")).camera, "top");
  RenderTexts both = with("buckets", &RenderTexts::view, "front");
  both.camera = "fov=20";
  EXPECT_EQ(parse_request(both).camera, "front,fov=20");
  EXPECT_THAT(complaint("buckets", &RenderTexts::view, "below"), HasSubstr("iso, top, front, side"));
  EXPECT_THAT(complaint("pile", &RenderTexts::view, "top"), HasSubstr("--view"));
}

}  // namespace
}  // namespace kerf
