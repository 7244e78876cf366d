#include "viz/draw/font.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "viz/draw/letters.h"

// The only user of stb_truetype: the implementation lives here.
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace kerf {

Font::Font(int pixels) {
  stbtt_fontinfo info;
  if (stbtt_InitFont(&info, font_file().data(), 0) == 0)
    throw std::runtime_error("the typeface cannot be read");
  const float scale = stbtt_ScaleForPixelHeight(&info, static_cast<float>(pixels));
  int ascent = 0;
  int descent = 0;
  int gap = 0;
  stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
  int advance = 0;
  int bearing = 0;
  stbtt_GetCodepointHMetrics(&info, 'M', &advance, &bearing);
  const auto rounded = [scale](int units) {
    return static_cast<int>(std::lround(static_cast<float>(units) * scale));
  };
  advance_ = rounded(advance);
  ascent_ = rounded(ascent);
  line_height_ = pixels + std::max(2, pixels / 5);

  constexpr int kColumns = 16;
  const int cell = pixels + 4;
  texture_width_ = kColumns * cell;
  texture_height_ = (static_cast<int>(glyphs_.size()) / kColumns) * cell;
  texture_.assign(static_cast<std::size_t>(texture_width_) * static_cast<std::size_t>(texture_height_), 0);
  for (int i = 0; i < static_cast<int>(glyphs_.size()); ++i) {
    Glyph& glyph = glyphs_[static_cast<std::size_t>(i)];
    int right = 0;
    int bottom = 0;
    stbtt_GetCodepointBitmapBox(&info, kFirst + i, scale, scale, &glyph.dx, &glyph.dy, &right, &bottom);
    glyph.left = i % kColumns * cell;
    glyph.top = i / kColumns * cell;
    glyph.width = std::min(right - glyph.dx, cell);
    glyph.height = std::min(bottom - glyph.dy, cell);
    std::uint8_t* target = texture_.data() + glyph.top * texture_width_ + glyph.left;
    stbtt_MakeCodepointBitmap(&info, target, glyph.width, glyph.height, texture_width_, scale, scale,
                              kFirst + i);
  }
}

int Font::width(std::string_view text) const { return static_cast<int>(count_letters(text)) * advance_; }

const Font::Glyph& Font::glyph(char32_t code) const {
  const bool known = code >= kFirst && code <= kLast;
  return glyphs_[static_cast<std::size_t>((known ? code : U'?') - kFirst)];
}

}  // namespace kerf
