#pragma once

#include <string>
#include <string_view>

#include "frames/study/summary.h"

namespace kerf {

/// What a plot shows of the cells.
struct PlottedFigure {
  const char* key;  ///< in the counts or times of a cell
  const char* title;
  const char* unit;
  const char* caption;
};

/// A figure against the number of objects, a curve for each broad phase, with 95 % confidence intervals as
/// bars, which end at 0; of one number of objects, a row for each broad phase. An SVG element for a page in
/// which `id` is unique; empty if no group has the figure. Throws std::runtime_error if gnuplot fails.
std::string plot_figure(const StudyComparison& comparison, const PlottedFigure& figure, std::string_view id);

}  // namespace kerf
