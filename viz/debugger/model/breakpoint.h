#pragma once

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

/// A watched expression and its value.
struct WatchedValue {
  Expression expression;
  ConditionNumber value{};       ///< at this moment
  std::optional<Change> stop{};  ///< the run stops at such a change
  std::uint32_t hits = 0;        ///< times that it stopped the run
};

/// The next stop of a run, and its cause.
struct Stop {
  Position position;
  std::optional<std::size_t> breakpoint;
  std::optional<std::size_t> watch;
};

/// The next moment, in either direction, at which an enabled condition holds or a watched value changes as
/// required.
std::optional<Stop> next_stop(Run& run, const std::vector<Breakpoint>& breakpoints,
                              const std::vector<WatchedValue>& watches, bool forwards,
                              const Run::Progress& progress);

}  // namespace kerf
