#include "frames/page/value_box.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "frames/page/page.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr double kLineHeight = 15;
constexpr double kEdge = 6;
constexpr double kBeside = 10;

/// Of a text in pixels, about.
double text_width(const std::string& text) { return 6.0 * static_cast<double>(text.size()); }

}  // namespace

std::string svg_number(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", x);
  return text.data();
}

std::string value_with_spread(double value, double low, double high, const std::string& unit) {
  const std::string from = short_number(low);
  const std::string to = short_number(high);
  return short_number(value) + unit + (from == to ? "" : " (" + from + " to " + to + ")");
}

std::string value_box(const std::vector<ValueLine>& lines, const ValuePlace& place) {
  double width = 0;
  for (const ValueLine& line : lines) width = std::max(width, text_width(line.text) + 2 * kEdge);
  const double height = kLineHeight * static_cast<double>(lines.size()) + kEdge + 2;
  const bool fits_right = place.x + kBeside + width < place.width;
  const double left = std::max(1.0, fits_right ? place.x + kBeside : place.x - kBeside - width);
  const double top = std::max(2.0, std::min(place.y, place.height - 2 - height));
  std::string box = "<rect class=\"paper\" x=\"" + svg_number(left) + "\" y=\"" + svg_number(top) +
                    "\" width=\"" + svg_number(width) + "\" height=\"" + svg_number(height) + "\"/>";
  double y = top;
  for (const ValueLine& line : lines) {
    y += kLineHeight;
    box += "<text x=\"" + svg_number(left + kEdge) + "\" y=\"" + svg_number(y) + "\"" +
           (line.color.empty() ? "" : " fill=\"" + line.color + "\"") + ">" + escaped(line.text) + "</text>";
  }
  return box;
}

}  // namespace kerf
