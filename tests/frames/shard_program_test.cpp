#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// A recording in which operators act in many steps, and what renders it.
class ShardProgram : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const RunOutcome outcome = run_kerf(
        {"record", GetParam(), "--steps", "60", "--objects", "200", "--grow", "40", "-o", recording()});
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  }

  [[nodiscard]] std::string recording() const { return folder_.path() / "run.kerf"; }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }

  [[nodiscard]] RunOutcome render(const std::string& name, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"render", recording(), "--size", "200x120"};
    if (std::ranges::find(more, "--steps") == more.end())
      arguments.insert(arguments.end(), {"--steps", "3:60:5"});
    arguments.insert(arguments.end(), {"--out", path(name)});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_kerf(arguments);
  }

  void expect_same_files(const std::string& a, const std::string& b) const {
    ASSERT_EQ(test::files_in(path(a)), test::files_in(path(b)));
    for (const std::string& file : test::files_in(path(a)))
      EXPECT_TRUE(test::read_text(path(a) + "/" + file) == test::read_text(path(b) + "/" + file)) << file;
  }

  TemporaryFolder folder_;
};

TEST_P(ShardProgram, ShardsAreTheWhole) {
  ASSERT_EQ(render("all").exit, kExitHolds);
  for (const char* const k : {"1", "2", "3"})
    ASSERT_EQ(render(std::string("s") + k, {"--shard", std::string(k) + "/3", "--workers", "0"}).exit,
              kExitHolds);
  const RunOutcome outcome =
      run_kerf({"collect", path("s1"), path("s2"), path("s3"), "--out", path("together"), "--video",
                path("film.gif"), "--contact-sheet", path("sheet.png")});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("all 12 frames are there, from 3 folders"));
  expect_same_files("all", "together");
  EXPECT_TRUE(std::filesystem::exists(path("film.gif")));
  EXPECT_GT(read_png(path("sheet.png")).width, 200);
}

/// An operator's label stays where it was first seen, also if that frame was another shard's.
TEST_P(ShardProgram, AFrameIsTheSameWhicheverFramesAreDrawnBeforeIt) {
  ASSERT_EQ(render("all", {"--steps", "1:60:1"}).exit, kExitHolds);
  for (const char* const k : {"1", "2", "3", "4"})
    ASSERT_EQ(render(std::string("s") + k, {"--steps", "1:60:1", "--shard", std::string(k) + "/4"}).exit,
              kExitHolds);
  ASSERT_EQ(
      run_kerf({"collect", path("s1"), path("s2"), path("s3"), path("s4"), "--out", path("together")}).exit,
      kExitHolds);
  expect_same_files("all", "together");
}

TEST_P(ShardProgram, WhatIsMissingOrDamagedIsNamed) {
  ASSERT_EQ(render("s1", {"--shard", "1/2"}).exit, kExitHolds);
  const RunOutcome half = run_kerf({"collect", path("s1")});
  EXPECT_EQ(half.exit, kExitDoesNotHold);
  EXPECT_THAT(half.err, HasSubstr("6 of 12 frames are missing: 1, 3, 5, 7, 9, 11"));
  EXPECT_THAT(half.err, HasSubstr("--shard 2/2"));
  ASSERT_EQ(render("s2", {"--shard", "2/2"}).exit, kExitHolds);
  std::filesystem::copy_file(path("s2/run_000003.png"), path("s2/run_000005.png"),
                             std::filesystem::copy_options::overwrite_existing);
  const RunOutcome damaged = run_kerf({"collect", path("s1"), path("s2")});
  EXPECT_EQ(damaged.exit, kExitDoesNotHold);
  EXPECT_THAT(damaged.err, HasSubstr("run_000005.png"));
  std::filesystem::resize_file(path("s2/run_000005.png"), 200);
  std::filesystem::remove(path("s1/run_000002.png"));
  const RunOutcome two = run_kerf({"collect", path("s1"), path("s2")});
  EXPECT_EQ(two.exit, kExitDoesNotHold) << two.err;
  EXPECT_THAT(two.err, HasSubstr("run_000002.png is missing"));
  EXPECT_THAT(two.err, HasSubstr("run_000005.png"));
  EXPECT_THAT(two.err, HasSubstr("--resume and --shard 1/2, 2/2"));
  ASSERT_EQ(render("s1", {"--shard", "1/2", "--resume"}).exit, kExitHolds);
  ASSERT_EQ(render("s2", {"--shard", "2/2", "--resume"}).exit, kExitHolds);
  EXPECT_EQ(run_kerf({"collect", path("s1"), path("s2")}).exit, kExitHolds);
}

TEST_P(ShardProgram, CollectRefusesToWriteWhereItReads) {
  ASSERT_EQ(render("s/1", {"--shard", "1/2"}).exit, kExitHolds);
  ASSERT_EQ(render("s/2", {"--shard", "2/2"}).exit, kExitHolds);
  const auto before = test::files_in(path("s/1"));
  for (const char* const out : {"s/1", "s/2/", "s", "s/../s/./1"}) {
    const RunOutcome outcome =
        run_kerf({"collect", path("s/1"), path("s/2"), "--out", path(out), "--overwrite"});
    EXPECT_EQ(outcome.exit, kExitUnusable) << out;
    EXPECT_THAT(outcome.err, HasSubstr("which is read")) << out;
  }
  EXPECT_EQ(test::files_in(path("s/1")), before);
  EXPECT_EQ(run_kerf({"collect", path("s/1"), path("s/2"), "--out", path("s/12")}).exit, kExitHolds);
  EXPECT_EQ(run_kerf({"collect", path("s/1"), path("s/2"), "--out", path("s/1/below/it")}).exit, kExitHolds);
}

TEST_P(ShardProgram, WhatLiesBesideFramesIsCollectedToo) {
  ASSERT_EQ(render("all", {"--ids"}).exit, kExitHolds);
  ASSERT_EQ(render("s1", {"--ids", "--shard", "1/2"}).exit, kExitHolds);
  ASSERT_EQ(render("s2", {"--ids", "--shard", "2/2"}).exit, kExitHolds);
  ASSERT_EQ(run_kerf({"collect", path("s1"), path("s2"), "--out", path("together")}).exit, kExitHolds);
  expect_same_files("all", "together");
}

/// Where frames cannot be linked: a file system of 20 kB in a mount namespace of its own.
TEST_P(ShardProgram, AFullDiskLeavesNoHalfFrame) {
  ASSERT_EQ(render("all").exit, kExitHolds);
  std::filesystem::create_directory(path("disk"));
  if (test::Process({"unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", path("disk")}).wait().exit != 0)
    GTEST_SKIP() << "this user may not mount";
  std::string line = "mount -t tmpfs -o size=20k tmpfs " + path("disk") + " && ";
  for (const std::string& word : test::kerf_command({"collect", path("all"), "--out", path("disk")}))
    line += word + " ";
  line += "; code=$?; cp -r " + path("disk") + " " + path("copy") + "; exit $code";
  const RunOutcome outcome = test::Process({"unshare", "-m", "sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("No space left"));
  for (const std::string& file : test::files_in(path("copy")))
    EXPECT_EQ(std::filesystem::file_size(path("copy/" + file)),
              std::filesystem::file_size(path("all/" + file)))
        << file;
}

INSTANTIATE_TEST_SUITE_P(Both, ShardProgram, ::testing::Values("buckets", "pile"));

TEST(ShardUsage, ErrorsSayWhatToDo) {
  const TemporaryFolder folder;
  const std::string recording = folder.path() / "a.kerf";
  ASSERT_EQ(run_kerf({"record", "pile", "--steps", "20", "--objects", "30", "-o", recording}).exit,
            kExitHolds);
  EXPECT_THAT(run_kerf({"render", "pile", "--shard", "1/2"}).err, HasSubstr("kerf record"));
  EXPECT_THAT(run_kerf({"render", recording, "--seed", "2"}).err, HasSubstr("--seed"));
  EXPECT_THAT(run_kerf({"render", recording, "--steps", "30"}).err, HasSubstr("ends with step 20"));
  for (const char* const shard : {"0/2", "3/2", "1", "a/b", "1/"})
    EXPECT_THAT(run_kerf({"render", recording, "--shard", shard}).err, HasSubstr("K/N")) << shard;
  const std::string a = folder.path() / "a";
  const std::string b = folder.path() / "b";
  ASSERT_EQ(run_kerf({"render", recording, "--size", "64x64", "--out", a, "--shard", "1/2"}).exit,
            kExitHolds);
  ASSERT_EQ(run_kerf({"render", recording, "--size", "64x80", "--out", b, "--shard", "2/2"}).exit,
            kExitHolds);
  const RunOutcome mixed = run_kerf({"collect", a, b});
  EXPECT_EQ(mixed.exit, kExitUnusable);
  EXPECT_THAT(mixed.err, HasSubstr("size"));
  EXPECT_THAT(run_kerf({"collect", folder.path()}).err, HasSubstr("frames.json"));
}

TEST(CameraPathProgram, MovesTheCameraAndIsSaidInTheManifest) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "path.txt";
  std::ofstream(path) << "1 width=40\n11 width=10\n";
  const std::vector<std::string> render{"render",        "pile",   "--objects", "30",    "--steps",
                                        "1:11:5",        "--size", "200x120",   "--out", folder.path() / "a",
                                        "--camera-path", path};
  ASSERT_EQ(run_kerf(render).exit, kExitHolds);
  EXPECT_EQ(test::read_json(folder.path() / "a" / "frames.json")["camera_path"], "1 width=40\n11 width=10\n");
  std::ofstream(path) << "1 width=40\nx";
  EXPECT_THAT(run_kerf(render).err, HasSubstr("line 2"));
}

}  // namespace
}  // namespace kerf::test
