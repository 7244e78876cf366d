#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

/// A picture: 8-bit RGBA, rows from the top down, no padding. `rgba.size() == 4 * width * height`.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;

  [[nodiscard]] std::size_t stride() const { return 4 * static_cast<std::size_t>(width); }
  [[nodiscard]] const std::uint8_t* pixel(int x, int y) const {
    return rgba.data() + static_cast<std::size_t>(y) * stride() + 4 * static_cast<std::size_t>(x);
  }
  friend bool operator==(const Image&, const Image&) = default;
};

/// A picture of one colour. Throws std::invalid_argument unless both sizes are positive.
Image make_image(int width, int height, std::uint32_t rgba = 0xffffffffU);

}  // namespace kerf
