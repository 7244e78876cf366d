#pragma once

#include <string>
#include <vector>

#include "frames/page/cell.h"
#include "frames/report/report_request.h"

namespace kerf {

/// A motion of `kerf bench`, with the measurements of all settings on it.
struct MotionCell {
  std::string motion;
  int dimension = 3;
  Cell cell;  ///< a list of rows: "setting", "family" and the figures of `run_course`
};

std::vector<MotionCell> motion_cells(const ReportSizes& sizes);
/// The cells alone.
std::vector<Cell> cells_of(const std::vector<MotionCell>& motions);

}  // namespace kerf
