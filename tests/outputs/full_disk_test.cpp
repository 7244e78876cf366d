#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/files/part_file.h"
#include "core/recording/recording_reader.h"
#include "frames/support/errors.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Words = std::vector<std::string>;

const char* const kSteps = "600";

RunOutcome record(const std::filesystem::path& file, const Surroundings& surroundings = {}) {
  return run_kerf({"record", "pile", "-o", file, "--steps", kSteps, "--objects", "60"}, surroundings);
}

/// What was recorded before the disk was full is there, and the message says where and how far it goes.
void expect_kept(const std::filesystem::path& file, const RunOutcome& outcome) {
  EXPECT_EQ(outcome.exit, kExitUnusable) << outcome.out;
  const auto parts = parts_of(file);
  ASSERT_EQ(parts.size(), 1U) << outcome.err;
  const RecordingReader<2> kept(parts.front());
  EXPECT_GT(kept.steps(), 0U);
  EXPECT_THAT(outcome.err,
              HasSubstr("(steps 1 to " + std::to_string(kept.steps()) + ") is in " + parts.front().string()));
  const RunOutcome verified = run_kerf({"verify", parts.front(), "--oracle-every", "0"});
  EXPECT_EQ(verified.exit, kExitHolds) << verified.err;
}

struct Writer {
  const char* name;
  std::vector<std::string> arguments;  ///< IN: a recording, BOXES: its boxes, OUT: the new recording
  std::uint64_t largest_file;
};

class FullDisk : public ::testing::TestWithParam<Writer> {
 protected:
  void SetUp() override {
    ASSERT_EQ(record(in()).exit, kExitHolds);
    ASSERT_EQ(run_kerf({"export", in(), "--boxes", "-o", boxes()}).exit, kExitHolds);
  }
  [[nodiscard]] std::string in() const { return folder_.path() / "in.kerf"; }
  [[nodiscard]] std::string boxes() const { return folder_.path() / "boxes.csv"; }
  [[nodiscard]] std::string out() const { return folder_.path() / "out.kerf"; }

  [[nodiscard]] RunOutcome run(bool overwrite) const {
    Words words;
    for (const std::string& word : GetParam().arguments)
      words.push_back(word == "IN"       ? in()
                      : word == "BOXES"  ? boxes()
                      : word == "OUT"    ? out()
                      : word == "FRAMES" ? (folder_.path() / "frames").string()
                                         : word);
    if (overwrite) words.emplace_back("--overwrite");
    return run_kerf(words, {.largest_file = GetParam().largest_file});
  }

 private:
  TemporaryFolder folder_;
};

/// A file that may not grow further is as good as a full disk. All that was recorded so far was deleted.
TEST_P(FullDisk, KeepsWhatWasRecorded) { expect_kept(out(), run(false)); }

TEST_P(FullDisk, LeavesTheEarlierRecordingAsItIs) {
  ASSERT_EQ(run_kerf({"record", "pile", "-o", out(), "--steps", "3", "--objects", "20"}).exit, kExitHolds);
  const std::string earlier = read_text(out());
  expect_kept(out(), run(true));
  EXPECT_TRUE(read_text(out()) == earlier);
}

INSTANTIATE_TEST_SUITE_P(
    Commands, FullDisk,
    ::testing::Values(
        Writer{"Record", {"record", "pile", "-o", "OUT", "--steps", kSteps, "--objects", "60"}, 500'000},
        Writer{"Render",
               {"render", "pile", "--record", "OUT", "--steps", "1:600:599", "--objects", "60", "--size",
                "64x64", "--workers", "0", "--out", "FRAMES"},
               500'000},
        Writer{"Import", {"import", "BOXES", "-o", "OUT"}, 500'000},
        Writer{"Rerun", {"rerun", "IN", "-o", "OUT"}, 500'000}),
    [](const auto& writer) { return writer.param.name; });

/// Pictures, pages and tables of which a part is of no use go away, and so does a recording without a step.
TEST(FullDiskRecord, LeavesNothingThatIsOfNoUse) {
  const TemporaryFolder folder;
  const RunOutcome outcome = record(folder.path() / "a.kerf", {.largest_file = 20'000});
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(folder.files(), IsEmpty()) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("what was recorded")));
}

/// A file system of 1 MB in a mount namespace of its own. There is no room for what is in the log.
TEST(FullDiskRecord, OfARealDiskAdvisesAndTheRecordingIsRead) {
  const TemporaryFolder folder;
  const std::string disk = folder.path() / "disk";
  std::filesystem::create_directory(disk);
  if (Process({"unshare", "-m", "mount", "-t", "tmpfs", "tmpfs", disk}).wait().exit != 0) {
    GTEST_SKIP() << "this user may not mount";
  }
  std::string line = "mount -t tmpfs -o size=1000k tmpfs " + disk + " && ";
  for (const std::string& word :
       kerf_command({"record", "pile", "-o", disk + "/a.kerf", "--steps", "100000", "--objects", "60"}))
    line += word + " ";
  line += "; code=$?; " + kerf_command({}).front() + " verify " + disk +
          "/a.kerf --oracle-every 0 > /dev/null && exit $code";
  const RunOutcome outcome = Process({"unshare", "-m", "sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, kExitUnusable);
  EXPECT_THAT(outcome.err, HasSubstr("database or disk is full"));
  EXPECT_THAT(outcome.err,
              ::testing::ContainsRegex("steps 1 to [0-9]+. is in .*a.kerf.*part; free some space"));
}

}  // namespace
}  // namespace kerf::test
