#include "viz/image/compare.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

void take_in(PixelComparison& result, int x, int y, const std::uint8_t* a, const std::uint8_t* b,
             std::size_t listed) {
  const PixelBounds pixel{x, y, x + 1, y + 1};
  PixelBounds& bounds = result.bounds;
  bounds = result.different == 0 ? pixel
                                 : PixelBounds{std::min(bounds.left, x), std::min(bounds.top, y),
                                               std::max(bounds.right, x + 1), std::max(bounds.bottom, y + 1)};
  ++result.different;
  for (int c = 0; c < 4; ++c) result.largest_step = std::max(result.largest_step, std::abs(a[c] - b[c]));
  if (result.first.size() >= listed) return;
  DifferentPixel& different = result.first.emplace_back(DifferentPixel{x, y, {}, {}});
  std::copy_n(a, 4, different.a.begin());
  std::copy_n(b, 4, different.b.begin());
}

}  // namespace

PixelComparison compare_pixels(const Image& a, const Image& b, std::size_t listed) {
  if (a.width != b.width || a.height != b.height) {
    throw std::invalid_argument("pictures of " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                                " and " + std::to_string(b.width) + "x" + std::to_string(b.height) +
                                " pixels cannot be compared");
  }
  PixelComparison result;
  if (a.rgba == b.rgba) return result;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const std::uint8_t* p = a.pixel(x, y);
      const std::uint8_t* q = b.pixel(x, y);
      if (!std::equal(p, p + 4, q)) take_in(result, x, y, p, q, listed);
    }
  }
  return result;
}

}  // namespace kerf
