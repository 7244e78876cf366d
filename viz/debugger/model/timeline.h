#pragma once

#include <optional>

#include "viz/debugger/model/event_kinds.h"
#include "viz/debugger/model/step_span.h"
#include "viz/debugger/model/time_window.h"

namespace kerf {

/// How the lanes show the run, and which part of it is selected.
struct Timeline {
  TimeWindow window;
  bool clips = true;                  ///< scales end at the 99th percentile where a lane has outliers
  std::size_t lane = 0;               ///< chosen: the minimap shows it, and keys go to its extremes
  std::optional<StepSpan> range;      ///< selected
  bool loops = false;                 ///< playing stays in the range
  EventKind kind = EventKind::split;  ///< chosen: what the user goes to next
};

}  // namespace kerf
