#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/recording/recording_info.h"

namespace kerf {

/// A curve over the steps of a run, under the scrubber.
struct Lane {
  std::string_view name;
  std::vector<float> values;  ///< value k is of step k + 1
  float largest = 0;
};

/// Operators that acted, pairs, height, redundancy (%), time (ms) and deferred events of each step.
std::vector<Lane> make_lanes(std::span<const StepRow> rows);

/// The curve's least and greatest values where steps share a column of pixels, so that no peak is lost.
struct ColumnRange {
  float least = 0;
  float greatest = 0;
};
std::vector<ColumnRange> columns_of(const Lane& lane, std::size_t columns);

}  // namespace kerf
