#include "frames/difference_panels.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <stdexcept>

#include "viz/image/contact_sheet.h"

namespace kerf {
namespace {

/// A single differing pixel must survive being shrunk to a third and encoded as film.
constexpr int kSpread = 2;

bool differs(const Image& a, const Image& b, int x, int y) {
  return std::memcmp(a.pixel(x, y), b.pixel(x, y), 4) != 0;
}

void paint_around(Image& image, int x, int y) {
  constexpr std::array<std::uint8_t, 4> kRed{214, 26, 60, 255};
  for (int v = std::max(0, y - kSpread); v <= std::min(image.height - 1, y + kSpread); ++v)
    for (int u = std::max(0, x - kSpread); u <= std::min(image.width - 1, x + kSpread); ++u)
      std::ranges::copy(kRed, image.rgba.begin() + (image.pixel(u, v) - image.rgba.data()));
}

Image pale(const Image& image) {
  Image result = image;
  for (std::size_t i = 0; i < result.rgba.size(); i += 4) {
    const int grey = (image.rgba[i] + 2 * image.rgba[i + 1] + image.rgba[i + 2]) / 4;
    const auto light = static_cast<std::uint8_t>(255 - (255 - grey) / 3);
    result.rgba[i] = result.rgba[i + 1] = result.rgba[i + 2] = light;
  }
  return result;
}

Image difference(const Image& a, const Image& b, std::size_t& differing) {
  Image result = pale(a);
  differing = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      if (!differs(a, b, x, y)) continue;
      ++differing;
      paint_around(result, x, y);
    }
  }
  return result;
}

}  // namespace

Image difference_panels(const Image& a, const Image& b, int panel_width, std::size_t& differing) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("pictures of different sizes cannot be compared");
  const int width = std::min(panel_width, a.width);
  const int height = std::max(1, a.height * width / a.width);
  const std::array<Image, 3> panels{downscale(a, width, height), downscale(b, width, height),
                                    downscale(difference(a, b, differing), width, height)};
  return contact_sheet(panels, 3);
}

}  // namespace kerf
