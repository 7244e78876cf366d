#include "viz/image/compare.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace kerf {
namespace {

void set(Image& image, int x, int y, int channel, std::uint8_t value) {
  image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + channel)] = value;
}

TEST(ComparePixels, EqualPicturesAreTheSame) {
  const Image image = make_image(5, 3, 0x102030ffU);
  const PixelComparison result = compare_pixels(image, image);
  EXPECT_TRUE(result.same());
  EXPECT_TRUE(result.bounds.empty());
  EXPECT_TRUE(result.first.empty());
}

TEST(ComparePixels, CountsBoundsAndListsWhatDiffers) {
  const Image a = make_image(9, 6, 0x102030ffU);
  Image b = a;
  set(b, 7, 1, 2, 0x2e);
  set(b, 2, 4, 0, 0x11);
  const PixelComparison result = compare_pixels(a, b);
  EXPECT_EQ(result.different, 2U);
  EXPECT_EQ(result.largest_step, 2);
  EXPECT_EQ(result.bounds, (PixelBounds{2, 1, 8, 5}));
  ASSERT_EQ(result.first.size(), 2U);
  EXPECT_EQ(result.first[0].x, 7);
  EXPECT_EQ(result.first[0].b[2], 0x2e);
  EXPECT_EQ(compare_pixels(a, b, 1).first.size(), 1U);
}

TEST(ComparePixels, OneBitOfTransparencyIsADifference) {
  const Image a = make_image(4, 4);
  Image b = a;
  set(b, 3, 3, 3, 254);
  EXPECT_EQ(compare_pixels(a, b).different, 1U);
}

TEST(ComparePixels, DifferentSizesAreRefused) {
  EXPECT_THROW(compare_pixels(make_image(4, 3), make_image(3, 4)), std::invalid_argument);
}

}  // namespace
}  // namespace kerf
