#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kerf::test {

/// A PNG file of any kind, as other programs write them.
struct PngFile {
  std::uint32_t width = 16;
  std::uint32_t height = 16;
  std::uint8_t depth = 8;
  std::uint8_t color_type = 2;  ///< 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
  std::uint8_t interlace = 0;
  std::string rows;                                         ///< each begins with its filter, 0
  std::vector<std::pair<std::string, std::string>> before;  ///< chunks before the picture data
  std::vector<std::pair<std::string, std::string>> after;

  [[nodiscard]] std::string bytes() const;
};

/// `height` rows of `row`, without a filter.
std::string png_rows(const std::string& row, std::uint32_t height = 16);

/// A number as PNG files have it, of `bytes` bytes.
std::string big_endian(std::uint32_t number, int bytes = 4);

/// `text` so many times.
std::string repeat(const std::string& text, int times);

}  // namespace kerf::test
