#include "frames/sequence/difference_panels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf {
namespace {

constexpr int kSide = 40;

void fill(Image& image, int left, int top, int right, int bottom, std::uint8_t grey) {
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      std::fill_n(image.rgba.begin() + (image.pixel(x, y) - image.rgba.data()), 3, grey);
}

/// How much redder than green a pixel of the third panel is.
int redness(const Image& panels, int x, int y) {
  const int gap = panels.width - 3 * kSide;
  const std::uint8_t* pixel = panels.pixel(2 * kSide + gap + x, y);
  return pixel[0] - pixel[1];
}

TEST(DifferencePanels, AFaintTintLeavesWhatIsMissingToBeSeen) {
  const Image a = make_image(kSide, kSide);
  Image b = a;
  fill(b, 5, 5, 35, 35, 245);   // a cell tinted by 4 %
  fill(b, 20, 20, 21, 21, 20);  // and in it a dot
  std::size_t differing = 0;
  const Image panels = difference_panels(a, b, kSide, differing);
  EXPECT_EQ(differing, 30U * 30U);
  const int top = panels.height - kSide;
  int least = 255;
  int most = 0;
  for (int y = top; y < panels.height; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int red = redness(panels, x, y);
      most = std::max(most, red);
      if (red > 0) least = std::min(least, red);
    }
  }
  EXPECT_GT(least, 10);
  EXPECT_LT(least, 60);
  EXPECT_GT(most, 150);
}

TEST(DifferencePanels, SamePicturesAreNotRed) {
  const Image a = make_image(kSide, kSide, 0x808080ff);
  std::size_t differing = 1;
  const Image panels = difference_panels(a, a, kSide, differing);
  EXPECT_EQ(differing, 0U);
  for (int y = 0; y < panels.height; ++y)
    for (int x = 0; x < panels.width; ++x) EXPECT_EQ(panels.pixel(x, y)[0], panels.pixel(x, y)[1]);
}

}  // namespace
}  // namespace kerf
