// `kerf render --beside`: broad phases in panes side by side.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

RunOutcome render(const std::string& scene, const std::filesystem::path& out,
                  const std::vector<std::string>& more, const std::string& size = "640x420") {
  std::vector<std::string> arguments{"render", scene, "--steps", "1:41:10", "--objects", "60",
                                     "--grow", "30",  "--size",  size,      "--out",     out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_kerf(arguments);
}

class PanesProgram : public ::testing::TestWithParam<const char*> {};

TEST_P(PanesProgram, HasTheSamePixelsWithAnyNumberOfProcesses) {
  const TemporaryFolder folder;
  nlohmann::json first;
  for (const char* const workers : {"0", "1", "3"}) {
    const std::filesystem::path out = folder.path() / workers;
    const RunOutcome outcome =
        render(GetParam(), out, {"--beside", "loose-octree,sweep-and-prune", "--workers", workers});
    ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
    const nlohmann::json manifest = read_json(out / "frames.json");
    EXPECT_EQ(manifest["beside"], (nlohmann::json{"loose-octree", "sweep-and-prune"}));
    EXPECT_EQ(manifest["timed"], false);
    if (first.is_null()) first = manifest["frames"];
    EXPECT_EQ(manifest["frames"], first);
    EXPECT_EQ(manifest["frames"].size(), 5U);
  }
}

/// One pane shows the pairs of that broad phase, and the run is the same as without panes.
TEST_P(PanesProgram, FollowsTheRunOfASinglePicture) {
  const TemporaryFolder folder;
  ASSERT_EQ(render(GetParam(), folder.path() / "a", {"--broad-phase", "columns"}).exit, kExitHolds);
  ASSERT_EQ(render(GetParam(), folder.path() / "b",
                   {"--broad-phase", "columns", "--beside", "sort-and-sweep,loose-octree,sweep-and-prune"})
                .exit,
            kExitHolds);
  const nlohmann::json a = read_json(folder.path() / "a" / "frames.json")["frames"];
  const nlohmann::json b = read_json(folder.path() / "b" / "frames.json")["frames"];
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k]["pairs"], b[k]["pairs"]);
    EXPECT_EQ(a[k]["contacts"], b[k]["contacts"]);
    EXPECT_NE(a[k]["pixel_hash"], b[k]["pixel_hash"]);
  }
}

TEST_P(PanesProgram, OfOneBroadPhaseAlsoSaysWhatEachPixelShows) {
  const TemporaryFolder folder;
  const RunOutcome outcome =
      render(GetParam(), folder.path() / "a", {"--broad-phase", "loose-octree", "--beside", "none", "--ids"});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const std::string stem = std::string(GetParam()) + "_000004";
  const nlohmann::json list = read_json(folder.path() / "a" / (stem + ".draw.json"));
  std::size_t cells = 0;
  for (const nlohmann::json& item : list["items"]) cells += item[0] == "leaf" && item[8] > 0 ? 1U : 0U;
  EXPECT_GT(cells, 3U);
  EXPECT_EQ(read_png(folder.path() / "a" / (stem + ".ids.png")).height, 420);
}

/// Other broad phases get the boxes of a recording, and a shard's pictures are those of the whole.
TEST_P(PanesProgram, FollowsARecordingAndItsShards) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "run.kerf").string();
  ASSERT_EQ(
      run_kerf({"record", GetParam(), "--steps", "40", "--objects", "60", "--grow", "30", "-o", file}).exit,
      kExitHolds);
  const auto frames_of = [&](const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"render",   file,
                                       "--steps",  "10:40:10",
                                       "--size",   "640x420",
                                       "--beside", "columns,bullet-dbvt",
                                       "--out",    (folder.path() / name).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunOutcome outcome = run_kerf(arguments);
    EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
    return read_json(folder.path() / name / "frames.json")["frames"];
  };
  const nlohmann::json whole = frames_of("whole", {});
  const nlohmann::json shard = frames_of("shard", {"--shard", "2/2"});
  ASSERT_EQ(whole.size(), 4U);
  ASSERT_EQ(shard.size(), 2U);
  EXPECT_EQ(shard[0], whole[1]);
  EXPECT_EQ(shard[1], whole[3]);
  EXPECT_GT(whole[3]["pairs"], 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PanesProgram, ::testing::Values("buckets-2d", "buckets"),
                         [](const auto& scene) {
                           return std::string(scene.param) == "buckets" ? "3D" : "2D";
                         });

TEST(PanesProgramErrors, SayWhatToDo) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::vector<std::string>& more, const std::string& size = "640x420") {
    const RunOutcome outcome = render("buckets-2d", folder.path() / "none", more, size);
    EXPECT_EQ(outcome.exit, kExitUnusable);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "none"));
    return outcome.err;
  };
  EXPECT_THAT(complaint({"--beside", "loose-octre"}),
              HasSubstr("--beside: unknown 2D broad phase 'loose-octre'; did you mean 'loose-octree'?"));
  EXPECT_THAT(complaint({"--beside", "kerf,columns,sort-and-sweep,sweep-and-prune,loose-octree,all-pairs"}),
              HasSubstr("at most 6 panes, that of --broad-phase among them; leave out 1"));
  EXPECT_THAT(complaint({"--beside", "columns,columns"}), HasSubstr("columns would be in two panes"));
  EXPECT_THAT(complaint({"--beside", "columns", "--ids"}), HasSubstr("give --beside none"));
  EXPECT_THAT(complaint({"--beside", "columns", "--record", "a.kerf"}), HasSubstr("--record takes"));
  EXPECT_THAT(complaint({"--timed"}), HasSubstr("give --beside, too"));
  EXPECT_THAT(complaint({"--beside", "columns,sort-and-sweep,loose-octree"}, "320x240"),
              HasSubstr("4 panes have no room in 320x240 pixels"));
  EXPECT_THAT(complaint({"--beside", "columns", "--volume", "sphere"}), HasSubstr("on the same boxes"));
}

TEST(PanesProgramTimed, ShowsTimes) {
  const TemporaryFolder folder;
  const RunOutcome outcome = render("buckets-2d", folder.path() / "a", {"--beside", "columns", "--timed"});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_EQ(read_json(folder.path() / "a" / "frames.json")["timed"], true);
}

}  // namespace
}  // namespace kerf::test
