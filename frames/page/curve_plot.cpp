#include "frames/page/curve_plot.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frames/page/axis.h"
#include "frames/page/gnuplot.h"
#include "frames/page/page.h"
#include "frames/page/plot_parts.h"
#include "frames/page/value_box.h"

namespace kerf {
namespace {

/// The looks of curves: colours, widths and markers. The last one is a dashed black reference.
constexpr std::size_t kCurveLooks = 8;

/// The axes of a curve plot, in pixels, y downwards.
struct CurveArea {
  double left = 62;
  double right = 518;
  double top = 32;
  double bottom = 204;
};
constexpr CurveArea kCurveArea;

bool is_drawn(const CurvePoint& point, const CurvePlot& plot) { return !plot.log_y || point.low > 0; }

Axis curve_axis(const CurvePlot& plot) {
  std::vector<double> values;
  for (const Curve& curve : plot.curves)
    for (const CurvePoint& point : curve.points)
      if (is_drawn(point, plot)) values.insert(values.end(), {point.low, point.high});
  return {values, plot.log_y};
}

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

/// SVG elements over a curve plot: strips that show a line and the values of all curves at their x while the
/// pointer is over them, and lead to the address of that x.
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

constexpr std::size_t kBetweenMarkers = 8;  ///< points, so that as many curves have places of their own

/// Thick lines lie under thin ones.
double width_of(std::size_t look) {
  constexpr std::array kWidths{4.5, 3.6, 2.9, 2.3, 1.8, 1.4, 1.1, 1.0};
  return kWidths[look % kWidths.size()];
}

int marker_of(std::size_t look) {
  constexpr std::array kMarkers{7, 5, 9, 11, 13, 6, 4, 1};
  return kMarkers[look % kMarkers.size()];
}

std::string curve_line(const CurvePoint& point) {
  return plot_number(point.x) + " " + plot_number(point.y) + " " + plot_number(point.low) + " " +
         plot_number(point.high) + "\n";
}

/// The points of a curve, and in a second block those with markers.
std::string curve_data(const Curve& curve, const std::string& name, const CurvePlot& plot) {
  std::string all;
  std::string marked;
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const CurvePoint& point = curve.points[k];
    if (!is_drawn(point, plot)) continue;
    all += curve_line(point);
    if (k % kBetweenMarkers == curve.look % kBetweenMarkers) marked += curve_line(point);
  }
  if (all.empty()) return "";
  return "$" + name + " << EOD\n" + all + "EOD\n$m" + name + " << EOD\n" + (marked.empty() ? all : marked) +
         "EOD\n";
}

std::string line_style(std::size_t look) {
  const bool is_reference = look % kCurveLooks == kCurveLooks - 1;
  return " lc rgb " + series_color(look) + " lw " + plot_number(width_of(look)) +
         (is_reference ? " dt (8,5)" : "");
}

}  // namespace

std::string curve_script(const CurvePlot& plot, const std::string& name) {
  std::string script = "reset\nset encoding utf8\n" + frame_script(plot.title, plot.x_label) +
                       "set title offset 0,-0.7\nset xlabel offset 0,0.7\n" +
                       "set xrange [0:" + plot_number(plot.x_end) + "]\nunset key\n" +
                       curve_axis(plot).script("y");
  std::string bands;
  std::string lines;
  for (std::size_t k = 0; k < plot.curves.size(); ++k) {
    const Curve& curve = plot.curves[k];
    const std::string block = name + std::to_string(k);
    const std::string data = curve_data(curve, block, plot);
    if (data.empty()) continue;
    script += data;
    bands += ", $" + block + " using 1:3:4 with filledcurves fs transparent solid 0.18 noborder lc rgb " +
             series_color(curve.look);
    lines += ", $" + block + " using 1:2 with lines" + line_style(curve.look) + ", $m" + block +
             " using 1:2 with points ps 0.75 pt " + std::to_string(marker_of(curve.look)) + " lc rgb " +
             series_color(curve.look);
  }
  const std::string all = bands + lines;
  return script + (all.empty() ? "plot 1/0\n" : "plot " + all.substr(2) + "\n");
}

std::string curve_legend_script(const std::vector<Curve>& curves) {
  std::string plots;
  for (const Curve& curve : curves)
    plots += (plots.empty() ? "plot " : ", ") + std::string("NaN title ") + in_quotes(curve.name) +
             " with linespoints" + line_style(curve.look) + " ps 0.9 pt " +
             std::to_string(marker_of(curve.look));
  return "reset\nset encoding utf8\nunset border\nunset tics\nset xrange [0:1]\nset yrange [0:1]\nset key at "
         "graph 0.5, graph 0.5 center center horizontal samplen 3 width 1\n" +
         plots + "\n";
}

std::string draw(const CurvePlot& plot, std::string_view id) {
  const std::string margins = "set lmargin" + at_pixel(kCurveArea.left, kCurvePlotWidth) + "\nset rmargin" +
                              at_pixel(kCurveArea.right, kCurvePlotWidth) + "\nset tmargin" +
                              at_pixel(kCurvePlotHeight - kCurveArea.top, kCurvePlotHeight) +
                              "\nset bmargin" +
                              at_pixel(kCurvePlotHeight - kCurveArea.bottom, kCurvePlotHeight) + "\n";
  std::string script = curve_script(plot, "c");
  script.insert(script.find("set encoding"), margins);
  std::string svg = run_gnuplot(script, kCurvePlotWidth, kCurvePlotHeight, id);
  const std::size_t end = svg.rfind("</svg>");
  return svg.insert(end, curve_values(plot));
}

std::string curve_swatch(std::size_t look) {
  constexpr std::array<const char*, 8> kShapes{
      "<circle cx=\"18\" cy=\"8\" r=\"4\"/>",
      "<rect x=\"14\" y=\"4\" width=\"8\" height=\"8\"/>",
      "<path d=\"M18 3L23 12H13Z\"/>",
      "<path d=\"M18 13L23 4H13Z\"/>",
      "<path d=\"M18 3L23 8L18 13L13 8Z\"/>",
      "<circle cx=\"18\" cy=\"8\" r=\"4\" fill=\"none\"/>",
      "<rect x=\"14\" y=\"4\" width=\"8\" height=\"8\" fill=\"none\"/>",
      "<path d=\"M14 8H22M18 4V12\"/>"};
  const std::string color = series_hex(look);
  const bool is_reference = look % kCurveLooks == kCurveLooks - 1;
  return "<svg width=\"36\" height=\"16\" fill=\"" + color + "\" stroke=\"" + color +
         "\"><path d=\"M0 8H36\" stroke-width=\"" + plot_number(width_of(look)) + "\"" +
         (is_reference ? " stroke-dasharray=\"8 5\"" : "") + "/>" + kShapes[look % kShapes.size()] + "</svg>";
}

}  // namespace kerf
