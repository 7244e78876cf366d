#include "frames/page/curve_values.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include "frames/page/gnuplot.h"
#include "frames/page/page.h"
#include "frames/page/plot_parts.h"
#include "frames/page/short_number.h"

namespace kerf {
namespace {

constexpr double kLine = 15;  ///< pixels
constexpr double kBoxWidth = 245;

std::string pixels(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", x);
  return text.data();
}

/// The values at one x, by curve.
using Column = std::vector<std::pair<const Curve*, const CurvePoint*>>;

std::map<double, Column> columns_of(const CurvePlot& plot) {
  std::map<double, Column> columns;
  for (const Curve& curve : plot.curves)
    for (const CurvePoint& point : curve.points) columns[point.x].push_back({&curve, &point});
  return columns;
}

std::string value_line(const Curve& curve, const CurvePoint& point, const std::string& unit) {
  const std::string low = short_number(point.low);
  const std::string high = short_number(point.high);
  return curve.name + " " + short_number(point.y) + unit +
         (low == high ? "" : " (" + low + " to " + high + ")");
}

std::string text_line(double x, double y, const std::string& text, const std::string& attributes) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\"" + attributes + ">" + escaped(text) +
         "</text>";
}

std::string value_box(const CurvePlot& plot, double x, const Column& column, double at) {
  const double height = kLine * static_cast<double>(column.size() + 1) + 8;
  const bool fits_right = at + 10 + kBoxWidth < kCurvePlotWidth;
  const double left = fits_right ? at + 10 : at - 10 - kBoxWidth;
  const double top = std::max(2.0, std::min(kCurveArea.top, kCurvePlotHeight - 2 - height));
  std::string box = "<rect class=\"paper\" x=\"" + pixels(left) + "\" y=\"" + pixels(top) + "\" width=\"" +
                    pixels(kBoxWidth) + "\" height=\"" + pixels(height) + "\"/>";
  double y = top + kLine;
  box += text_line(left + 6, y, plot.x_label + " " + plot_number(x), "");
  for (const auto& [curve, point] : column) {
    y += kLine;
    const std::string quoted = series_color(curve->look);
    box += text_line(left + 6, y, value_line(*curve, *point, plot.unit),
                     " fill=\"" + quoted.substr(1, quoted.size() - 2) + "\"");
  }
  return box;
}

std::string strip(double begin, double end, double at) {
  return "<rect class=\"strip\" x=\"" + pixels(begin) + "\" y=\"" + pixels(kCurveArea.top) + "\" width=\"" +
         pixels(end - begin) + "\" height=\"" + pixels(kCurveArea.bottom - kCurveArea.top) +
         "\"/><path d=\"M" + pixels(at) + " " + pixels(kCurveArea.top) + "V" + pixels(kCurveArea.bottom) +
         "\"/>";
}

}  // namespace

std::string curve_values(const CurvePlot& plot) {
  const std::map<double, Column> columns = columns_of(plot);
  std::vector<double> places;
  for (const auto& column : columns)
    places.push_back(kCurveArea.left + column.first / plot.x_end * (kCurveArea.right - kCurveArea.left));
  std::string elements = "\n<g class=\"values\">\n";
  std::size_t k = 0;
  for (const auto& [x, column] : columns) {
    const double begin = k == 0 ? kCurveArea.left : (places[k - 1] + places[k]) / 2;
    const double end = k + 1 == places.size() ? kCurveArea.right : (places[k] + places[k + 1]) / 2;
    const std::string group =
        "<g>" + strip(begin, end, places[k]) + value_box(plot, x, column, places[k]) + "</g>";
    elements += plot.links.empty() ? group + "\n"
                                   : "<a tabindex=\"-1\" href=\"" + escaped(plot.links + plot_number(x)) +
                                         "\">" + group + "</a>\n";
    ++k;
  }
  return elements + "</g>\n";
}

}  // namespace kerf
