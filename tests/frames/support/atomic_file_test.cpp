#include "frames/support/atomic_file.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/frames/program.h"

namespace kerf::test {
namespace {

TEST(AtomicFile, WritesAndReplaces) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "frames.json";
  write_file_atomically(file, std::string_view("one"));
  write_file_atomically(file, std::string_view("two"));
  EXPECT_EQ(test::read_text(file), "two");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"frames.json"});
}

TEST(AtomicFile, FailureNamesThePathAndLeavesNothing) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "missing" / "frames.json";
  try {
    write_file_atomically(file, std::string_view("one"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(AtomicFile, AFolderInTheWayIsAnErrorAndStays) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "frames.json");
  EXPECT_THROW(write_file_atomically(folder.path() / "frames.json", std::string_view("one")),
               std::runtime_error);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"frames.json"});
}

TEST(AtomicFile, CopiesWholeFilesOrNothing) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "a", std::string_view("one"));
  copy_file_atomically(folder.path() / "a", folder.path() / "b");
  EXPECT_EQ(test::read_text(folder.path() / "b"), "one");
  EXPECT_THROW(copy_file_atomically(folder.path() / "none", folder.path() / "b"), std::runtime_error);
  EXPECT_EQ(test::read_text(folder.path() / "b"), "one");
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"a", "b"}));
}

TEST(AtomicFile, WritableFolderIsMadeWithItsParentsAndLeftEmpty) {
  const TemporaryFolder folder;
  make_writable_folder(folder.path() / "a" / "b");
  EXPECT_TRUE(test::files_in(folder.path() / "a" / "b").empty());
}

TEST(AtomicFile, FolderBelowAFileIsRefused) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "file", std::string_view("x"));
  EXPECT_THROW(make_writable_folder(folder.path() / "file" / "below"), std::runtime_error);
  EXPECT_THROW(make_writable_folder("/proc/kerf"), std::runtime_error);
}

}  // namespace
}  // namespace kerf::test
