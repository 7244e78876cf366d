#include "frames/diff/diff_page.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "frames/sequence/draw_list_file.h"
#include "tests/frames/program.h"
#include "tests/frames/report/browser.h"
#include "viz/image/png.h"

namespace kerf::test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr int kWidth = 64;

Image with_block(int left, std::uint32_t color) {
  Image image = make_image(kWidth, 40, 0xfafaf7ffU);
  for (int y = 10; y < 20; ++y)
    for (int x = left; x < left + 12; ++x)
      for (int c = 0; c < 4; ++c)
        image.rgba[static_cast<std::size_t>(4 * (y * kWidth + x) + c)] =
            static_cast<std::uint8_t>(color >> (24 - 8 * c));
  return image;
}

StoredIds ids_of(int left, Color color) {
  StoredIds stored;
  stored.rasterizer = "none";
  stored.ids.list.items.push_back(
      {DrawnKind::plane, 17, 0, color, 120, static_cast<float>(left), 10, static_cast<float>(left + 12), 20});
  stored.ids.image = with_block(left, 0x000001ffU);
  for (std::size_t i = 0; i < stored.ids.image.rgba.size(); i += 4)
    if (stored.ids.image.rgba[i] != 0) std::fill_n(&stored.ids.image.rgba[i], 3, std::uint8_t{0});
  return stored;
}

/// A reference and a test folder with a frame that is the same, one that differs, one that is missing and one
/// that is extra.
class DiffPage : public ::testing::Test {
 protected:
  DiffPage() {
    std::filesystem::create_directories(reference());
    std::filesystem::create_directories(test());
    put(reference() / "differs.png", 10, 0x0072b2ffU);
    put(test() / "differs.png", 13, 0x0072b2ffU);
    for (const auto& folder : {reference(), test()}) put(folder / "same.png", 30, 0x0072b2ffU);
    write_png(reference() / "missing.png", with_block(5, 0xd55e00ffU));
    write_png(test() / "extra.png", with_block(6, 0xd55e00ffU));
  }
  static void put(const std::filesystem::path& frame, int left, std::uint32_t color) {
    write_png(frame, with_block(left, color));
    write_ids(frame, ids_of(left, {0, 114, 178}));
  }
  [[nodiscard]] std::filesystem::path reference() const { return folder_.path() / "it's right"; }
  [[nodiscard]] std::filesystem::path test() const { return folder_.path() / "new"; }
  [[nodiscard]] std::filesystem::path page() const { return folder_.path() / "page/index.html"; }
  [[nodiscard]] RunOutcome diff(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"diff", reference(), test()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_kerf(arguments);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(DiffPage, ShowsEverythingWithoutAnythingFromElsewhere) {
  const RunOutcome outcome = diff({"--report", page().parent_path()});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.out, HasSubstr("plane n17 moved by (3.0, 0.0) pixels"));
  const Sight sight = look_at(page());
  EXPECT_EQ(sight.trouble, "");
  EXPECT_THAT(sight.console, IsEmpty());
  for (const std::string& resource : sight.resources) EXPECT_THAT(resource, HasSubstr("data:"));
  EXPECT_EQ(
      sight.images.size(),
      4U + 2U + 1U + 1U);  // new, reference, heat and ids of one, and its two id images; one of each other
  EXPECT_THAT(sight.images, Each(kWidth));
  EXPECT_TRUE(sight.fits);
  const std::string text = test::read_text(page());
  EXPECT_THAT(text, HasSubstr("plane n17 moved by"));
  EXPECT_THAT(text, HasSubstr("it is missing"));
  EXPECT_THAT(text, Not(HasSubstr(">same.png<")));
  EXPECT_THAT(text, HasSubstr("it'\\''s right' "));  // a command that a shell reads
}

TEST_F(DiffPage, PointingSwapsAndMagnifies) {
  (void)diff({"--report", page().parent_path()});
  const Sight sight = look_at(page(), R"js(
    const section = document.querySelector("section");
    const image = section.querySelector(".new img"), right = section.querySelector(".reference img");
    const own = image.src, words = [];
    words.push(own !== right.src ? "differs" : "equal");
    image.dispatchEvent(new MouseEvent("mouseenter"));
    words.push(image.src === right.src ? "swapped" : "not swapped");
    const box = image.getBoundingClientRect();
    image.dispatchEvent(new MouseEvent("mousemove", {clientX: box.left + 0.6 * box.width, clientY: box.top + 5}));
    const lenses = section.querySelectorAll(".lens");
    words.push(lenses.length + " lenses at " + lenses[0].title + " zoomed to " + lenses[0].style.backgroundSize);
    image.dispatchEvent(new MouseEvent("mouseleave"));
    words.push(image.src === own ? "back" : "not back");
    section.querySelector("button").click();
    words.push(lenses[0].title === "(38, 0)"
                                          ? "stuck"
                                          : "moved");
  return words.join(", ");)js");
  EXPECT_EQ(sight.trouble, "");
  EXPECT_THAT(sight.console, IsEmpty());
  EXPECT_EQ(sight.answer, "differs, swapped, 4 lenses at (38, 0) zoomed to 512px 320px, back, moved");
}

/// The greys of ids are numbers.
TEST_F(DiffPage, PointingNamesWhatLiesThere) {
  (void)diff({"--report", page().parent_path()});
  const Sight sight = look_at(page(), R"js(
    const section = document.querySelector("section"), under = section.querySelector(".under");
    const words = [under.textContent], image = section.querySelector(".ids img");
    const box = image.getBoundingClientRect();
    for (const [x, y] of [[11, 15], [14, 15], [23, 15], [2, 2]]) {
      const place = {clientX: box.left + (x + 0.5) / image.naturalWidth * box.width,
                     clientY: box.top + (y + 0.5) / image.naturalHeight * box.height};
      image.dispatchEvent(new MouseEvent("mousemove", place));
      words.push(under.textContent);
    }
    return words.join("; ");)js");
  EXPECT_EQ(sight.trouble, "");
  EXPECT_THAT(sight.console, IsEmpty());
  EXPECT_EQ(sight.answer,
            "Point at a picture: here stands what lies there.; (11, 15): reference plane n17, new ground; "
            "(14, 15): reference plane n17, new plane n17; (23, 15): reference ground, new plane n17; "
            "(2, 2): reference ground, new ground");
}

TEST_F(DiffPage, ApprovingTouchesOnlyWhatFailed) {
  const auto same = reference() / "same.png";
  const auto before = std::filesystem::last_write_time(same);
  const RunOutcome outcome = diff({"--approve"});
  EXPECT_EQ(outcome.exit, 1);
  EXPECT_THAT(outcome.err, HasSubstr("1 of the references has no frame and was left alone"));
  EXPECT_THAT(outcome.err, HasSubstr("approved differs.png"));
  EXPECT_THAT(outcome.err, HasSubstr("2 frames approved"));
  EXPECT_EQ(std::filesystem::last_write_time(same), before);
  EXPECT_EQ(read_png(reference() / "differs.png"), read_png(test() / "differs.png"));
  EXPECT_EQ(read_ids(reference() / "differs.png")->ids.list.items,
            read_ids(test() / "differs.png")->ids.list.items);
  EXPECT_TRUE(std::filesystem::exists(reference() / "extra.png"));
  EXPECT_TRUE(std::filesystem::exists(reference() / "missing.png"));
  const RunOutcome again = diff({});
  EXPECT_THAT(again.err, HasSubstr("1 of 4 frames differs, 1 of them missing"));
}

TEST_F(DiffPage, ApprovingADamagedPictureIsRefusedAndChangesNothing) {
  std::ofstream(test() / "extra.png") << "no picture";
  const Image before = read_png(reference() / "differs.png");
  const RunOutcome outcome = diff({"--approve"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nothing was approved"));
  EXPECT_EQ(read_png(reference() / "differs.png"), before);
}

TEST_F(DiffPage, ApprovingIntoAnEmptyOrNewFolderBeginsIt) {
  std::filesystem::remove_all(reference());
  const RunOutcome outcome = diff({"--approve"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(diff({}).exit, 0);
}

TEST_F(DiffPage, IdsThatCannotBeReadOrAreLackingAreUnusable) {
  std::ofstream(reference() / "differs.draw.json") << "{}";
  RunOutcome outcome = diff({});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.out, HasSubstr("it is no draw list"));
  std::filesystem::remove(reference() / "differs.draw.json");
  std::filesystem::remove(reference() / "differs.ids.png");
  outcome = diff({"--gate", "ids"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.out, HasSubstr("draw it with --ids"));
}

TEST_F(DiffPage, AReportIntoAFolderThatCannotBeWrittenIsRefusedBeforeTheWork) {
  const RunOutcome outcome = diff({"--report", "/proc/nowhere"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/nowhere"));
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace kerf::test
