#pragma once

#include <string>

#include "frames/page/axis.h"
#include "frames/page/curve_plot.h"

namespace kerf {

/// The looks of curves: colours, widths and markers. The last one is a dashed black reference.
inline constexpr std::size_t kCurveLooks = 8;

/// The axes of a curve plot, in pixels, y downwards.
struct CurveArea {
  double left = 62;
  double right = 518;
  double top = 32;
  double bottom = 204;
};
inline constexpr CurveArea kCurveArea;

/// Whether the plot's axis has a place for the point.
bool is_drawn(const CurvePoint& point, const CurvePlot& plot);
/// The upright axis of a plot.
Axis curve_axis(const CurvePlot& plot);

/// SVG elements over a curve plot: strips that show a line and the values of all curves at their x while the
/// pointer is over them, and lead to the address of that x.
std::string curve_values(const CurvePlot& plot);

}  // namespace kerf
