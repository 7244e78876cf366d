#pragma once

#include <string>
#include <vector>

#include "frames/page/cell.h"
#include "frames/report/cell_store.h"
#include "frames/report/report_request.h"

namespace kerf {

/// A scene in which the pairs decide the motion, run from several seeds: a cell for each.
struct LoopScene {
  std::string scene;
  int dimension = 3;
  std::vector<Cell> seeds;  ///< results: see `run_closed_loops` in loop_cells.cpp
};

std::vector<LoopScene> loop_scenes(const ReportSizes& sizes);
std::vector<Cell> cells_of(const std::vector<LoopScene>& scenes);

/// One setting in all seeds of a scene.
struct LoopRuns {
  std::string setting;
  std::string family;
  std::vector<double> steps;  ///< after which runs were sampled
  std::vector<Json> seeds;    ///< its run in each seed
};

/// By setting, in their order: exact, the paper's, the control, and the approximate ones.
std::vector<LoopRuns> runs_by_setting(const LoopScene& scene, const CellStore& store);

}  // namespace kerf
