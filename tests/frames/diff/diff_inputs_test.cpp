#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/frames/program.h"
#include "tests/support/png_file.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// Whatever lies in what is compared: it is compared in full, or refused by its name.
class DiffInputs : public ::testing::Test {
 protected:
  DiffInputs() {
    for (const fs::path& folder : {reference(), test()}) {
      fs::create_directory(folder);
      write(folder / "a.png", plain());
    }
  }
  [[nodiscard]] fs::path reference() const { return folder_.path() / "reference"; }
  [[nodiscard]] fs::path test() const { return folder_.path() / "test"; }

  static PngFile plain() {
    PngFile file;
    file.rows = png_rows(repeat("\x80\x12\x34", 16));
    return file;
  }
  static PngFile with(const std::string& type, const std::string& data) {
    PngFile file = plain();
    file.before = {{type, data}};
    return file;
  }
  static PngFile deep(const std::string& pixel) {
    PngFile file;
    file.depth = 16;
    file.rows = png_rows(repeat(pixel, 16));
    return file;
  }
  static void write(const fs::path& path, const PngFile& file) { write(path, file.bytes()); }
  static void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
  }
  [[nodiscard]] RunOutcome diff(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"diff", reference(), test()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_kerf(arguments);
  }
  /// Both folders are refused, and `name` is said.
  void expect_refused(const std::string& name) const {
    const RunOutcome outcome = diff();
    EXPECT_EQ(outcome.exit, 2) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(name));
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("the same")));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DiffInputs, TheLowerHalfOf16BitsCounts) {
  write(reference() / "a.png", deep(std::string("\x80\0\x12\x01\x34\x02", 6)));
  write(test() / "a.png", deep(std::string("\x80\xff\x12\x01\x34\x02", 6)));
  const RunOutcome outcome = diff();
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, HasSubstr("256 of 256 pixels differ in the lower 8 of their 16 bits"));
  write(test() / "a.png", plain());
  EXPECT_EQ(diff().exit, 1);
  write(reference() / "a.png", deep("\x80\x80\x12\x12\x34\x34"));
  EXPECT_EQ(diff().exit, 0);
}

TEST_F(DiffInputs, ChunksOfColourAndAnimationAreComparedOrRefused) {
  for (const char* type : {"gAMA", "cHRM", "sRGB", "iCCP", "sBIT", "bKGD", "eXIf", "acTL", "fdAT"}) {
    write(test() / "a.png", with(type, "data"));
    expect_refused(type);
    write(reference() / "a.png", with(type, "other"));
    expect_refused(type);
    write(reference() / "a.png", with(type, "data"));
    EXPECT_EQ(diff().exit, 0) << type;
    write(reference() / "a.png", plain());
  }
}

TEST_F(DiffInputs, EndingsInCapitalsAreFrames) {
  write(reference() / "B.PNG", plain());
  write(test() / "B.PNG", deep("\x01\x01\x01\x01\x01\x01"));
  EXPECT_EQ(diff().exit, 1);
  EXPECT_THAT(diff().out, HasSubstr("B.PNG"));
  fs::remove(test() / "B.PNG");
  EXPECT_THAT(diff().out, HasSubstr("B.PNG: it is missing"));
}

TEST_F(DiffInputs, OtherFilesMustBeTheSame) {
  for (const char* name : {"photo.jpg", "notes", ".hidden.png", "c.ids.txt", "b.draw.json"}) {
    write(reference() / name, "some bytes");
    expect_refused(name);
    write(test() / name, "other bytes");
    expect_refused(name);
    write(test() / name, "some bytes");
    EXPECT_EQ(diff().exit, 0) << name;
    fs::remove(reference() / name);
    expect_refused(name);
    fs::remove(test() / name);
  }
}

TEST_F(DiffInputs, WhatIsHiddenIsSaidToBe) {
  write(reference() / ".a.png", plain());
  expect_refused(".a.png is a hidden file and has no partner");
  fs::rename(reference() / ".a.png", reference() / "a");
  expect_refused("a is no PNG and has no partner");
}

/// "a.ids.png" belongs to "a.png" only if there is a draw list, too.
TEST_F(DiffInputs, APictureThatIsOnlyNamedLikeIdsIsAFrame) {
  write(reference() / "a.ids.png", plain());
  write(test() / "a.ids.png", deep("\x01\x01\x01\x01\x01\x01"));
  EXPECT_EQ(diff().exit, 1);
  EXPECT_THAT(diff().out, HasSubstr("a.ids.png"));
}

TEST_F(DiffInputs, LinksAreFollowedToFilesAndRefusedElsewhere) {
  fs::create_symlink(reference() / "a.png", test() / "b.png");
  fs::create_symlink(test() / "a.png", reference() / "b.png");
  EXPECT_EQ(diff().exit, 0);
  fs::create_symlink("nowhere", test() / "c.png");
  expect_refused("c.png is a link that leads nowhere");
  fs::remove(test() / "c.png");
  fs::create_directory_symlink(reference(), test() / "folder");
  expect_refused("folder is a link to a folder");
  fs::remove(test() / "folder");
  ASSERT_EQ(::mkfifo((test() / "d.png").c_str(), 0600), 0);
  expect_refused("d.png is neither a file nor a folder");
}

TEST_F(DiffInputs, FoldersBelowAreComparedAndEmptyOnesNamed) {
  fs::create_directories(reference() / "below/deeper");
  expect_refused("deeper is an empty folder");
  write(reference() / "below/deeper/b.png", plain());
  EXPECT_EQ(diff().exit, 1);
  EXPECT_THAT(diff().out, HasSubstr("below/deeper/b.png: it is missing"));
  fs::create_directories(test() / "below/deeper");
  write(test() / "below/deeper/b.png", plain());
  EXPECT_EQ(diff().exit, 0);
  write(test() / "below/frames.json", R"({"frames": [{"file": "z.png"}]})");
  expect_refused("'z.png' is not in");
}

TEST_F(DiffInputs, OneFileTwiceIsSaid) {
  fs::remove_all(test());
  fs::create_directory_symlink(reference(), test());
  const RunOutcome outcome = diff();
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_THAT(outcome.out, HasSubstr("are one and the same"));
}

TEST_F(DiffInputs, ApprovingReplacesWhatALinkLeadsTo) {
  const fs::path store = reference().parent_path() / "stored.png";
  fs::rename(reference() / "a.png", store);
  fs::permissions(store, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  fs::create_symlink("../stored.png", reference() / "a.png");
  write(test() / "a.png", deep("\x01\x01\x01\x01\x01\x01"));
  const RunOutcome outcome = diff({"--approve"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("approved a.png (a link to "));
  EXPECT_TRUE(fs::is_symlink(reference() / "a.png"));
  EXPECT_EQ(read_text(store), read_text(test() / "a.png"));
  EXPECT_EQ(fs::status(store).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST_F(DiffInputs, ApprovingSaysWhatWasNotCompared) {
  write(test() / "photo.jpg", "bytes");
  write(test() / "a.png", deep("\x01\x01\x01\x01\x01\x01"));
  const RunOutcome outcome = diff({"--approve"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.out, HasSubstr("photo.jpg"));
  EXPECT_THAT(outcome.err, HasSubstr("not all that lies there was compared"));
}

}  // namespace
}  // namespace kerf::test
