#pragma once

#include <string>
#include <vector>

#include "frames/report/section.h"
#include "frames/report/trade.h"

namespace kerf {

/// Motions of `kerf bench`, with the measurements of all settings on them: lists of rows with "setting",
/// "family" and the figures of `run_course`.
std::vector<SceneCell> motion_cells(const ReportSizes& sizes);

/// How a section shows such a list.
struct MotionView {
  const char* section;  ///< names of its plots begin with it
  const char* against;  ///< "missed pairs", in the titles of plots
  const char* caption;  ///< behind what was measured
  const Trade& trade;
  const std::vector<TableColumn>& columns;
};
/// A plot and a table for each motion.
void write_motions(const std::vector<SceneCell>& motions, const CellStore& store, const MotionView& view,
                   Page& page);

}  // namespace kerf
