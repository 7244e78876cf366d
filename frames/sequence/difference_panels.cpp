#include "frames/sequence/difference_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "viz/image/contact_sheet.h"

namespace kerf {
namespace {

/// A single differing pixel must survive being shrunk to a third and encoded as film.
constexpr int kSpread = 2;
/// From this many levels of a channel on, a difference is fully red: drawings over a background differ by
/// more, the tints of cells by less.
constexpr int kStrong = 192;
/// The smallest difference must still be visible.
constexpr double kLeastRed = 0.12;

/// For each pixel the largest difference of a channel.
std::vector<std::uint8_t> strengths(const Image& a, const Image& b) {
  std::vector<std::uint8_t> result(a.rgba.size() / 4);
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const auto step = static_cast<std::uint8_t>(std::abs(a.rgba[i] - b.rgba[i]));
    result[i / 4] = std::max(result[i / 4], step);
  }
  return result;
}

/// For each pixel the largest value within kSpread pixels along (dx, dy).
void spread(std::vector<std::uint8_t>& values, int width, int height, int dx, int dy) {
  const std::vector<std::uint8_t> old = values;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * width + x); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int k = -kSpread; k <= kSpread; ++k) {
        const int u = x + k * dx;
        const int v = y + k * dy;
        if (u >= 0 && u < width && v >= 0 && v < height)
          values[at(x, y)] = std::max(values[at(x, y)], old[at(u, v)]);
      }
    }
  }
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

/// The first picture, pale, and red over it: the redder, the stronger the difference.
Image difference(const Image& a, const Image& b, std::size_t& differing) {
  constexpr std::array<double, 3> kRed{214, 26, 60};
  Image result = pale(a);
  std::vector<std::uint8_t> strength = strengths(a, b);
  differing = strength.size() - static_cast<std::size_t>(std::ranges::count(strength, 0));
  spread(strength, a.width, a.height, 1, 0);
  spread(strength, a.width, a.height, 0, 1);
  for (std::size_t i = 0; i < strength.size(); ++i) {
    if (strength[i] == 0) continue;
    const double share = std::min(1.0, static_cast<double>(strength[i]) / kStrong);
    const double weight = kLeastRed + (1 - kLeastRed) * share * share;
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& value = result.rgba[4 * i + c];
      value = static_cast<std::uint8_t>(std::lround(value + weight * (kRed[c] - value)));
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
