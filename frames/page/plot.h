#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

/// What a value spreads over: an error bar of a point, a band of a line.
struct PlotRange {
  double low = 0;
  double high = 0;
};

struct PlotPoint {
  double x = 0;
  double y = 0;
  std::string label{};  ///< beside the point, if there is room; empty: none
  bool marked = false;  ///< with a ring: on the Pareto front
  std::string name{};   ///< under the pointer, before the values; empty: that of the series
  std::optional<PlotRange> x_range{};
  std::optional<PlotRange> y_range{};
};

enum class PlotStyle : std::uint8_t {
  points,
  joined,  ///< points, joined by a thin line
  line,
  dashed,  ///< a line
};

/// Points that belong together; one colour and one entry of the legend.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
  PlotStyle style = PlotStyle::points;
  int color = -1;  ///< which of the palette; -1: by its place in the list
};

/// A picture of points or lines. On a logarithmic axis zeros stand at the left or lower end, at a tick "0".
struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  std::vector<PlotSeries> series;
};

/// One horizontal bar a row.
struct BarPlot {
  struct Bar {
    std::string name;
    double value = 0;
    double most = 0;  ///< the end of an error bar from the value on; less than the value: none
  };
  std::string title;
  std::string x_label;
  std::vector<Bar> bars;
};

/// Cells of few kinds, each a colour, for example verdicts.
struct HeatMap {
  std::vector<std::string> columns;
  std::vector<std::string> rows;
  std::vector<std::vector<int>> kinds;  ///< by row and column, from 0
  std::vector<std::string> kind_names;
};

/// An SVG element, made by gnuplot, for a page in which `id` is unique. Throws std::runtime_error if gnuplot
/// fails.
std::string draw(const Plot& plot, std::string_view id);
std::string draw(const BarPlot& plot, std::string_view id);
std::string draw(const HeatMap& map, std::string_view id);

}  // namespace kerf
