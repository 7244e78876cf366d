#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "viz/image/image.h"

namespace kerf {

/// Pixels from (left, top) up to, not including, (right, bottom).
struct PixelBounds {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  [[nodiscard]] bool empty() const { return left >= right || top >= bottom; }
  friend bool operator==(const PixelBounds&, const PixelBounds&) = default;
};

struct DifferentPixel {
  int x = 0;
  int y = 0;
  std::array<std::uint8_t, 4> a{};
  std::array<std::uint8_t, 4> b{};
};

/// The pixels in which two pictures differ.
struct PixelComparison {
  std::uint64_t different = 0;        ///< pixels
  int largest_step = 0;               ///< of one channel, 0 to 255
  PixelBounds bounds;                 ///< of the pixels that differ
  std::vector<DifferentPixel> first;  ///< the first in reading order
  [[nodiscard]] bool same() const { return different == 0; }
};

/// Compares every channel of every pixel, and lists the first `listed` that differ. Throws
/// std::invalid_argument if the sizes differ.
PixelComparison compare_pixels(const Image& a, const Image& b, std::size_t listed = 8);

}  // namespace kerf
