#include "tests/hard/report/canvas.h"

#include "viz/draw/letters.h"

namespace kerf::test {

Canvas::Canvas(int width, int height, Color ground) : image_(make_image(width, height)) {
  fill(0, 0, width, height, ground);
}

void Canvas::blend(int x, int y, Color color, int coverage) {
  if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
  std::uint8_t* pixel =
      image_.rgba.data() + static_cast<std::size_t>(y) * image_.stride() + 4 * static_cast<std::size_t>(x);
  const auto mixed = [coverage](std::uint8_t under, std::uint8_t over) {
    return static_cast<std::uint8_t>((under * (255 - coverage) + over * coverage + 127) / 255);
  };
  pixel[0] = mixed(pixel[0], color.r);
  pixel[1] = mixed(pixel[1], color.g);
  pixel[2] = mixed(pixel[2], color.b);
}

void Canvas::fill(int left, int top, int width, int height, Color color) {
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) blend(x, y, color, 255);
}

/// Calls `put(along, down, coverage)` for each pixel of the letters, counted from the line's upper left
/// corner.
template <class Put>
void Canvas::draw(const Font& font, std::string_view text, Put put) const {
  int pen = 0;
  for (const char32_t code : decode_utf8(text)) {
    const Font::Glyph& glyph = font.glyph(code);
    for (int y = 0; y < glyph.height; ++y) {
      for (int x = 0; x < glyph.width; ++x) {
        const int at = (glyph.top + y) * font.texture_width() + glyph.left + x;
        put(pen + glyph.dx + x, font.ascent() + glyph.dy + y, font.texture()[static_cast<std::size_t>(at)]);
      }
    }
    pen += font.advance();
  }
}

void Canvas::text(const Font& font, int left, int top, std::string_view text, Color color) {
  draw(font, text,
       [&](int along, int down, int coverage) { blend(left + along, top + down, color, coverage); });
}

void Canvas::text_upwards(const Font& font, int left, int bottom, std::string_view text, Color color) {
  draw(font, text,
       [&](int along, int down, int coverage) { blend(left + down, bottom - along, color, coverage); });
}

void Canvas::text_centered(const Font& font, int left, int top, int width, int height, std::string_view text,
                           Color color) {
  this->text(font, left + (width - font.width(text)) / 2, top + (height - font.line_height()) / 2, text,
             color);
}

}  // namespace kerf::test
