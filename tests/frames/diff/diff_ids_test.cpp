#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/files/whole_file.h"
#include "frames/sequence/draw_list_file.h"
#include "frames/sequence/sidecar.h"
#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two folders with the same two frames, each with its ids.
class DiffIds : public ::testing::Test {
 protected:
  DiffIds() {
    for (const fs::path& folder : {reference(), test()}) {
      fs::create_directory(folder);
      for (const char* name : {"a.png", "b.png"}) {
        write_png(folder / name, make_image(16, 16, 0xff203040U));
        write_ids(folder / name, ids());
      }
    }
  }
  static StoredIds ids() {
    StoredIds stored;
    stored.ids.image = make_image(16, 16, 0x000001ffU);
    stored.ids.list.items.push_back({});
    stored.rasterizer = "llvmpipe";
    return stored;
  }
  [[nodiscard]] fs::path reference() const { return folder_.path() / "reference"; }
  [[nodiscard]] fs::path test() const { return folder_.path() / "test"; }
  [[nodiscard]] RunOutcome diff(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"diff", reference(), test()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_kerf(arguments);
  }
  static void expect_said(const RunOutcome& outcome, const std::string& what) {
    EXPECT_EQ(outcome.exit, 1) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(what));
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("the same")));
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DiffIds, EachFileThatOnlyOneSideHasIsSaid) {
  ASSERT_EQ(diff().exit, 0) << diff().out;
  fs::remove(draw_list_path(test() / "a.png"));
  expect_said(diff(), "a.png: a.draw.json beside it is missing\n");
  fs::remove(ids_path(test() / "a.png"));
  expect_said(diff(), "a.png:\n  a.ids.png beside it is missing\n  a.draw.json beside it is missing\n");
  write_ids(test() / "a.png", ids());
  fs::remove(ids_path(reference() / "b.png"));
  expect_said(diff(), "b.png: b.ids.png beside it has no reference\n");
  fs::remove(draw_list_path(reference() / "b.png"));
  expect_said(diff(), "b.draw.json beside it has no reference\n");
  EXPECT_THAT(diff().err, HasSubstr("1 of 2 frames differs"));
}

TEST_F(DiffIds, AFrameThatDiffersIsComparedWithoutIdsToo) {
  write_png(test() / "a.png", make_image(16, 16, 0xff203041U));
  fs::remove(ids_path(test() / "a.png"));
  expect_said(diff(), "256 of 256 pixels differ");
  expect_said(diff(), "a.ids.png beside it is missing");
}

TEST_F(DiffIds, OtherIdsBesideTheSamePixelsAreADifference) {
  StoredIds other = ids();
  other.ids.list.items.front().color = {9, 9, 9};
  fs::remove(ids_path(test() / "a.png"));
  fs::remove(draw_list_path(test() / "a.png"));
  write_ids(test() / "a.png", other);
  expect_said(diff(), "recoloured");
  std::ofstream(draw_list_path(test() / "a.png")) << "{}";
  EXPECT_EQ(diff().exit, 2);
}

/// They were taken for ground, and so was the ground of the other picture.
TEST_F(DiffIds, APixelOfAnItemThatIsNotThereIsRefused) {
  write_png(ids_path(test() / "a.png"), make_image(16, 16, 0x000002ffU), Replace::earlier);
  for (const std::vector<std::string>& options : {std::vector<std::string>(), {"--approve"}}) {
    EXPECT_EQ(diff(options).exit, 2);
    EXPECT_THAT(diff(options).out,
                HasSubstr("a.ids.png: a pixel is of item 2, and the draw list has 1 item"));
  }
  EXPECT_EQ(read_png(ids_path(reference() / "a.png")).rgba, ids().ids.image.rgba);
}

TEST_F(DiffIds, AColourIsAHashAndEightDigits) {
  const fs::path list = draw_list_path(test() / "a.png");
  const std::string text = read_whole_file(list);
  const std::string color = "#000000ff";
  ASSERT_NE(text.find(color), std::string::npos) << text;
  for (const std::string other :
       {"#000000ff or whatever", "#ff", "000000ff", "#000000f", "#000000fg", "#-00000ff", "# 00000ff", ""}) {
    std::ofstream(list) << std::string(text).replace(text.find(color), color.size(), other);
    EXPECT_EQ(diff().exit, 2) << other;
    EXPECT_THAT(diff().out, HasSubstr("'" + other + "' is no colour"));
  }
}

TEST_F(DiffIds, ApprovingTakesThemOrTakesThemAway) {
  fs::remove(ids_path(test() / "a.png"));
  fs::remove(draw_list_path(test() / "a.png"));
  fs::remove(ids_path(reference() / "b.png"));
  fs::remove(draw_list_path(reference() / "b.png"));
  EXPECT_EQ(diff({"--approve"}).exit, 0);
  EXPECT_FALSE(fs::exists(ids_path(reference() / "a.png")));
  EXPECT_TRUE(fs::exists(ids_path(reference() / "b.png")));
  EXPECT_EQ(diff().exit, 0);
}

TEST_F(DiffIds, OfTwoFilesItIsSaidThatOnlyPixelsWereCompared) {
  fs::remove(ids_path(test() / "a.png"));
  const RunOutcome outcome = run_kerf({"diff", reference() / "a.png", test() / "a.png"});
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_THAT(outcome.out, HasSubstr("note: there are no ids beside " + (test() / "a.png").string() +
                                     ": only the pixels were compared"));
}

}  // namespace
}  // namespace kerf::test
