#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/query/expression.h"
#include "viz/debugger/model/run.h"

namespace kerf {

/// A condition at which a run stops.
struct Breakpoint {
  Expression condition;
  bool enabled = true;
  std::uint32_t hits = 0;  ///< times that it stopped the run
};

/// An expression whose value is watched.
struct WatchedValue {
  Expression expression;
  double value = std::numeric_limits<double>::quiet_NaN();  ///< at this moment
  std::optional<Change> stop{};                             ///< the run stops when it changes so
  std::uint32_t hits = 0;                                   ///< times that it stopped the run
};

/// Where a run stops next, and because of which of the two.
struct Stop {
  Position position;
  std::optional<std::size_t> breakpoint;
  std::optional<std::size_t> watch;
};

/// The next moment, either way, at which an enabled condition holds or a watched value changes as it should.
std::optional<Stop> next_stop(Run& run, const std::vector<Breakpoint>& breakpoints,
                              const std::vector<WatchedValue>& watches, bool forwards,
                              const Run::Progress& progress);

}  // namespace kerf
