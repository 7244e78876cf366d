#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "frames/support/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// A short run of few objects, small pictures.
std::vector<std::string> small_render(const std::string& scene, const std::filesystem::path& out) {
  return {"render", scene, "--steps", "1:41:10", "--objects", "60",
          "--grow", "30",  "--size",  "160x120", "--out",     out.string()};
}

std::string hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

class RenderProgram : public ::testing::TestWithParam<const char*> {};

TEST_P(RenderProgram, MakesTheFramesThatTheManifestNames) {
  const TemporaryFolder folder;
  const RunOutcome outcome = run_kerf(small_render(GetParam(), folder.path() / "a" / "b"));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "a pipe is not a terminal";
  EXPECT_EQ(outcome.out, (folder.path() / "a" / "b").string() + ": 5 frames\n");
  const nlohmann::json manifest = read_json(folder.path() / "a" / "b" / "frames.json");
  EXPECT_EQ(manifest["scene"], GetParam());
  EXPECT_EQ(manifest["complete"], true);
  EXPECT_EQ(manifest["requested_objects"], 60);
  std::vector<std::string> expected{"frames.json"};
  for (std::size_t k = 0; k < 5; ++k) {
    const nlohmann::json& frame = manifest["frames"].at(k);
    EXPECT_EQ(frame["step"], 1 + 10 * k);
    EXPECT_LE(frame["contacts"], frame["pairs"]);
    EXPECT_GE(frame["entries"], 1);
    expected.push_back(frame["file"]);
    const Image image = read_png(folder.path() / "a" / "b" / frame["file"].get<std::string>());
    EXPECT_EQ(image.width, 160);
    EXPECT_EQ(image.height, 120);
    EXPECT_EQ(frame["pixel_hash"], hex(pixel_hash(image)));
  }
  EXPECT_EQ(manifest["frames"].size(), 5U);
  EXPECT_THAT(test::files_in(folder.path() / "a" / "b"), ::testing::UnorderedElementsAreArray(expected));
}

TEST_P(RenderProgram, TwoRunsAreTheSameAndSeedsDiffer) {
  const TemporaryFolder folder;
  const auto frames_of = [&](const char* name, const std::vector<std::string>& more) {
    const RunOutcome outcome = run_kerf(with(small_render(GetParam(), folder.path() / name), more));
    EXPECT_EQ(outcome.exit, kExitHolds) << outcome.err;
    return read_json(folder.path() / name / "frames.json")["frames"];
  };
  const nlohmann::json first = frames_of("a", {});
  EXPECT_EQ(first, frames_of("b", {}));
  const nlohmann::json other = frames_of("c", {"--seed", "2"});
  EXPECT_NE(first.back()["state_hash"], other.back()["state_hash"]);
  EXPECT_NE(first.back()["pixel_hash"], other.back()["pixel_hash"]);
}

/// Whatever pictures are asked for, the simulation is the same.
TEST_P(RenderProgram, TheStepDecidesTheStateNotTheFrame) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_kerf(small_render(GetParam(), folder.path() / "a")).exit, kExitHolds);
  const RunOutcome outcome =
      run_kerf({"render", GetParam(), "--steps", "41:41", "--objects", "60", "--grow", "30", "--size",
                "64x64", "--show", "objects", "--out", folder.path() / "b"});
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  const nlohmann::json all = read_json(folder.path() / "a" / "frames.json")["frames"];
  const nlohmann::json one = read_json(folder.path() / "b" / "frames.json")["frames"];
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0]["state_hash"], all[4]["state_hash"]);
  EXPECT_EQ(one[0]["pairs"], all[4]["pairs"]);
  std::uint64_t events = 0;
  for (const nlohmann::json& frame : all) events += frame["events"].get<std::uint64_t>();
  EXPECT_EQ(one[0]["events"], events);
}

INSTANTIATE_TEST_SUITE_P(All, RenderProgram, ::testing::Values("buckets", "terrain", "pile", "buckets-2d"),
                         [](const ::testing::TestParamInfo<const char*>& scene) {
                           std::string name = scene.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(RenderProgram, ConfigurationReachesTheTree) {
  const TemporaryFolder folder;
  const auto run = with(small_render("pile", folder.path()), {"--config", "budget_divisor=0"});
  ASSERT_EQ(run_kerf(run).exit, kExitHolds);
  const nlohmann::json manifest = read_json(folder.path() / "frames.json");
  EXPECT_EQ(manifest["config"]["budget_divisor"], 0);
  EXPECT_EQ(manifest["frames"].back()["leaves"], 1) << "no operator, no split";
}

TEST(RenderProgram, LayersReachThePicture) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_kerf(small_render("pile", folder.path() / "a")).exit, kExitHolds);
  ASSERT_EQ(run_kerf(with(small_render("pile", folder.path() / "b"), {"--show", "objects"})).exit,
            kExitHolds);
  const nlohmann::json all = read_json(folder.path() / "a" / "frames.json");
  const nlohmann::json objects = read_json(folder.path() / "b" / "frames.json");
  EXPECT_EQ(objects["layers"], "objects");
  EXPECT_NE(all["frames"].back()["pixel_hash"], objects["frames"].back()["pixel_hash"]);
}

TEST(RenderProgram, AnEarlierSequenceIsReplacedOnlyOnDemand) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_kerf(small_render("pile", folder.path())).exit, kExitHolds);
  const std::string before = test::read_text(folder.path() / "frames.json");
  const RunOutcome refused = run_kerf(small_render("pile", folder.path()));
  EXPECT_EQ(refused.exit, kExitUnusable);
  EXPECT_THAT(refused.err, HasSubstr("--overwrite"));
  EXPECT_EQ(test::read_text(folder.path() / "frames.json"), before);

  std::fclose(std::fopen((folder.path() / "my_holiday.png").c_str(), "w"));
  const RunOutcome replaced = run_kerf({"render", "buckets-2d", "--steps", "3", "--size", "64x64",
                                        "--overwrite", "--out", folder.path().string()});
  ASSERT_EQ(replaced.exit, kExitHolds) << replaced.err;
  EXPECT_THAT(folder.files(),
              ::testing::ElementsAre("buckets-2d_000000.png", "buckets-2d_000001.png",
                                     "buckets-2d_000002.png", "frames.json", "my_holiday.png"));
}

/// Frames without a manifest, as a killed run leaves them, are a sequence, too.
TEST(RenderProgram, FramesOfAKilledRunAreNotMixedWithNewOnes) {
  const TemporaryFolder folder;
  std::fclose(std::fopen((folder.path() / "pile_000007.png").c_str(), "w"));
  EXPECT_EQ(run_kerf(small_render("pile", folder.path())).exit, kExitUnusable);
  EXPECT_EQ(run_kerf(with(small_render("pile", folder.path()), {"--overwrite"})).exit, kExitHolds);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "pile_000007.png"));
}

TEST(RenderProgram, MakesContactSheet) {
  const TemporaryFolder folder;
  const auto sheet = folder.path() / "sheets" / "pile.png";
  const auto run = with(small_render("pile", folder.path() / "f"), {"--contact-sheet", sheet.string()});
  ASSERT_EQ(run_kerf(run).exit, kExitHolds);
  EXPECT_GE(read_png(sheet).width, 4 * 160);
  const RunOutcome again =
      run_kerf(with(small_render("pile", folder.path() / "g"), {"--contact-sheet", sheet}));
  EXPECT_EQ(again.exit, kExitUnusable);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
}

}  // namespace
}  // namespace kerf::test
