#pragma once

#include <string>
#include <vector>

namespace kerf {

/// A line of a box of values.
struct ValueLine {
  std::string text;
  std::string color;  ///< "#0072b2"; empty: that of text
};

/// The place of a thing on a picture, and the picture's size; pixels, y downwards.
struct ValuePlace {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

/// Pixels with one digit behind the point, for SVG.
std::string svg_number(double x);

/// "0.31 (0.29 to 0.35)"; without the spread if it cannot be seen in three digits.
std::string value_with_spread(double value, double low, double high, const std::string& unit);

/// SVG elements of a box with text beside a place, inside the picture. Page shows what is in a group of the
/// class "values" while the pointer is over that group's first element.
std::string value_box(const std::vector<ValueLine>& lines, const ValuePlace& place);

}  // namespace kerf
