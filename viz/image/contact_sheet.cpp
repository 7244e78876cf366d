#include "viz/image/contact_sheet.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace kerf {
namespace {

constexpr int kMargin = 4;

std::string size_text(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

/// First source pixel of target pixel `i`.
int first_source(int i, int source, int target) {
  return static_cast<int>(static_cast<std::int64_t>(i) * source / target);
}

/// Mean colour of a rectangle of pixels, rounded to nearest.
std::array<std::uint8_t, 4> mean(const Image& image, int x0, int x1, int y0, int y1) {
  std::array<std::uint64_t, 4> sum{};
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const std::uint8_t* pixel = image.pixel(x, y);
      for (std::size_t c = 0; c < 4; ++c) sum[c] += pixel[c];
    }
  }
  const auto count = static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
  std::array<std::uint8_t, 4> result{};
  for (std::size_t c = 0; c < 4; ++c) result[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
  return result;
}

}  // namespace

Image downscale(const Image& image, int width, int height) {
  if (width < 1 || height < 1 || width > image.width || height > image.height) {
    throw std::invalid_argument("cannot shrink an image of " + size_text(image) + " to " +
                                std::to_string(width) + "x" + std::to_string(height));
  }
  Image result = make_image(width, height);
  auto target = result.rgba.begin();
  for (int y = 0; y < height; ++y) {
    const int y0 = first_source(y, image.height, height);
    const int y1 = first_source(y + 1, image.height, height);
    for (int x = 0; x < width; ++x) {
      const int x0 = first_source(x, image.width, width);
      const int x1 = first_source(x + 1, image.width, width);
      target = std::ranges::copy(mean(image, x0, x1, y0, y1), target).out;
    }
  }
  return result;
}

Image contact_sheet(std::span<const Image> thumbs, int columns) {
  if (thumbs.empty()) throw std::invalid_argument("a contact sheet needs at least one picture");
  if (columns < 1) throw std::invalid_argument("a contact sheet needs at least one column");
  const Image& first = thumbs.front();
  const int used = std::min(columns, static_cast<int>(thumbs.size()));
  const int rows = (static_cast<int>(thumbs.size()) + used - 1) / used;
  Image sheet =
      make_image(kMargin + used * (first.width + kMargin), kMargin + rows * (first.height + kMargin));
  int index = 0;
  for (const Image& thumb : thumbs) {
    if (thumb.width != first.width || thumb.height != first.height) {
      throw std::invalid_argument("a contact sheet needs pictures of one size, got " + size_text(first) +
                                  " and " + size_text(thumb));
    }
    const int left = kMargin + index % used * (first.width + kMargin);
    const int top = kMargin + index / used * (first.height + kMargin);
    for (int y = 0; y < thumb.height; ++y) {
      std::copy_n(thumb.pixel(0, y), thumb.stride(),
                  sheet.rgba.data() + (sheet.pixel(left, top + y) - sheet.rgba.data()));
    }
    ++index;
  }
  return sheet;
}

}  // namespace kerf
