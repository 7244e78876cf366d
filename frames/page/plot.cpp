#include "frames/page/plot.h"

#include <algorithm>
#include <array>

#include "frames/page/axis.h"
#include "frames/page/gnuplot.h"
#include "frames/page/label_places.h"
#include "frames/page/plot_parts.h"
#include "frames/page/value_box.h"

namespace kerf {
namespace {

/// Of a plot of points, in pixels; the legend stands to the right of it.
constexpr int kWidth = 940;
constexpr int kHeight = 430;
constexpr double kLeft = 78;
constexpr double kRight = 640;
constexpr double kTop = 40;
constexpr double kBottom = 370;

std::size_t color_number(const PlotSeries& series, std::size_t place) {
  return series.color >= 0 ? static_cast<std::size_t>(series.color) : place;
}

std::string color_of(const PlotSeries& series, std::size_t place) {
  return series_color(color_number(series, place));
}

std::string margins_script() {
  return "set lmargin" + at_pixel(kLeft, kWidth) + "\nset rmargin" + at_pixel(kRight, kWidth) +
         "\nset tmargin" + at_pixel(kHeight - kTop, kHeight) + "\nset bmargin" +
         at_pixel(kHeight - kBottom, kHeight) +
         "\nset key at screen 0.70, graph 1 left top Left reverse samplen 2 spacing 1.15\n";
}

std::vector<double> values_of(const Plot& plot, double PlotPoint::*coordinate,
                              std::optional<PlotRange> PlotPoint::*range) {
  std::vector<double> values;
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& point : series.points) {
      values.push_back(point.*coordinate);
      if (point.*range) values.insert(values.end(), {(point.*range)->low, (point.*range)->high});
    }
  return values;
}

struct Axes {
  Axis x;
  Axis y;
};

LabelWish on_picture(const PlotPoint& point, const Axes& axes) {
  return {kLeft + axes.x.share(point.x) * (kRight - kLeft),
          kBottom - axes.y.share(point.y) * (kBottom - kTop), point.label};
}

bool is_line(const PlotSeries& series) {
  return series.style == PlotStyle::line || series.style == PlotStyle::dashed;
}

std::string labels_script(const Plot& plot, const Axes& axes) {
  std::vector<LabelWish> wishes;
  std::vector<LabelWish> others;
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& point : series.points) {
      if (is_line(series)) continue;
      (point.label.empty() ? others : wishes).push_back(on_picture(point, axes));
    }
  const auto places = place_labels(wishes, others, kLeft, kRight);
  std::string script;
  for (std::size_t k = 0; k < wishes.size(); ++k)
    if (places[k])
      script += "set label " + in_quotes(wishes[k].text) + at_pixel(places[k]->x, kWidth) + ", screen " +
                plot_number(1 - places[k]->y / kHeight) + " left font ',11' front\n";
  return script;
}

std::string data_block(const std::string& name, const PlotSeries& series, const Axes& axes,
                       bool only_marked) {
  std::string block = "$" + name + " << EOD\n";
  for (const PlotPoint& point : series.points)
    if (!only_marked || point.marked)
      block += plot_number(axes.x.place(point.x)) + " " + plot_number(axes.y.place(point.y)) + "\n";
  return block + "EOD\n";
}

std::string style(const PlotSeries& series, std::size_t place) {
  constexpr std::array kMarkers{7, 5, 9, 11, 13, 4, 6, 8, 10, 12};
  const std::string color = " lc rgb " + color_of(series, place);
  if (is_line(series))
    return " with lines lw 2" + std::string(series.style == PlotStyle::dashed ? " dt 2" : "") + color;
  return std::string(" with ") + (series.style == PlotStyle::joined ? "linespoints" : "points") +
         " lw 1 ps 0.8 pt " + std::to_string(kMarkers[place % kMarkers.size()]) + color;
}

bool has_range(const PlotPoint& point) { return point.x_range || point.y_range; }

/// Lines of "x y low-x high-x low-y high-y", of the points that spread; of a line, of all.
std::string range_block(const std::string& name, const PlotSeries& series, const Axes& axes) {
  std::string block = "$" + name + " << EOD\n";
  for (const PlotPoint& point : series.points) {
    if (!has_range(point) && !is_line(series)) continue;
    const PlotRange x = point.x_range.value_or(PlotRange{point.x, point.x});
    const PlotRange y = point.y_range.value_or(PlotRange{point.y, point.y});
    for (const double at : {point.x, x.low, x.high}) block += plot_number(axes.x.place(at)) + " ";
    for (const double at : {point.y, y.low, y.high}) block += plot_number(axes.y.place(at)) + " ";
    block += "\n";
  }
  return block + "EOD\n";
}

/// Error bars of points, a band of a line.
std::string range_plot(const std::string& name, const PlotSeries& series, std::size_t place) {
  const std::string color = " lc rgb " + color_of(series, place) + " notitle";
  if (is_line(series))
    return "$" + name + " using 1:5:6 with filledcurves fs transparent solid 0.12 noborder" + color;
  return "$" + name + " using 1:4:2:3:5:6 with xyerrorbars ps 0 lw 1" + color;
}

bool has_ranges(const PlotSeries& series) {
  return std::any_of(series.points.begin(), series.points.end(), has_range);
}

/// Elements over the picture that show a point's values while the pointer is over it.
std::string point_values(const Plot& plot, const Axes& axes) {
  std::string elements = "\n<g class=\"values\">\n";
  for (std::size_t k = 0; k < plot.series.size(); ++k)
    for (const PlotPoint& point : plot.series[k].points) {
      const LabelWish at = on_picture(point, axes);
      const PlotRange x = point.x_range.value_or(PlotRange{point.x, point.x});
      const PlotRange y = point.y_range.value_or(PlotRange{point.y, point.y});
      const std::vector<ValueLine> lines{
          {point.name.empty() ? plot.series[k].name : point.name,
           series_hex(color_number(plot.series[k], k))},
          {plot.x_label + ": " + value_with_spread(point.x, x.low, x.high, ""), ""},
          {plot.y_label + ": " + value_with_spread(point.y, y.low, y.high, ""), ""}};
      elements += "<g><circle class=\"strip\" r=\"6\" cx=\"" + svg_number(at.x) + "\" cy=\"" +
                  svg_number(at.y) + "\"/>" + value_box(lines, {at.x, at.y, kWidth, kHeight}) + "</g>\n";
    }
  return elements + "</g>\n";
}

bool has_marks(const PlotSeries& series) {
  return std::any_of(series.points.begin(), series.points.end(),
                     [](const PlotPoint& point) { return point.marked; });
}

}  // namespace

std::string draw(const Plot& plot, std::string_view id) {
  const Axes axes{Axis(values_of(plot, &PlotPoint::x, &PlotPoint::x_range), plot.log_x),
                  Axis(values_of(plot, &PlotPoint::y, &PlotPoint::y_range), plot.log_y)};
  std::string script = frame_script(plot.title, plot.x_label) + "set ylabel " + in_quotes(plot.y_label) +
                       "\n" + margins_script() + axes.x.script("x") + axes.y.script("y") +
                       labels_script(plot, axes);
  std::string ranges;
  std::string what;
  std::string rings;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    if (series.points.empty()) continue;
    const std::string name = "s" + std::to_string(k);
    script += data_block(name, series, axes, false);
    if (has_ranges(series)) {
      script += range_block("r" + name, series, axes);
      ranges += range_plot("r" + name, series, k) + ", ";
    }
    what += (what.empty() ? "$" : ", $") + name + " title " + in_quotes(series.name) + style(series, k);
    if (!has_marks(series)) continue;
    script += data_block("m" + name, series, axes, true);
    rings += ", $m" + name + (rings.empty() ? " title 'Pareto front'" : " notitle") +
             " with points pt 6 ps 1.7 lw 1.5 lc rgb '#141414'";
  }
  std::string svg = run_gnuplot(script + "plot " + ranges + what + rings, kWidth, kHeight, id);
  return svg.insert(svg.rfind("</svg>"), point_values(plot, axes));
}

}  // namespace kerf
