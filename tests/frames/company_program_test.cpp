#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "core/recording/recording_reader.h"
#include "core/recording/writer_lock.h"
#include "tests/frames/program.h"

namespace kerf::test {
namespace {

using ::testing::HasSubstr;

/// A recording that goes on until it is interrupted.
class CompanyProgram : public ::testing::Test {
 protected:
  void begin(const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{"record", "pile", "-o", file(), "--steps", "900000", "--objects", "30"};
    command.insert(command.end(), more.begin(), more.end());
    first_.emplace(kerf_command(command));
    holds_within_a_minute([this] { return steps() > 10; });
  }
  [[nodiscard]] std::uint32_t steps() const {
    try {
      return RecordingReader<2>(file()).steps();
    } catch (const std::runtime_error&) {
      return 0;
    }
  }
  [[nodiscard]] std::string file() const { return folder_.path() / "a.kerf"; }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() / name; }

  std::optional<Process> first_;

 private:
  TemporaryFolder folder_;
};

TEST_F(CompanyProgram, ASecondWriterIsRefusedAndTheFirstGoesOn) {
  begin();
  std::ofstream(path("boxes.csv")) << "1,0,0,1,0,1\n";
  const std::uint32_t before = steps();
  for (const std::vector<std::string>& second :
       std::vector<std::vector<std::string>>{{"record", "pile", "-o", file(), "--steps", "5"},
                                             {"record", "pile", "-o", file(), "--steps", "5", "--overwrite"},
                                             {"import", path("boxes.csv"), "-o", file(), "--overwrite"},
                                             {"render", "pile", "--steps", "1:5", "--size", "64x64", "--out",
                                              path("frames"), "--record", file(), "--overwrite"},
                                             {"debug", "pile", "--steps", "5", "--headless", "--script",
                                              path("boxes.csv"), "--record", file(), "--overwrite"}}) {
    const RunOutcome outcome = run_kerf(second);
    EXPECT_EQ(outcome.exit, 2) << second.front();
  }
  EXPECT_THAT(run_kerf({"record", "pile", "-o", file(), "--steps", "5", "--overwrite"}).err,
              HasSubstr("is being written at this moment"));
  holds_within_a_minute([&] { return steps() > before; });
  EXPECT_GT(steps(), before);
  first_->signal(SIGINT);
  EXPECT_EQ(first_->wait().exit, 130);
  EXPECT_EQ(run_kerf({"verify", file(), "--oracle-every", "0"}).exit, 0);
  EXPECT_EQ(run_kerf({"record", "pile", "-o", file(), "--steps", "5", "--overwrite"}).exit, 0);
}

TEST_F(CompanyProgram, AfterAKilledWriterAnotherMayWrite) {
  begin();
  first_->signal(SIGKILL);
  first_->wait();
  EXPECT_EQ(run_kerf({"record", "pile", "-o", file(), "--steps", "5", "--overwrite"}).exit, 0);
}

/// Another process reads it while it ends.
TEST_F(CompanyProgram, AReaderBreaksNoRecorder) {
  begin();
  RecordingReader<2> reader(file());
  first_->signal(SIGINT);
  const RunOutcome outcome = first_->wait();
  EXPECT_EQ(outcome.exit, 130) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
  for (std::uint32_t step = 1; step <= reader.steps(); ++step) EXPECT_NO_THROW((void)reader.step(step));
  EXPECT_TRUE(RecordingReader<2>(file()).info().complete);
  EXPECT_EQ(run_kerf({"verify", file(), "--oracle-every", "0"}).exit, 0);
}

/// The same for the film that is made beside it.
TEST_F(CompanyProgram, AReaderBreaksNoFilm) {
  Process render(kerf_command({"render", "pile", "--steps", "1:400:20", "--size", "160x120", "--objects",
                               "30", "--out", path("frames"), "--record", file()}));
  std::unique_ptr<RecordingReader<2>> reader;
  holds_within_a_minute([&] {
    try {
      reader = std::make_unique<RecordingReader<2>>(file());
    } catch (const std::runtime_error&) {
    }
    return reader != nullptr;
  });
  ASSERT_NE(reader, nullptr);
  const RunOutcome outcome = render.wait();
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(RecordingReader<2>(file()).steps(), 400U);
  EXPECT_EQ(run_kerf({"collect", path("frames")}).exit, 0);
}

/// In a mount namespace of its own, where the folder is read-only.
TEST_F(CompanyProgram, AKilledRecordingOpensFromAFolderThatCannotBeWritten) {
  begin();
  first_->signal(SIGKILL);
  first_->wait();
  const std::string folder = std::filesystem::path(file()).parent_path();
  const std::string mount =
      "mount --bind " + folder + " " + folder + " && mount -o remount,bind,ro " + folder;
  if (Process({"unshare", "-m", "sh", "-c", mount}).wait().exit != 0)
    GTEST_SKIP() << "this user may not mount";
  std::filesystem::remove(file() + "-shm");
  std::string line = mount + " && ! touch " + folder + "/x 2>/dev/null && ";
  for (const std::string& word : kerf_command({"verify", file(), "--oracle-every", "0"})) line += word + " ";
  const RunOutcome outcome = Process({"unshare", "-m", "sh", "-c", line}).wait();
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("is as recorded"));
}

}  // namespace
}  // namespace kerf::test
