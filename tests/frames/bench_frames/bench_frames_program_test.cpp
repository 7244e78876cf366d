#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "core/files/part_file.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf {
namespace {

using ::testing::HasSubstr;
using testing::kerf_command;
using testing::Outcome;
using testing::Process;
using testing::read_json;
using testing::run_kerf;
using testing::TemporaryFolder;

/// Enough frames to be measured also beside other tests.
std::vector<std::string> bench_frames(const std::string& json, const std::string& boxes) {
  return {"bench-frames", "--sizes", "320x240", "--boxes", boxes, "--frames", "300", "--json", json};
}

TEST(BenchFramesProgram, PrintsRowsAndWritesJson) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "frames.json";
  const Outcome outcome = run_kerf(bench_frames(file, "10,20"));
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
  Process process(kerf_command(bench_frames(file, "10,20,20")));
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  const auto is_saved = [&] {
    const auto parts = parts_of(file);
    std::error_code none;
    return !parts.empty() && std::filesystem::file_size(parts.front(), none) > 0 && !none;
  };
  while (!is_saved() && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.signal(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted) << outcome.err;
  const auto json = read_json(file);
  EXPECT_FALSE(json["complete"]);
  EXPECT_GE(json["rows"].size(), 1U);
  EXPECT_LT(json["rows"].size(), 3U);
}

TEST(BenchFramesProgram, SaysWhyAFileCannotBeWrittenBeforeItMeasures) {
  const Outcome outcome = run_kerf(bench_frames("/nowhere/frames.json", "10"));
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("/nowhere/frames.json"));
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace kerf
