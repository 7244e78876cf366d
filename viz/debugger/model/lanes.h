#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/recording/recording_info.h"
#include "viz/debugger/model/lane_pyramid.h"
#include "viz/debugger/model/time_window.h"

namespace kerf {

/// A curve over the steps of a run, under the scrubber.
class Lane {
 public:
  Lane() = default;
  /// Value k is of step k + 1. Values that are not finite are absent.
  Lane(std::string_view name, std::vector<float> values);

  [[nodiscard]] std::string_view name() const { return name_; }
  /// Absent before the first step, too.
  [[nodiscard]] std::optional<double> value(std::uint32_t step) const;
  /// Of a stretch of steps, both ends included.
  [[nodiscard]] LaneRange range(std::uint32_t first, std::uint32_t last) const;
  /// Without the absent ones.
  [[nodiscard]] double sum(std::uint32_t first, std::uint32_t last) const;
  /// The first steps with the least and the greatest value; 0 if all are absent.
  [[nodiscard]] std::uint32_t least_step() const { return least_step_; }
  [[nodiscard]] std::uint32_t greatest_step() const { return greatest_step_; }

  /// The value at which the lane's scale ends: the greatest one, or, where that would flatten everything
  /// else, the 99th percentile.
  [[nodiscard]] float scale_end(bool clips) const { return clips ? clipped_end_ : greatest_; }
  /// The steps above the 99th percentile if the scale ends there; else 0.
  [[nodiscard]] std::size_t above() const { return above_; }

  /// The least and greatest values where steps share a column of pixels, so that no peak is lost. Kept until
  /// the window changes.
  [[nodiscard]] const std::vector<LaneRange>& columns(const TimeWindow& window, std::size_t columns) const;

 private:
  void find_extremes();
  void find_outliers();

  std::string_view name_;
  std::vector<float> values_;
  LanePyramid pyramid_;
  std::vector<double> sums_;  ///< number k is of the first k values
  std::uint32_t least_step_ = 0;
  std::uint32_t greatest_step_ = 0;
  float greatest_ = 0;
  float clipped_end_ = 0;
  std::size_t above_ = 0;
  struct Columns {
    TimeWindow window;
    std::vector<LaneRange> ranges;
  };
  mutable std::array<Columns, 2> columns_;  ///< of the whole run, and of the part last seen
};

/// The lanes in their order.
enum class LaneOf : std::uint8_t { operators, pairs, height, redundancy, milliseconds, deferred };
constexpr std::size_t index_of(LaneOf lane) { return static_cast<std::size_t>(lane); }
inline constexpr std::size_t kLanesOfRun = index_of(LaneOf::deferred) + 1;

/// Operators that acted, pairs, height, redundancy (%), time (ms) and deferred events of each step.
std::vector<Lane> make_lanes(std::span<const StepRow> rows);

}  // namespace kerf
