#include "frames/sequence/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "tests/frames/program.h"

namespace kerf {
namespace {

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
  const nlohmann::json read = nlohmann::json::parse(to_json(example()));
  EXPECT_EQ(read["scene"], "pile");
  EXPECT_EQ(read["dimension"], 2);
  EXPECT_EQ(read["seed"], UINT64_MAX);
  EXPECT_EQ(read["complete"], false);
  EXPECT_EQ(read["config"]["max_redundancy"], 0.125);
  EXPECT_EQ(read["config"].size(), config_fields().size());
}

TEST(Manifest, SaysWhatAFrameShows) {
  const nlohmann::json frame = nlohmann::json::parse(to_json(example()))["frames"][0];
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
  EXPECT_TRUE(nlohmann::json::accept(to_json(begin_manifest(strange))));
}

TEST(Manifest, IsReadAsItWasWritten) {
  const test::TemporaryFolder folder;
  Manifest written = example();
  written.shard = {1, 3};
  save(written, folder.path());
  const Manifest read = read_manifest(folder.path());
  EXPECT_EQ(to_json(read), to_json(written));
  EXPECT_EQ(read.header, written.header);
  EXPECT_EQ(read.wanted_frames(), written.wanted_frames());
}

TEST(Manifest, ThatIsDamagedIsAnError) {
  const test::TemporaryFolder folder;
  EXPECT_THROW((void)read_manifest(folder.path()), std::runtime_error);
  for (const char* const text : {"", "{}", "[1]", "{\"format\":\"kerf-frames-2\"}"}) {
    std::ofstream(folder.path() / kManifestName) << text;
    EXPECT_THROW((void)read_manifest(folder.path()), std::runtime_error) << text;
  }
}

/// What follows from a number out of its range is a division by zero, or memory without end.
TEST(Manifest, ThatLiesIsDamaged) {
  const test::TemporaryFolder folder;
  const nlohmann::json truth = nlohmann::json::parse(to_json(example()));
  const auto lie = [&](const char* where, const nlohmann::json& what) {
    nlohmann::json manifest = truth;
    manifest[nlohmann::json::json_pointer(where)] = what;
    std::ofstream(folder.path() / kManifestName) << manifest;
    try {
      (void)read_manifest(folder.path());
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("frames.json is damaged")) << where;
      return;
    }
    ADD_FAILURE() << where << " may be " << what;
  };
  for (const nlohmann::json& first :
       {nlohmann::json(0), nlohmann::json(1001), nlohmann::json(-1), nlohmann::json("1")})
    lie("/steps/first", first);
  for (const nlohmann::json& last :
       {nlohmann::json(0), nlohmann::json(UINT32_MAX), nlohmann::json(UINT64_C(1) << 32 | 100),
        nlohmann::json(99.5), nlohmann::json(1e99)})
    lie("/steps/last", last);
  for (const nlohmann::json& stride : {nlohmann::json(0), nlohmann::json(-4), nlohmann::json(UINT32_MAX)})
    lie("/steps/stride", stride);
  for (const nlohmann::json& side : {nlohmann::json(0), nlohmann::json(-1), nlohmann::json(1'000'000)})
    lie("/size/width", side);
  for (const nlohmann::json& count :
       {nlohmann::json(0), nlohmann::json(-1), nlohmann::json(UINT64_C(1) << 32)})
    lie("/shard/count", count);
  lie("/shard/index", 1);
  for (const nlohmann::json& name : {nlohmann::json("a/b"), nlohmann::json("../pile")}) lie("/name", name);
  for (const nlohmann::json& index :
       {nlohmann::json(250), nlohmann::json(-1), nlohmann::json(UINT64_C(1) << 32)})
    lie("/frames/0/index", index);
  for (const nlohmann::json& file : {nlohmann::json("../pile_000042.png"), nlohmann::json("/etc/passwd"),
                                     nlohmann::json(".."), nlohmann::json("."), nlohmann::json("")})
    lie("/frames/0/file", file);
  for (const nlohmann::json& hash :
       {nlohmann::json("xyz"), nlohmann::json(""), nlohmann::json("1 and more"), nlohmann::json("-1")})
    lie("/frames/0/pixel_hash", hash);
  lie("/frames/0/pairs", -1);
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
