#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "frames/errors.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::Process;
using testing::run_kerf;
using testing::TemporaryFolder;

std::vector<std::string> long_render(const std::filesystem::path& out) {
  return {"render", "pile", "--steps", "1:1000000:1", "--objects", "50", "--size", "160x120", "--out", out};
}

/// Whether `file` comes into being before a minute has passed.
bool appears(const std::filesystem::path& file) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!std::filesystem::exists(file)) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// What is in `folder` is a valid part of a sequence: an incomplete manifest that names exactly the frames
/// that are there, each with the pixels that it says.
void expect_valid_part(const std::filesystem::path& folder) {
  const json manifest = testing::read_json(folder / "frames.json");
  EXPECT_EQ(manifest["complete"], false);
  std::vector<std::string> expected{"frames.json"};
  for (const json& frame : manifest["frames"]) {
    expected.push_back(frame["file"]);
    const std::uint64_t hash = pixel_hash(read_png(folder / frame["file"].get<std::string>()));
    EXPECT_EQ(std::stoull(frame["pixel_hash"].get<std::string>(), nullptr, 16), hash);
  }
  EXPECT_THAT(testing::files_in(folder), ::testing::UnorderedElementsAreArray(expected));
}

class FailureProgram : public ::testing::TestWithParam<int> {};

TEST_P(FailureProgram, SignalLeavesAValidPart) {
  const TemporaryFolder folder;
  auto arguments = long_render(folder.path() / "frames");
  arguments.insert(arguments.end(), {"--video", folder.path() / "film.mp4"});
  Process process(testing::kerf_command(arguments));
  ASSERT_TRUE(appears(folder.path() / "frames" / "pile_000003.png"));
  process.signal(GetParam());
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit, kExitInterrupted);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  EXPECT_EQ(folder.files(), std::vector<std::string>{"frames"}) << "half a film is no film";
  expect_valid_part(folder.path() / "frames");
  EXPECT_GE(testing::read_json(folder.path() / "frames" / "frames.json")["frames"].size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Signals, FailureProgram, ::testing::Values(SIGINT, SIGTERM),
                         [](const ::testing::TestParamInfo<int>& signal) {
                           return signal.param == SIGINT ? "Interrupt" : "Terminate";
                         });

TEST(FailureProgram, KilledRunClaimsNothing) {
  const TemporaryFolder folder;
  Process process(testing::kerf_command(long_render(folder.path())));
  ASSERT_TRUE(appears(folder.path() / "pile_000003.png"));
  process.signal(SIGKILL);
  EXPECT_EQ(process.wait().exit, 128 + SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "frames.json"));
}

TEST(FailureProgram, FolderThatCannotBeMade) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  for (const std::filesystem::path& out :
       {std::filesystem::path("/proc/kerf"), folder.path() / "file" / "below"}) {
    const Outcome outcome = run_kerf(long_render(out));
    EXPECT_EQ(outcome.exit, kExitFailure);
    EXPECT_THAT(outcome.err, HasSubstr(out.string()));
    EXPECT_THAT(outcome.err, HasSubstr("--out"));
  }
  const Outcome file = run_kerf(long_render(folder.path() / "file"));
  EXPECT_EQ(file.exit, kExitUsage);
  EXPECT_THAT(file.err, HasSubstr("not a folder"));
}

TEST(FailureProgram, FileThatMayNotGrowIsAnError) {
  const TemporaryFolder folder;
  const Outcome outcome = run_kerf(long_render(folder.path()), {500, ""});
  EXPECT_EQ(outcome.exit, kExitFailure);
  EXPECT_THAT(outcome.err, HasSubstr("pile_000000.png"));
  EXPECT_THAT(outcome.err, HasSubstr("too large"));
  EXPECT_THAT(testing::files_in(folder.path()), ::testing::Not(::testing::Contains("pile_000000.png")));
}

/// A file system of 300 kB in a mount namespace of its own, which takes a few dozen frames.
TEST(FailureProgram, FullDiskLeavesAValidPart) {
  const TemporaryFolder folder;
  const std::string disk = folder.path() / "disk";
  std::filesystem::create_directory(disk);
  if (Process({"unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", disk}).wait().exit != 0) {
    GTEST_SKIP() << "this user may not mount";
  }
  std::string line = "mount -t tmpfs -o size=300k tmpfs " + disk + " && ";
  for (const std::string& word : testing::kerf_command(long_render(disk))) line += word + " ";
  line += "; code=$?; cp -r " + disk + " " + (folder.path() / "copy").string() + "; exit $code";
  const Outcome outcome = Process({"unshare", "-m", "sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, kExitFailure);
  EXPECT_THAT(outcome.err, HasSubstr("No space left"));
  EXPECT_THAT(outcome.err, HasSubstr("free some space"));
  expect_valid_part(folder.path() / "copy");
}

TEST(FailureProgram, ListIntoAFullDeviceIsAnError) {
  const std::string line = std::string(KERF_PROGRAM) + " scenes > /dev/full";
  const Outcome outcome = Process({"sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, kExitFailure);
  EXPECT_THAT(outcome.err, HasSubstr("standard output"));
}

}  // namespace
}  // namespace kerf
