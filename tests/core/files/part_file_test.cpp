#include "core/files/part_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <vector>

#include "core/files/whole_file.h"
#include "core/recording/unfinished.h"
#include "tests/support/temporary_folder.h"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class PartFiles : public ::testing::Test {
 protected:
  [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }
  [[nodiscard]] std::vector<std::string> files() const { return folder_.files(); }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(PartFiles, TheNameComesWithKeepAndTheEarlierFileStaysUntilThen) {
  write("a.txt", "earlier");
  {
    PartFile part(path("a.txt"));
    part.write("new");
    EXPECT_EQ(read_whole_file(path("a.txt")), "earlier");
    EXPECT_EQ(parts_of(path("a.txt")), std::vector<fs::path>{part.path()});
    part.keep();
    EXPECT_EQ(read_whole_file(path("a.txt")), "new");
  }
  EXPECT_EQ(files(), std::vector<std::string>{"a.txt"});
}

TEST_F(PartFiles, WithoutKeepNothingIsLeftNotEvenTheLogOfADatabase) {
  write("a.kerf", "earlier");
  {
    PartFile part(path("a.kerf"));
    part.write("new");
    write(part.path().filename().string() + "-wal", "log");
  }
  EXPECT_EQ(read_whole_file(path("a.kerf")), "earlier");
  EXPECT_EQ(files(), std::vector<std::string>{"a.kerf"});
}

/// Neither has the part of the other, and what a third one left stays.
TEST_F(PartFiles, EachRunHasANameOfItsOwn) {
  write("a.kerf.0123456789abcdef.part", "of a killed run");
  const PartFile one(path("a.kerf"));
  const PartFile other(path("a.kerf"));
  EXPECT_NE(one.path(), other.path());
  EXPECT_EQ(parts_of(path("a.kerf")).size(), 3U);
  EXPECT_EQ(read_whole_file(path("a.kerf.0123456789abcdef.part")), "of a killed run");
}

TEST_F(PartFiles, WhatHasComeMeanwhileIsNotReplacedUnlessAsked) {
  fs::path left;
  {
    PartFile part(path("a.txt"), Replace::nothing);
    part.write("new");
    write("a.txt", "another one");
    EXPECT_THAT([&] { part.keep(); }, ::testing::ThrowsMessage<std::system_error>(
                                          HasSubstr("has come meanwhile; what was made is in")));
    left = part.path();
  }
  EXPECT_EQ(read_whole_file(path("a.txt")), "another one");
  EXPECT_EQ(read_whole_file(left), "new") << "an hour's work is not thrown away";
}

TEST_F(PartFiles, AFolderInTheWayIsAnErrorAndStays) {
  fs::create_directory(path("a.txt"));
  {
    PartFile part(path("a.txt"));
    EXPECT_THROW(part.keep(), std::system_error);
  }
  EXPECT_EQ(files(), std::vector<std::string>{"a.txt"});
}

TEST_F(PartFiles, ALinkToAFileStaysAndItsTargetIsReplaced) {
  write("real.txt", "earlier");
  fs::create_symlink("real.txt", path("a.txt"));
  PartFile part(path("a.txt"));
  part.write("new");
  part.keep();
  EXPECT_TRUE(fs::is_symlink(path("a.txt")));
  EXPECT_EQ(read_whole_file(path("real.txt")), "new");
}

TEST_F(PartFiles, PermissionsOfTheEarlierFileHold) {
  write("a.txt", "secret");
  ASSERT_EQ(::chmod(path("a.txt").c_str(), 0600), 0);
  PartFile part(path("a.txt"));
  part.keep();
  EXPECT_EQ(static_cast<unsigned>(fs::status(path("a.txt")).permissions()), 0600U);
}

TEST_F(PartFiles, NamesOfAnyLengthHaveParts) {
  const std::string longest(255, 'n');
  PartFile part(path(longest));
  part.write("new");
  EXPECT_EQ(parts_of(path(longest)).size(), 1U);
  part.keep();
  EXPECT_EQ(files(), std::vector<std::string>{longest});
}

TEST_F(PartFiles, NamesOfPartsAreKnown) {
  EXPECT_TRUE(is_part_name("a.kerf.0123456789abcdef.part"));
  for (const char* const name : {"a.kerf", "a.part", "a.kerf.0123456789abcdeg.part", "0123456789abcdef.part",
                                 "a.0123456789abcdef.parts", ""})
    EXPECT_FALSE(is_part_name(name)) << name;
}

TEST_F(PartFiles, WhereThereIsNoRecordingItsPartIsMeant) {
  EXPECT_EQ(recording_at(path("a.kerf")), path("a.kerf"));
  write("a.kerf.0123456789abcdef.part", "");
  EXPECT_EQ(recording_at(path("a.kerf")), path("a.kerf.0123456789abcdef.part"));
  write("a.kerf.1123456789abcdef.part", "");
  EXPECT_THAT([&] { (void)recording_at(path("a.kerf")); },
              ::testing::ThrowsMessage<std::runtime_error>(HasSubstr("a.kerf.1123456789abcdef.part")));
  write("a.kerf", "");
  EXPECT_EQ(recording_at(path("a.kerf")), path("a.kerf"));
}

}  // namespace
}  // namespace kerf
