#include "frames/sequence/contact_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>

#include "tests/frames/program.h"
#include "viz/image/png.h"

namespace kerf {
namespace {

/// Saves the sheet of `frames` grey pictures and gives the picture back.
Image sheet_of(std::uint32_t frames, int width, int height) {
  const test::TemporaryFolder folder;
  ContactStrip strip(frames);
  const Image grey = make_image(width, height, 0xff808080U);
  for (std::uint32_t frame = 0; frame < frames; ++frame) strip.offer(frame, grey);
  strip.save(folder.path() / "sheet.png", Replace::nothing);
  return read_png(folder.path() / "sheet.png");
}

TEST(ContactStrip, LongSequencesGiveTwentyPictures) {
  const Image many = sheet_of(1000, 48, 24);
  const Image twenty = sheet_of(20, 48, 24);
  EXPECT_EQ(many.width, twenty.width);
  EXPECT_EQ(many.height, twenty.height);
  EXPECT_GE(many.width, 4 * 48);
  EXPECT_GE(many.height, 5 * 24);
  for (const std::uint32_t frames : {21U, 22U, 37U, 200U, 251U})
    EXPECT_EQ(sheet_of(frames, 48, 24), many) << frames;
}

/// The colours of a sheet in which frame n has the colour n, which is its green and blue; no others have no
/// red.
std::set<std::uint32_t> colours_of(std::uint32_t frames) {
  const test::TemporaryFolder folder;
  ContactStrip strip(frames);
  for (std::uint32_t frame = 0; frame < frames; ++frame)
    strip.offer(frame, make_image(48, 24, frame << 8U | 0xffU));
  strip.save(folder.path() / "sheet.png", Replace::nothing);
  const Image sheet = read_png(folder.path() / "sheet.png");
  std::set<std::uint32_t> colours;
  for (int y = 0; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x)
      if (const std::uint8_t* const pixel = sheet.pixel(x, y); pixel[0] == 0)
        colours.insert(std::uint32_t{pixel[1]} << 8U | pixel[2]);
  return colours;
}

TEST(ContactStrip, BeginsWithTheFirstFrameAndEndsWithTheLast) {
  for (const std::uint32_t frames : {1U, 5U, 20U, 251U, 1000U}) {
    const std::set<std::uint32_t> colours = colours_of(frames);
    EXPECT_EQ(colours.size(), std::min(frames, 20U));
    EXPECT_EQ(*colours.begin(), 0U);
    EXPECT_EQ(*colours.rbegin(), frames - 1);
  }
}

TEST(ContactStrip, ShortSequencesAreShownWhole) {
  EXPECT_LT(sheet_of(1, 48, 24).width, 2 * 48);
  EXPECT_GE(sheet_of(3, 48, 24).width, 3 * 48);
}

TEST(ContactStrip, LargePicturesShrink) { EXPECT_LT(sheet_of(1, 1280, 720).width, 1280 * 2 / 3); }

}  // namespace
}  // namespace kerf
