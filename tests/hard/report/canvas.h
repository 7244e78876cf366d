#pragma once

#include <string_view>

#include "viz/draw/color.h"
#include "viz/draw/font.h"
#include "viz/image/image.h"

namespace kerf::test {

/// Rectangles and letters on a picture in memory: enough for a table, without GL.
class Canvas {
 public:
  Canvas(int width, int height, Color ground);

  void fill(int left, int top, int width, int height, Color color);
  /// One line with its upper left corner at (left, top).
  void text(const Font& font, int left, int top, std::string_view text, Color color);
  /// One line that reads upwards; (left, bottom) is where it begins.
  void text_upwards(const Font& font, int left, int bottom, std::string_view text, Color color);
  /// One line in the middle of a rectangle.
  void text_centered(const Font& font, int left, int top, int width, int height, std::string_view text,
                     Color color);

  [[nodiscard]] const Image& image() const { return image_; }

 private:
  void blend(int x, int y, Color color, int coverage);
  template <class Put>
  void draw(const Font& font, std::string_view text, Put put) const;

  Image image_;
};

}  // namespace kerf::test
