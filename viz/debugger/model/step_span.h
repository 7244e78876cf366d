#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "viz/debugger/model/lanes.h"

namespace kerf {

/// Steps from the first to the last, both included.
struct StepSpan {
  std::uint32_t first = 1;
  std::uint32_t last = 1;

  [[nodiscard]] std::uint32_t count() const { return last - first + 1; }
  friend bool operator==(const StepSpan&, const StepSpan&) = default;
};

/// The steps that two times, in any order, touch or lie around; one at least. The run must not be empty.
StepSpan steps_between(double a, double b, std::uint32_t steps);

/// What happened in some steps.
struct SpanFigures {
  StepSpan steps;
  std::array<std::uint64_t, kOperatorCount> operators{};  ///< acted, by kind
  LaneRange pairs;
  LaneRange height;
  LaneRange redundancy;  ///< in percent
  double seconds = 0;    ///< of the broad phase, summed up
};

/// Found without reading each of the steps. `lanes` are those of `make_lanes`, `rows` the run's.
SpanFigures figures_of(const StepSpan& steps, std::span<const StepRow> rows, const std::vector<Lane>& lanes);
/// "60 steps: 12 split, 4 merge; pairs 120 to 340; height 3 to 5; ...; steps 10 to 69"
std::string to_text(const SpanFigures& figures, const GivenNames& names);

}  // namespace kerf
