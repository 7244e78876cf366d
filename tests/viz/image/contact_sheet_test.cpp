#include "viz/image/contact_sheet.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace kerf {
namespace {

std::uint32_t color_at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return std::uint32_t{p[0]} << 24U | std::uint32_t{p[1]} << 16U | std::uint32_t{p[2]} << 8U | p[3];
}

TEST(Downscale, AveragesAndRounds) {
  Image image = make_image(4, 2, 0x000000ff);
  for (int x = 0; x < 2; ++x)
    image.rgba[static_cast<std::size_t>(4 * x)] = 255;  // two of four pixels are red
  const Image half = downscale(image, 2, 1);
  EXPECT_EQ(color_at(half, 0, 0), 0x800000ffU);
  EXPECT_EQ(color_at(half, 1, 0), 0x000000ffU);
}

TEST(Downscale, EveryPixelCountsOnceAtOddSizes) {
  Image image = make_image(7, 5, 0x000000ff);
  image.rgba[4 * (2 * 7 + 3)] = 200;
  const Image one = downscale(image, 1, 1);
  EXPECT_EQ(one.rgba[0], (200 + 17) / 35);
  EXPECT_EQ(downscale(image, 7, 5), image);
}

TEST(Downscale, RefusesWhatIsNoShrinking) {
  const Image image = make_image(4, 4);
  EXPECT_THROW(downscale(image, 0, 1), std::invalid_argument);
  EXPECT_THROW(downscale(image, 5, 4), std::invalid_argument);
}

TEST(ContactSheet, KeepsOrderRowByRow) {
  const std::vector<Image> thumbs{make_image(6, 3, 0x110000ff), make_image(6, 3, 0x220000ff),
                                  make_image(6, 3, 0x330000ff)};
  const Image sheet = contact_sheet(thumbs, 2);
  EXPECT_EQ(sheet.width, 2 * 6 + 3 * 4);
  EXPECT_EQ(sheet.height, 2 * 3 + 3 * 4);
  EXPECT_EQ(color_at(sheet, 4, 4), 0x110000ffU);
  EXPECT_EQ(color_at(sheet, 14, 4), 0x220000ffU);
  EXPECT_EQ(color_at(sheet, 4, 11), 0x330000ffU);
  EXPECT_EQ(color_at(sheet, 14, 11), 0xffffffffU);
}

TEST(ContactSheet, HasNoEmptyColumns) {
  EXPECT_EQ(contact_sheet(std::vector<Image>{make_image(6, 3)}, 10).width, 6 + 2 * 4);
}

TEST(ContactSheet, RefusesNothingAndUnequalSizes) {
  EXPECT_THROW(contact_sheet({}, 3), std::invalid_argument);
  EXPECT_THROW(contact_sheet(std::vector<Image>{make_image(2, 2)}, 0), std::invalid_argument);
  EXPECT_THROW(contact_sheet(std::vector<Image>{make_image(2, 2), make_image(2, 3)}, 2),
               std::invalid_argument);
}

}  // namespace
}  // namespace kerf
