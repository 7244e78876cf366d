#include "frames/manifest.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/frames/program.h"

namespace kerf {
namespace {

using nlohmann::json;

RenderRequest request() {
  RenderRequest request;
  request.scene = find_scene("pile");
  request.name = "pile";
  request.options.seed = UINT64_MAX;
  request.broad_phase.config.max_redundancy = 0.125F;
  return request;
}

Manifest example() {
  Manifest manifest = begin_manifest(request());
  FrameRecord frame;
  frame.index = 42;
  frame.file = frame_file_name("pile", 42);
  frame.step = 169;
  frame.pairs = 7;
  frame.operators[static_cast<std::size_t>(Operator::shift_split)] = 3;
  frame.state_hash = 0xabc;
  manifest.frames.push_back(frame);
  return manifest;
}

TEST(Manifest, FileNamesHaveSixDigits) {
  EXPECT_EQ(frame_file_name("pile", 42), "pile_000042.png");
  EXPECT_EQ(frame_file_name("buckets-2d", 999'999), "buckets-2d_999999.png");
}

TEST(Manifest, SaysWhatTheSequenceIs) {
  const json read = json::parse(to_json(example()));
  EXPECT_EQ(read["scene"], "pile");
  EXPECT_EQ(read["dimension"], 2);
  EXPECT_EQ(read["seed"], UINT64_MAX);
  EXPECT_EQ(read["complete"], false);
  EXPECT_EQ(read["config"]["max_redundancy"], 0.125);
  EXPECT_EQ(read["config"].size(), config_fields().size());
}

TEST(Manifest, SaysWhatAFrameShows) {
  const json frame = json::parse(to_json(example()))["frames"][0];
  EXPECT_EQ(frame["file"], "pile_000042.png");
  EXPECT_EQ(frame["step"], 169);
  EXPECT_EQ(frame["pairs"], 7);
  EXPECT_EQ(frame["state_hash"], "0000000000000abc");
  EXPECT_EQ(frame["operators"].size(), static_cast<std::size_t>(kOperatorCount));
  EXPECT_EQ(frame["operators"][std::string(to_string(Operator::shift_split))], 3);
}

TEST(Manifest, TextThatIsNotUtf8DoesNotLoseIt) {
  RenderRequest strange = request();
  strange.camera = "\xff\xfe";
  EXPECT_TRUE(json::accept(to_json(begin_manifest(strange))));
}

TEST(Manifest, IsReadAsItWasWritten) {
  const testing::TemporaryFolder folder;
  Manifest written = example();
  written.shard = {1, 3};
  save(written, folder.path());
  const Manifest read = read_manifest(folder.path());
  EXPECT_EQ(to_json(read), to_json(written));
  EXPECT_EQ(read.header, written.header);
  EXPECT_EQ(read.wanted_frames(), written.wanted_frames());
}

TEST(Manifest, ThatIsDamagedIsAnError) {
  const testing::TemporaryFolder folder;
  EXPECT_THROW((void)read_manifest(folder.path()), std::runtime_error);
  for (const char* const text : {"", "{}", "[1]", "{\"format\":\"kerf-frames-2\"}"}) {
    std::ofstream(folder.path() / kManifestName) << text;
    EXPECT_THROW((void)read_manifest(folder.path()), std::runtime_error) << text;
  }
}

TEST(Manifest, ShardsShareTheFrames) {
  Manifest manifest = begin_manifest(request());
  for (const std::uint32_t count : {1U, 3U, 7U, 1000U}) {
    std::uint32_t sum = 0;
    for (std::uint32_t index = 0; index < count; ++index) {
      manifest.shard = {index, count};
      sum += manifest.wanted_frames();
    }
    EXPECT_EQ(sum, manifest.steps.frames());
  }
}

TEST(Manifest, NamesTheFirstDifference) {
  RenderRequest other = request();
  EXPECT_EQ(first_difference(begin_manifest(request()).header, begin_manifest(other).header), "");
  other.camera = "yaw=10";
  EXPECT_EQ(first_difference(begin_manifest(request()).header, begin_manifest(other).header),
            "camera: \"\" and \"yaw=10\"");
}

}  // namespace
}  // namespace kerf
