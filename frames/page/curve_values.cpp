#include "frames/page/curve_values.h"

#include <map>
#include <utility>
#include <vector>

#include "frames/page/gnuplot.h"
#include "frames/page/page.h"
#include "frames/page/plot_parts.h"
#include "frames/page/value_box.h"

namespace kerf {
namespace {

/// The values at one x, by curve.
using Column = std::vector<std::pair<const Curve*, const CurvePoint*>>;

std::map<double, Column> columns_of(const CurvePlot& plot) {
  std::map<double, Column> columns;
  for (const Curve& curve : plot.curves)
    for (const CurvePoint& point : curve.points) columns[point.x].push_back({&curve, &point});
  return columns;
}

std::string box_at(const CurvePlot& plot, double x, const Column& column, double at) {
  std::vector<ValueLine> lines{{plot.x_label + " " + plot_number(x), ""}};
  for (const auto& [curve, point] : column)
    lines.push_back({curve->name + " " + value_with_spread(point->y, point->low, point->high, plot.unit),
                     series_hex(curve->look)});
  return value_box(lines, {at, kCurveArea.top, kCurvePlotWidth, kCurvePlotHeight});
}

std::string strip(double begin, double end, double at) {
  return "<rect class=\"strip\" x=\"" + svg_number(begin) + "\" y=\"" + svg_number(kCurveArea.top) +
         "\" width=\"" + svg_number(end - begin) + "\" height=\"" +
         svg_number(kCurveArea.bottom - kCurveArea.top) + "\"/><path d=\"M" + svg_number(at) + " " +
         svg_number(kCurveArea.top) + "V" + svg_number(kCurveArea.bottom) + "\"/>";
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
        "<g>" + strip(begin, end, places[k]) + box_at(plot, x, column, places[k]) + "</g>";
    elements += plot.links.empty() ? group + "\n"
                                   : "<a tabindex=\"-1\" href=\"" + escaped(plot.links + plot_number(x)) +
                                         "\">" + group + "</a>\n";
    ++k;
  }
  return elements + "</g>\n";
}

}  // namespace kerf
