#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Eleven frames of odd size, which H.264 cannot have as they are.
std::vector<std::string> film(const TemporaryFolder& folder, const std::string& file) {
  return {"render",    "pile",
          "--objects", "30",
          "--steps",   "1:21:2",
          "--size",    "161x121",
          "--out",     folder.path() / "frames",
          "--video",   folder.path() / file};
}

/// A folder whose program `ffmpeg` is this shell script.
Surroundings false_ffmpeg(const TemporaryFolder& folder, const std::string& script) {
  const std::string file = folder.path() / "ffmpeg";
  std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
  ::chmod(file.c_str(), 0755);
  return {0, folder.path().string() + ":/usr/bin:/bin"};
}

TEST(VideoProgram, FilmHasEveryFrame) {
  const TemporaryFolder folder;
  const RunOutcome outcome = run_kerf(film(folder, "films/pile.mp4"));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(test::files_in(folder.path() / "films"), ElementsAre("pile.mp4"));
  const RunOutcome probe = Process({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                    "stream=codec_name,width,height,pix_fmt,nb_read_frames", "-of", "csv=p=0",
                                    folder.path() / "films" / "pile.mp4"})
                               .wait();
  EXPECT_EQ(probe.out, "h264,162,122,yuv420p,11\n") << probe.err;
}

class FilmFormats : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(FilmFormats, HaveEveryFrame) {
  const TemporaryFolder folder;
  const std::string file = std::string("pile.") + GetParam().first;
  const RunOutcome outcome = run_kerf(film(folder, file));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const RunOutcome probe =
      Process({"ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=codec_name,nb_read_frames",
               "-of", "csv=p=0", folder.path() / file})
          .wait();
  EXPECT_EQ(probe.out, std::string(GetParam().second) + ",11\n") << probe.err;
}

INSTANTIATE_TEST_SUITE_P(All, FilmFormats,
                         ::testing::Values(std::pair{"webm", "vp9"}, std::pair{"gif", "gif"},
                                           std::pair{"apng", "apng"}));

TEST(FilmDiffProgram, ShowsWhatDiffers) {
  const TemporaryFolder folder;
  const auto render = [&](const std::string& name, const std::string& seed) {
    return run_kerf({"render", "pile", "--objects", "30", "--steps", "1:21:4", "--size", "160x120", "--seed",
                     seed, "--out", folder.path() / name});
  };
  ASSERT_EQ(render("a", "1").exit, kExitHolds);
  ASSERT_EQ(render("b", "2").exit, kExitHolds);
  const std::string film = folder.path() / "diff.mp4";
  const RunOutcome outcome = run_kerf({"film-diff", folder.path() / "a", folder.path() / "b", "-o", film,
                                       "--contact-sheet", folder.path() / "diff.png"});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("6 frames, 5 of them different"));
  EXPECT_THAT(
      run_kerf({"film-diff", folder.path() / "a", folder.path() / "a", "-o", film, "--overwrite"}).out,
      HasSubstr("6 frames, 0 of them different"));
  EXPECT_THAT(run_kerf({"film-diff", folder.path() / "a", "/nowhere", "-o", film}).err,
              HasSubstr("exists already"));
}

/// An object that goes its way, seen by two engines that count steps from different numbers on.
TEST(VideoProgram, FramesOfImportsMeetByTheStepsOfTheirEngines) {
  const TemporaryFolder folder;
  const auto render_from = [&](const std::string& name, int first) {
    std::string csv = "step,object,min_x,max_x,min_y,max_y\n";
    for (int step = first; step < first + 4; ++step)
      csv += std::to_string(step) + ",1," + std::to_string(step) + "," + std::to_string(step + 1) + ",0,1\n" +
             std::to_string(step) + ",2,0,40,5,6\n";
    std::ofstream(folder.path() / (name + ".csv")) << csv;
    const std::string recording = folder.path() / (name + ".kerf");
    EXPECT_EQ(run_kerf({"import", folder.path() / (name + ".csv"), "-o", recording}).exit, kExitHolds);
    EXPECT_EQ(
        run_kerf({"render", recording, "--steps", std::to_string(first) + ":" + std::to_string(first + 3),
                  "--size", "96x64", "--camera", "all", "--show", "objects", "--out", folder.path() / name})
            .exit,
        kExitHolds);
  };
  render_from("a", 10);
  render_from("b", 12);
  const RunOutcome outcome =
      run_kerf({"film-diff", folder.path() / "a", folder.path() / "b", "-o", folder.path() / "diff.mp4"});
  EXPECT_EQ(outcome.exit, kExitDoesNotHold) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 frames, "));
  for (const char* const step : {"step 10 is in", "step 11 is in", "step 14 is in", "step 15 is in"})
    EXPECT_THAT(outcome.out, HasSubstr(step));
}

TEST(VideoProgram, WithoutFfmpegNothingIsStarted) {
  const TemporaryFolder folder;
  const RunOutcome outcome = run_kerf(film(folder, "pile.mp4"), {0, "/nowhere"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("ffmpeg"));
  EXPECT_THAT(outcome.err, HasSubstr("install"));
  EXPECT_THAT(folder.files(), IsEmpty());
}

TEST(VideoProgram, FfmpegThatDiesAtOnceIsAnErrorWithItsWords) {
  const TemporaryFolder folder;
  const TemporaryFolder tools;
  const RunOutcome outcome =
      run_kerf(film(folder, "pile.mp4"), false_ffmpeg(tools, "echo 'no such codec' >&2; exit 1"));
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("no such codec"));
  EXPECT_THAT(folder.files(), ElementsAre("frames"));
}

TEST(VideoProgram, FfmpegThatFailsAtTheEndIsAnError) {
  const TemporaryFolder folder;
  const TemporaryFolder tools;
  const auto liar = false_ffmpeg(tools, "cat >/dev/null; echo 'disk full' >&2; exit 1");
  const RunOutcome outcome = run_kerf(film(folder, "pile.mp4"), liar);
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("disk full"));
  EXPECT_EQ(test::read_json(folder.path() / "frames" / "frames.json")["complete"], true);
}

TEST(VideoProgram, AnEarlierFilmSurvivesAFailure) {
  const TemporaryFolder folder;
  const TemporaryFolder tools;
  std::ofstream(folder.path() / "pile.mp4") << "precious";
  EXPECT_EQ(run_kerf(film(folder, "pile.mp4")).exit, kExitUnusable);
  auto arguments = film(folder, "pile.mp4");
  arguments.emplace_back("--overwrite");
  EXPECT_EQ(run_kerf(arguments, false_ffmpeg(tools, "cat >/dev/null; exit 1")).exit, kExitUnusable);
  EXPECT_EQ(test::read_text(folder.path() / "pile.mp4"), "precious");
  EXPECT_EQ(run_kerf(arguments).exit, kExitHolds);
  EXPECT_NE(test::read_text(folder.path() / "pile.mp4"), "precious");
}

TEST(VideoProgram, UnwritableFolderIsFoundBeforeTheWork) {
  const TemporaryFolder folder;
  auto arguments = film(folder, "pile.mp4");
  arguments.back() = "/proc/kerf/film.mp4";
  const RunOutcome outcome = run_kerf(arguments);
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/kerf"));
  EXPECT_THAT(folder.files(), IsEmpty());
}

}  // namespace
}  // namespace kerf::test
