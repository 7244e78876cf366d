#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kerf {

/// The typeface's file (DejaVu Sans Mono), compiled in.
std::span<const std::uint8_t> font_file();

/// A typeface of fixed pitch at one size, as coverage bitmaps in one texture. It holds Latin-1; other
/// characters are shown as '?'.
class Font {
 public:
  /// Where a character lies in the texture and how it sits on the line, in pixels.
  struct Glyph {
    int left = 0, top = 0, width = 0, height = 0;  ///< in the texture
    int dx = 0, dy = 0;                            ///< from the pen on the baseline to its corner
  };

  /// Throws std::runtime_error if the typeface cannot be read. `pixels`: height of a line's letters, 6 to
  /// 256.
  explicit Font(int pixels);

  [[nodiscard]] int advance() const { return advance_; }
  [[nodiscard]] int ascent() const { return ascent_; }
  [[nodiscard]] int line_height() const { return line_height_; }
  /// Width of UTF-8 text in pixels.
  [[nodiscard]] int width(std::string_view text) const;
  /// The letters that have room in so many pixels.
  [[nodiscard]] std::size_t letters(int width) const {
    return static_cast<std::size_t>(std::max(0, width / advance_));
  }
  [[nodiscard]] const Glyph& glyph(char32_t code) const;
  [[nodiscard]] const std::vector<std::uint8_t>& texture() const { return texture_; }
  [[nodiscard]] int texture_width() const { return texture_width_; }
  [[nodiscard]] int texture_height() const { return texture_height_; }

 private:
  static constexpr int kFirst = 32;
  static constexpr int kLast = 255;

  std::array<Glyph, kLast - kFirst + 1> glyphs_;
  std::vector<std::uint8_t> texture_;
  int texture_width_ = 0;
  int texture_height_ = 0;
  int advance_ = 0;
  int ascent_ = 0;
  int line_height_ = 0;
};

}  // namespace kerf
