#pragma once

#include <string>
#include <string_view>

namespace kerf::house {

struct Point {
  int x = 0;
  int y = 0;
};

/// A drawing of rounded boxes, text and arrows.
class Svg {
 public:
  Svg(int width, int height);

  void box(Point corner, int width, int height, std::string_view fill, std::string_view stroke);
  /// Text with its baseline at `at`. Style holds SVG attributes.
  void text(Point at, std::string_view words, std::string_view style);
  /// A straight arrow.
  void arrow(Point from, Point to);
  /// An arrow between two points of one vertical line, bent to the left by `bulge`.
  void arc(Point from, Point to, int bulge);

  /// The complete file.
  [[nodiscard]] std::string str() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace kerf::house
