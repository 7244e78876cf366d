#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> bench_frames(const std::string& json, const std::string& boxes) {
  return {"bench-frames", "--sizes", "320x240", "--boxes", boxes, "--json", json};
}

TEST(BenchFramesProgram, PrintsRowsAndWritesJson) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "frames.json";
  const RunOutcome outcome = run_kerf(bench_frames(file, "10,20"));
  ASSERT_EQ(outcome.exit, kExitHolds) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("pipeline"));
  const auto json = read_json(file);
  EXPECT_TRUE(json["complete"]);
  EXPECT_TRUE(json["machine"].contains("processor"));
  ASSERT_EQ(json["rows"].size(), 2U);
  EXPECT_EQ(json["rows"][1]["boxes"], 20);
}

TEST(BenchFramesProgram, KeepsWhatWasMeasuredWhenInterrupted) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "frames.json";
  const RunOutcome outcome =
      interrupt_kerf(bench_frames(file, "10,20,20"), [&] { return has_written_part(file); });
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  const auto json = read_json(file);
  EXPECT_FALSE(json["complete"]);
  EXPECT_GE(json["rows"].size(), 1U);
  EXPECT_LT(json["rows"].size(), 3U);
}

TEST(BenchFramesProgram, SaysWhyAFileCannotBeWrittenBeforeItMeasures) {
  const RunOutcome outcome = run_kerf(bench_frames("/nowhere/frames.json", "10"));
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("/nowhere/frames.json"));
  EXPECT_EQ(outcome.out, "");
}

TEST(BenchFramesProgram, AWrongNumberIsRefusedBeforeAnythingIsPrinted) {
  const RunOutcome outcome = run_kerf({"bench-frames", "--frames", "0"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("--frames"));
  EXPECT_EQ(outcome.out, "");
}

/// The time of three small frames vanishes beside that of starting up, which is measured alone and taken off.
TEST(BenchFramesProgram, TooFewFramesAreRefused) {
  const RunOutcome outcome =
      run_kerf({"bench-frames", "--sizes", "320x200", "--boxes", "100", "--frames", "3"});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("3 frames of 320x200 with 100 boxes: too little to measure"));
  EXPECT_THAT(outcome.err, HasSubstr("--frames"));
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 1) << outcome.out;  // the heading alone
}

}  // namespace
}  // namespace kerf::test
