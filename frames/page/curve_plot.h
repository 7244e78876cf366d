#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace kerf {

/// A point of a curve, with the spread of what it stands for.
struct CurvePoint {
  double x = 0;
  double y = 0;
  double low = 0;
  double high = 0;
};

/// A line with a band around it.
struct Curve {
  std::string name;
  std::size_t look = 0;  ///< which colour, marker and width; see curve_swatch()
  std::vector<CurvePoint> points;
};

/// Curves over a common x, to be drawn side by side with others that have the same legend. On a logarithmic
/// axis points at or below zero are left out.
struct CurvePlot {
  std::string title;
  std::string x_label;
  bool log_y = false;
  double x_end = 1;   ///< the axis begins at 0
  std::string unit;   ///< behind values: " ms"
  std::string links;  ///< the address of a point, to which its x is added; empty: none
  std::vector<Curve> curves;
};

inline constexpr int kCurvePlotWidth = 540;
inline constexpr int kCurvePlotHeight = 250;

/// gnuplot's commands for the plot, without terminal, margins and legend. Names of data blocks begin with
/// `name`. Curves with higher looks are thinner and lie above, and markers stand at places of their own, so
/// that curves are seen that lie on each other.
std::string curve_script(const CurvePlot& plot, const std::string& name);
/// gnuplot's commands for the legend of such curves, above the plot that follows.
std::string curve_legend_script(const std::vector<Curve>& curves);

/// An SVG element, made by gnuplot, for a page in which `id` is unique: under the pointer it shows the values
/// of all curves, without a script (Page has the style). Throws std::runtime_error if gnuplot fails.
std::string draw(const CurvePlot& plot, std::string_view id);

/// A line and a marker of that look, as an SVG element for a legend in HTML.
std::string curve_swatch(std::size_t look);

}  // namespace kerf
