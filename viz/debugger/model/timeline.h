#pragma once

#include "viz/debugger/model/time_window.h"

namespace kerf {

/// How the lanes show the run.
struct Timeline {
  TimeWindow window;
  bool clips = true;     ///< scales end at the 99th percentile where a lane has outliers
  std::size_t lane = 0;  ///< chosen: the minimap shows it, and keys go to its extremes
};

}  // namespace kerf
