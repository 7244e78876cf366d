#include "frames/render_request.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frames/errors.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;

/// What `parse_request` says against `texts`; empty if it is content.
std::string complaint(const RenderTexts& texts) {
  try {
    (void)parse_request(texts);
    return {};
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(RenderRequest, NothingButAName) {
  const RenderRequest request = parse_request({.scene = "pile"});
  EXPECT_EQ(request.scene.dimension(), 2);
  EXPECT_EQ(request.size, PictureSize{});
  EXPECT_EQ(request.layers, LayerSet::all());
  EXPECT_EQ(request.options.objects, 0U);
  EXPECT_EQ(request.out, "out/pile");
}

TEST(RenderRequest, EveryOptionArrives) {
  const RenderRequest request = parse_request({.scene = "buckets",
                                               .steps = "5:50:5",
                                               .size = "320x200",
                                               .objects = "77",
                                               .grow = "40",
                                               .show = "objects,pairs",
                                               .camera = "yaw=10",
                                               .config = "max_redundancy=0.5,sample=99",
                                               .out = "here",
                                               .video = "film.mp4",
                                               .fps = "50",
                                               .contact_sheet = "sheet.png",
                                               .seed = "18446744073709551615",
                                               .overwrite = true});
  EXPECT_EQ(request.steps, (StepRange{5, 50, 5}));
  EXPECT_EQ(request.size, (PictureSize{320, 200}));
  EXPECT_EQ(request.options.objects, 77U);
  EXPECT_EQ(request.options.steps, 40U);
  EXPECT_EQ(request.options.seed, UINT64_MAX);
  EXPECT_EQ(request.layers, LayerSet::parse("objects,pairs"));
  EXPECT_EQ(request.camera, "yaw=10");
  EXPECT_FLOAT_EQ(request.config.max_redundancy, 0.5F);
  EXPECT_EQ(request.config.sample, 99U);
  EXPECT_EQ(request.out, "here");
  EXPECT_EQ(request.video, "film.mp4");
  EXPECT_EQ(request.fps, 50);
  EXPECT_EQ(request.contact_sheet, "sheet.png");
  EXPECT_TRUE(request.overwrite);
}

TEST(RenderRequest, NameOfBothDimensionsIsTheOneIn3D) {
  EXPECT_EQ(parse_request({.scene = "buckets"}).scene.dimension(), 3);
  EXPECT_EQ(parse_request({.scene = "buckets-3d"}).scene.dimension(), 3);
  EXPECT_EQ(parse_request({.scene = "buckets-2d"}).scene.dimension(), 2);
  EXPECT_EQ(parse_request({.scene = "buckets-2d"}).scene.name, "buckets-2d");
  EXPECT_EQ(parse_request({.scene = "pile-2d"}).scene.name, "pile");
}

TEST(RenderRequest, UnknownNamesAreAnsweredWithTheNearest) {
  EXPECT_THAT(complaint({.scene = "buckts"}), HasSubstr("did you mean 'buckets'"));
  EXPECT_THAT(complaint({.scene = "xyzzy"}), HasSubstr("terrain"));
  EXPECT_THAT(complaint({.scene = "pile", .config = "max_redundncy=1"}), HasSubstr("'max_redundancy'"));
  EXPECT_THAT(complaint({.scene = "pile", .show = "objects,pears"}), HasSubstr("pairs"));
}

TEST(RenderRequest, BadValuesAreRefused) {
  EXPECT_THAT(complaint({.scene = "pile", .objects = "0"}), HasSubstr("--objects '0'"));
  EXPECT_THAT(complaint({.scene = "pile", .objects = "1000001"}), HasSubstr("1000000"));
  EXPECT_THAT(complaint({.scene = "pile", .objects = "many"}), HasSubstr("whole number"));
  EXPECT_THAT(complaint({.scene = "pile", .grow = "0"}), HasSubstr("--grow"));
  EXPECT_THAT(complaint({.scene = "pile", .fps = "0"}), HasSubstr("--fps"));
  EXPECT_THAT(complaint({.scene = "pile", .seed = "-1"}), HasSubstr("--seed"));
  EXPECT_THAT(complaint({.scene = "pile", .config = "sample"}), HasSubstr("K=V"));
  EXPECT_THAT(complaint({.scene = "pile", .config = "sample=lots"}), HasSubstr("sample"));
  EXPECT_THAT(complaint({.scene = "pile", .video = "film.gif"}), HasSubstr(".mp4"));
  EXPECT_THAT(complaint({.scene = "pile", .contact_sheet = "sheet.jpg"}), HasSubstr(".png"));
}

TEST(RenderRequest, CameraIsReadInTheSceneDimension) {
  EXPECT_EQ(complaint({.scene = "buckets", .camera = "yaw=10"}), "");
  EXPECT_THAT(complaint({.scene = "pile", .camera = "yaw=10"}), HasSubstr("--camera"));
  EXPECT_EQ(complaint({.scene = "pile", .camera = "center=0:5,width=40"}), "");
  EXPECT_THAT(complaint({.scene = "buckets", .camera = "width=40"}), HasSubstr("--camera"));
}

}  // namespace
}  // namespace kerf
