#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "frames/diff/frame_diff.h"
#include "frames/sequence/draw_list_file.h"
#include "tests/frames/program.h"
#include "tests/images/reference_frames.h"
#include "tests/images/scene_still.h"

namespace kerf {
namespace {

/// Runs tests of this program in another process and surroundings; pictures go to a folder of its own.
test::RunOutcome draw_elsewhere(const std::string& surroundings, const std::string& tests,
                                const std::filesystem::path& folder) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  test::Process process({"sh", "-c",
                         surroundings + " KERF_NEW_FRAMES='" + folder.string() + "' exec '" + self +
                             "' --gtest_also_run_disabled_tests --gtest_filter='" + tests + "'"});
  return process.wait();
}

TEST(Rasterizers, EveryNumberOfThreadsAndBackendDrawsTheReferences) {
  for (const std::string how : {"LP_NUM_THREADS=0", "LP_NUM_THREADS=3 KERF_BACKEND=egl"}) {
    const test::TemporaryFolder folder;
    const test::RunOutcome outcome =
        draw_elsewhere(how, "ReferenceFrames*EachOperatorBeforeAndAfter:ReferencePanels.*", folder.path());
    EXPECT_EQ(outcome.exit, 0) << how << outcome.out;
    for (const char* const suite : {"OK ] ReferenceFrames", "OK ] ReferencePanels"})
      EXPECT_THAT(outcome.out, ::testing::HasSubstr(suite)) << how;
  }
}

template <int D>
void draw_with_one_sample(const std::string& scene) {
  FrameOptions options;
  options.width = 480;
  options.height = 270;
  options.samples = 1;
  options.ids = true;
  FrameRenderer<D> renderer(options);
  const Image& image = renderer.render(test::SceneStill<D>(scene).input());
  (void)test::compare_with_reference("one-sample-" + scene, renderer, image);
}

TEST(Rasterizers, DISABLED_DrawWithOneSample) {
  draw_with_one_sample<2>("buckets-2d");
  draw_with_one_sample<2>("fracture-2d");
  draw_with_one_sample<3>("jelly");
}

// Mesa's other software rasteriser stands for all that are not ours. It has no smooth edges.
TEST(Rasterizers, AnotherOneDrawsTheSamePicturesWithOtherPixels) {
  const test::TemporaryFolder ours;
  const test::TemporaryFolder other;
  const std::string tests = "Rasterizers.DISABLED_DrawWithOneSample";
  ASSERT_EQ(draw_elsewhere("GALLIUM_DRIVER=llvmpipe", tests, ours.path()).exit, 0);
  ASSERT_EQ(draw_elsewhere("GALLIUM_DRIVER=softpipe", tests, other.path()).exit, 0);
  std::uint64_t different = 0;
  for (const FramePair& frame : pair_frames(ours.path(), other.path()).frames) {
    const FrameDiff diff = diff_frame(frame, {});
    EXPECT_EQ(diff.trouble, "");
    EXPECT_TRUE(diff.same) << frame.name << ": " << ::testing::PrintToString(diff.reasons);
    EXPECT_EQ(read_ids(frame.test)->rasterizer.find("llvmpipe"), std::string::npos);
    different += diff.pixels.different;
    if (diff.flip)
      std::printf("%s: FLIP %.3f, %llu pixels\n", frame.name.c_str(), diff.flip->max,
                  static_cast<unsigned long long>(diff.pixels.different));
  }
  EXPECT_GT(different, 0U);
}

}  // namespace
}  // namespace kerf
