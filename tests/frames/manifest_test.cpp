#include "frames/manifest.h"

#include <gtest/gtest.h>

#include "tests/frames/program.h"

namespace kerf {
namespace {

using nlohmann::json;

Manifest example() {
  Manifest manifest;
  manifest.scene = "pile";
  manifest.dimension = 2;
  manifest.seed = UINT64_MAX;
  manifest.config.emplace().max_redundancy = 0.125F;
  FrameRecord frame;
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
  Manifest manifest = example();
  manifest.camera = "\xff\xfe";
  EXPECT_TRUE(json::accept(to_json(manifest)));
}

}  // namespace
}  // namespace kerf
