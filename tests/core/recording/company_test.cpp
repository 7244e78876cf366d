#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "core/recording/recorder.h"
#include "core/recording/recording_reader.h"
#include "core/recording/schema.h"
#include "core/recording/writer_lock.h"
#include "core/replay/verify.h"
#include "tests/support/recorded_crowd.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr std::uint32_t kSteps = 60;

std::vector<std::string> files_beside(const fs::path& path) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path.parent_path()))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

void record_and_die(const fs::path& path) {
  const pid_t child = fork();
  if (child != 0) {
    waitpid(child, nullptr, 0);
    return;
  }
  Bsp<2, EventLog> tree(test::busy_config());
  Recorder<2> recorder(tree, path, test::info_of<2>(tree.config()));
  test::play_crowd<2>(recorder, kSteps, 1, [&](std::uint32_t step) {
    if (step == kSteps) kill(getpid(), SIGKILL);
  });
}

/// Readers open it while it is written and stay beyond the end. What they have read stays readable, and
/// the file alone has everything.
TEST(RecordingCompany, ReadersDoNotKeepAWriterFromEnding) {
  const TemporaryRecording file;
  const fs::path copy = file.path().parent_path() / "copy.kerf";
  Bsp<2, EventLog> tree(test::busy_config());
  Recorder<2> recorder(tree, file.path(), test::info_of<2>(tree.config()));
  std::vector<std::unique_ptr<RecordingReader<2>>> readers;
  test::play_crowd<2>(recorder, kSteps, 1, [&](std::uint32_t step) {
    if (step == 30 || step == 55) readers.push_back(std::make_unique<RecordingReader<2>>(file.path()));
  });
  EXPECT_NO_THROW(recorder.finish());
  EXPECT_FALSE(is_being_written(file.path()));
  fs::copy_file(file.path(), copy);
  EXPECT_EQ(RecordingReader<2>(copy).steps(), kSteps);
  EXPECT_TRUE(RecordingReader<2>(copy).info().complete);
  EXPECT_GE(readers.front()->steps(), 25U);  // whole blocks, more where the machine is slow
  EXPECT_LT(readers.front()->steps(), readers.back()->steps());
  RecordingReader<2> late(file.path());
  EXPECT_EQ(late.steps(), kSteps);
  for (const auto& reader : readers) {
    for (std::uint32_t step = 1; step <= reader->steps(); ++step)
      EXPECT_EQ(reader->step(step).events.size(), late.step(step).events.size()) << step;
    EXPECT_FALSE(reader->operators().empty());
    EXPECT_LE(reader->operators().back().step, reader->steps()) << "of the moment when it was opened";
  }
  EXPECT_TRUE(verify(file.path()).holds());
}

TEST(RecordingCompany, ASecondWriterIsRefusedWhileTheFirstIsAlive) {
  const TemporaryRecording file;
  {
    const WriterLock first(file.path());
    EXPECT_TRUE(is_being_written(file.path()));
    try {
      test::record_crowd<2>(file.path(), 1, test::busy_config());
      ADD_FAILURE() << "two have written";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), HasSubstr("is being written at this moment"));
    }
    EXPECT_FALSE(fs::exists(file.path()));
  }
  EXPECT_THAT(files_beside(file.path()), ::testing::IsEmpty()) << "the lock leaves no trace";
  EXPECT_NO_THROW(test::record_crowd<2>(file.path(), 1, test::busy_config()));
}

TEST(RecordingCompany, TheLockOfTheDeadDoesNotHold) {
  const TemporaryRecording file;
  record_and_die(file.path());
  EXPECT_FALSE(is_being_written(file.path()));
  EXPECT_NO_THROW(WriterLock{file.path()});
}

/// As if the folder could not be written: nothing in it changes, whatever SQLite would like to put there.
TEST(RecordingCompany, AKilledRecordingIsReadWithoutATrace) {
  const TemporaryRecording file;
  record_and_die(file.path());
  const std::string log = file.path().string() + "-wal";
  fs::remove(file.path().string() + "-shm");
  const auto files = files_beside(file.path());
  const auto size = fs::file_size(log);
  ASSERT_GT(size, 0U);
  {
    RecordingReader<2> reader(file.path());
    RecordingReader<2> another(file.path());
    ASSERT_GE(reader.steps(), 50U) << "those of whole blocks";
    EXPECT_FALSE(reader.step(50).events.empty() && reader.step(49).events.empty());
    EXPECT_EQ(files_beside(file.path()), files);
  }
  EXPECT_TRUE(verify(file.path()).holds());
  EXPECT_EQ(files_beside(file.path()), files);
  EXPECT_EQ(fs::file_size(log), size);
}

/// Names that SQLite, a URI or a shell could take for something else; relative, as users give them.
TEST(RecordingCompany, ANameIsAName) {
  const TemporaryRecording place;
  const fs::path before = fs::current_path();
  fs::current_path(place.path().parent_path());
  for (const std::string& name :
       {std::string("file:x.kerf"), std::string("file:y.kerf?mode=memory"), std::string(":memory:"),
        std::string("-x.kerf"), std::string("a%20b#c?d=e.kerf"), std::string("\xff\xfe bad.kerf"),
        std::string(242, 'n') + ".kerf"}) {
    test::record_crowd<2>(name, kSteps, test::busy_config());
    EXPECT_EQ(files_beside(place.path()), std::vector<std::string>{name});
    EXPECT_EQ(RecordingReader<2>(name).steps(), kSteps);
    fs::remove(name);
    record_and_die(name);
    EXPECT_GE(RecordingReader<2>(name).steps(), 50U) << name;
    for (const std::string& file : files_beside(place.path())) fs::remove(file);
  }
  fs::current_path(before);
}

}  // namespace
}  // namespace kerf::test
