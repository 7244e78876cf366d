#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/query/expression.h"
#include "viz/debugger/model/run.h"

namespace kerf {

/// A condition at which a run stops, or an expression whose value is watched.
struct Breakpoint {
  Expression condition;
  bool enabled = true;     ///< the run stops where it holds
  std::uint32_t hits = 0;  ///< times that it stopped the run
};

struct WatchedValue {
  Expression expression;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< at this moment
};

/// Where a run stops next, and for which condition.
struct Stop {
  Position position;
  std::size_t breakpoint = 0;
};

/// The next moment, either way, at which one of the enabled conditions holds.
std::optional<Stop> next_stop(Run& run, const std::vector<Breakpoint>& breakpoints, bool forwards,
                              const Run::Progress& progress);

}  // namespace kerf
